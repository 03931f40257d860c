#ifndef ARGOS3_CAMPAIGN_EXECUTION_RUN_RESULT_H
#define ARGOS3_CAMPAIGN_EXECUTION_RUN_RESULT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <vector>

namespace argos {

/** How a run ended. */
enum class ERunStatus {
  Done,
  RobotsStopped, /**< done, but errors stopped robots (exit status 3 of argos3) */
  Failed, /**< an error ended it: exit status not 0 */
  Crashed, /**< a signal ended it */
  TimedOut, /**< the limit of wall time */
  OutOfMemory, /**< the limit of memory */
  Interrupted /**< by the user: it counts as not run */
};

/** @return the word in the database and in tables: "done", "robots_stopped", "failed", ... */
const char* ToText(ERunStatus status);
/** @throws CARGoSException if there is no such status. */
ERunStatus ToRunStatus(const std::string& text);

/** Values of a metric during a run. */
struct SMetricSeries {
  std::string Name, Unit;
  std::vector<UInt32> Ticks;
  std::vector<Real> Values; /**< (ticks) */
};

struct SMetricValue {
  std::string Name, Unit;
  Real Value = 0.0; /**< NaN: it had none */
};

/** What is stored of a run. */
struct SRunResult {
  ERunStatus Status = ERunStatus::Failed;
  int ExitStatus = 0;
  int Signal = 0; /**< 0: none */
  Real StartUpTime = 0.0; /**< until the first tick, s of wall time */
  Real WallTime = 0.0; /**< of the main loop, s */
  Real CPUTime = 0.0; /**< of all threads in the main loop, s */
  Real TotalWallTime = 0.0; /**< of the whole run, s */
  UInt64 PeakMemory = 0; /**< resident, bytes */
  UInt32 Ticks = 0, Robots = 0;
  UInt64 Digest = 0; /**< of the final state */
  std::string Log; /**< the end of what it printed, and the error message, if any */
  UInt64 LogBytes = 0; /**< all that it printed */
  std::vector<SMetricValue> Metrics;
  std::vector<SMetricSeries> Series;
};

}  // namespace argos

#endif
