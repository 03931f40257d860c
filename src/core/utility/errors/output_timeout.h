#ifndef ARGOS3_CORE_UTILITY_ERRORS_OUTPUT_TIMEOUT_H
#define ARGOS3_CORE_UTILITY_ERRORS_OUTPUT_TIMEOUT_H

#include <chrono>
#include <string>

namespace argos {

/**
 * How long an output may make no progress before that is an error: a FIFO without a reader, or a
 * program that reads pictures and does nothing.
 *
 * The environment variable ARGOS_OUTPUT_TIMEOUT, s, from 0.1 to 1e6; 30 if it is not set or no such
 * number.
 */
std::chrono::milliseconds GetOutputTimeout();

/** "30 s (ARGOS_OUTPUT_TIMEOUT)". */
std::string DescribeOutputTimeout();

}  // namespace argos

#endif
