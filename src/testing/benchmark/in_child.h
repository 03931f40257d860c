#ifndef ARGOS3_TESTING_BENCHMARK_IN_CHILD_H
#define ARGOS3_TESTING_BENCHMARK_IN_CHILD_H

#include <chrono>
#include <functional>

namespace argos::testing {

using TBenchmarkClock = std::chrono::steady_clock;

/** @return s. */
double SecondsSince(TBenchmarkClock::time_point start);
/** @return processor time of this thread, s: other programs disturb it less than the clock. */
double SecondsOfThisThread();

/**
 * Calls a function in a process of its own, with all libraries loaded and log output discarded; an
 * exception is printed there.
 * @return false if it failed.
 */
bool RunInChild(const std::function<void()>& measure);

}  // namespace argos::testing

#endif
