#ifndef ARGOS3_CAMPAIGN_EXECUTION_WORKER_H
#define ARGOS3_CAMPAIGN_EXECUTION_WORKER_H

#include <argos3/campaign/execution/run_request.h>

namespace argos {

/**
 * Prepares a forked process for runs: loads all plug-ins in ARGOS_PLUGIN_PATH and beside the core,
 * as the program argos3 does, and those that attributes `library` of the experiment name; installs
 * the handler of crashes. Its standard output and input are those of /dev/null.
 * @throws CARGoSException if a library cannot be loaded.
 */
void PrepareWorker(const SRunSetup& setup);

/**
 * The main function of a worker's process: executes the runs that are requested, one after another,
 * each in a fork of this process (see CRunProcess), after PrepareWorker(). Nothing else is
 * prepared: each run finds the same state.
 *
 * @param requests  pipe of SMessage::EKind::Request; when it is closed, the process ends, and
 *   aborts the present run.
 * @param results   pipe for EKind::Result, and for EKind::Error if a library cannot be loaded.
 */
[[noreturn]] void RunWorker(const SRunSetup& setup, int requests, int results);

}  // namespace argos

#endif
