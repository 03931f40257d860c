#ifndef ARGOS3_CORE_UTILITY_PROCESSES_FORK_COUNT_H
#define ARGOS3_CORE_UTILITY_PROCESSES_FORK_COUNT_H

#include <cstdint>

namespace argos {

/**
 * How many calls of fork() are between the first process that called this function and this one.
 * What has threads notes the number when they start: a child has another number, and none of the
 * threads. Any thread.
 */
std::uint32_t CountForks();

}  // namespace argos

#endif
