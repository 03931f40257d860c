#ifndef ARGOS3_TESTING_SUPPORT_CAPTURED_LOGS_H
#define ARGOS3_TESTING_SUPPORT_CAPTURED_LOGS_H

#include <string>

namespace argos {

/*
 * A test program that links captured_logs.cpp keeps the logs to itself: while a test case runs, LOG
 * and LOGERR are collected instead of printed. What a test case leaves in LOGERR without having
 * taken it is unexpected: it is printed, and the program fails.
 */

/** What was logged since the last call, or since the test case began. Colours are off. */
std::string TakeLog();
/** The same for LOGERR. */
std::string TakeLogErr();

}  // namespace argos

#endif
