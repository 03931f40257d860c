#ifndef ARGOS3_RUN_RUN_STATUS_H
#define ARGOS3_RUN_RUN_STATUS_H

#include <string>

namespace argos {

/** How a run ended. */
enum class ERunStatus {
  Done,
  RobotsStopped, /**< done, but errors stopped robots (EOnError) */
  Failed, /**< an error ended it */
  Crashed, /**< a signal ended its process */
  TimedOut, /**< the limit of wall time */
  OutOfMemory, /**< the limit of memory */
  Interrupted /**< the user or the system (SIGINT, SIGTERM, ...) has interrupted it */
};

/** @return the word in databases and tables: "done", "robots_stopped", "failed", ... */
const char* ToText(ERunStatus status);
/** @throws CARGoSException if there is no such status. */
ERunStatus ToRunStatus(const std::string& text);

/**
 * The exit status of a program that has executed the run.
 * @param signal  the number of the signal for Crashed and Interrupted.
 * @return 0: done; 3: errors stopped robots; 128 + signal, as shells have it; 1: otherwise.
 */
constexpr int ToExitStatus(ERunStatus status, int signal = 0) {
  switch (status) {
    case ERunStatus::Done:
      return 0;
    case ERunStatus::RobotsStopped:
      return 3;
    case ERunStatus::Crashed:
    case ERunStatus::Interrupted:
      return 128 + signal;
    default:
      return 1;
  }
}

}  // namespace argos

#endif
