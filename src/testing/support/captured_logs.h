#ifndef ARGOS3_TESTING_SUPPORT_CAPTURED_LOGS_H
#define ARGOS3_TESTING_SUPPORT_CAPTURED_LOGS_H

#include <string>

namespace argos {

/*
 * A test program that links captured_logs.cpp captures the logs: during a test case LOG and LOGERR
 * are collected instead of printed. Output to LOGERR that a test case has not taken is unexpected:
 * it is printed, and the program fails.
 */

/** Log output since the last call, or since the start of the test case, without colours. */
std::string TakeLog();
/** As TakeLog(), for LOGERR; without lines about the run, and warnings of bodies outside of the
 * arena. */
std::string TakeLogErr();

}  // namespace argos

#endif
