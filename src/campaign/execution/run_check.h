#ifndef ARGOS3_CAMPAIGN_EXECUTION_RUN_CHECK_H
#define ARGOS3_CAMPAIGN_EXECUTION_RUN_CHECK_H

#include <argos3/campaign/execution/run_request.h>

namespace argos {

/**
 * Loads the experiment of a run in a forked process, with its libraries, and destroys it, as
 * `argos3 --check` does. Its warnings and errors go to the standard error.
 *
 * @param request  its folder is not used: the process works in a temporary one, which is removed.
 * @return true if it loads without errors.
 * @throws CARGoSException if no folder or process can be created.
 */
bool CheckRun(const SRunSetup& setup, SRunRequest request);

}  // namespace argos

#endif
