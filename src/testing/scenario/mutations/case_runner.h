#ifndef ARGOS3_TESTING_SCENARIO_MUTATIONS_CASE_RUNNER_H
#define ARGOS3_TESTING_SCENARIO_MUTATIONS_CASE_RUNNER_H

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace argos {

/** How the loading of a case, and its first ticks, have ended. */
enum class EOutcome {
  Loaded,
  ErrorWithPlace,  // a CARGoSException with file and line
  ErrorWithoutPlace,
  RunError,  // a CARGoSException in a tick
  // the others are failures
  OtherException,
  NotFinite,  // loaded, but a pose is not finite after the ticks
  Crash,
  Timeout,
  TooMuchMemory
};

const char* ToText(EOutcome outcome);

/** @return true for the outcomes after which the user knows what to do. */
bool IsAccepted(EOutcome outcome);

struct SCaseResult {
  EOutcome Outcome = EOutcome::Crash;
  std::string Text; /**< of the exception, or the end of what a crashed process has printed */
};

/** Limits of one case. */
struct SCaseLimits {
  int Seconds = 20;
  std::size_t Megabytes = 3000; /**< resident */
};

/**
 * Loads cases in child processes and runs some ticks of each.
 * @param folder   working folder of the children.
 * @param getCase  text of the experiment file of a number; called in the child processes.
 */
std::vector<SCaseResult> RunCases(std::size_t number,
                                  const std::function<std::string(std::size_t)>& getCase,
                                  const std::string& folder, const SCaseLimits& limits = {});

}  // namespace argos

#endif
