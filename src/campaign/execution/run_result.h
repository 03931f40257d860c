#ifndef ARGOS3_CAMPAIGN_EXECUTION_RUN_RESULT_H
#define ARGOS3_CAMPAIGN_EXECUTION_RUN_RESULT_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/run/run_status.h>

#include <string>
#include <vector>

namespace argos {

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
  Real StartUpTime = 0.0; /**< wall time until the first tick, s */
  Real WallTime = 0.0; /**< wall time of the main loop, s */
  Real CPUTime = 0.0; /**< time of all threads in the main loop, s */
  Real TotalWallTime = 0.0; /**< wall time of the whole run, s */
  UInt64 PeakMemory = 0; /**< resident, bytes */
  UInt32 Ticks = 0, Robots = 0;
  UInt64 Digest = 0; /**< digest of the final state */
  std::string Log; /**< the end of what it printed, and the error message, if any */
  UInt64 LogBytes = 0; /**< all that it printed */
  // known of a run that has just ended; not stored
  std::string Error; /**< error that ended it, unless its process died */
  std::vector<std::string> Warnings; /**< lines */
  std::vector<SMetricValue> Metrics;
  std::vector<SMetricSeries> Series;
};

}  // namespace argos

#endif
