#ifndef ARGOS3_TESTING_SCENARIO_CAMPAIGN_CAMPAIGN_RUN_H
#define ARGOS3_TESTING_SCENARIO_CAMPAIGN_CAMPAIGN_RUN_H

#include "../command_line/program_run.h"

#include <sys/types.h>

#include <string>
#include <vector>

namespace argos {

/**
 * What a campaign has stored, without what differs from run to run: a line for each run, by
 * combination and seed, with status, exit status, signal, ticks, digest, and metrics.
 */
std::vector<std::string> ReadTable(const std::string& database);

/** Starts argos3-campaign in a folder, without waiting for it. Its output goes to /dev/null. */
pid_t StartCampaign(const CTestFolder& folder, const std::vector<std::string>& arguments);

/** Waits. @return exit status; 128 + number if a signal killed it. */
int AwaitCampaign(pid_t process);

/** Waits until the database has some runs. @return false if the process ends before. */
bool AwaitRuns(const std::string& database, size_t count, pid_t process);

}  // namespace argos

#endif
