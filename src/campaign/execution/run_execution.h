#ifndef ARGOS3_CAMPAIGN_EXECUTION_RUN_EXECUTION_H
#define ARGOS3_CAMPAIGN_EXECUTION_RUN_EXECUTION_H

#include <argos3/campaign/execution/run_request.h>
#include <argos3/campaign/execution/run_result.h>

namespace argos {

/**
 * Executes a run in this process and thread, as `argos3 -z` would: the state at its end is the
 * same to the bit. Changes to the folder of the request, which must exist, and stays there.
 *
 * Errors are printed on LOGERR and are the status of the result: Failed, OutOfMemory,
 * RobotsStopped. Log, LogBytes and TotalWallTime of the result remain unset.
 */
SRunResult ExecuteRun(const SRunSetup& setup, const SRunRequest& request);

/**
 * Loads the experiment of a run in this process and destroys it; nothing is written but what users'
 * Init() and Destroy() write. Errors are printed on LOGERR.
 * @return true if there was none.
 */
bool LoadRun(const SRunSetup& setup, const SRunRequest& request);

}  // namespace argos

#endif
