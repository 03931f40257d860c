#ifndef ARGOS3_CAMPAIGN_STORE_FAILED_RUNS_H
#define ARGOS3_CAMPAIGN_STORE_FAILED_RUNS_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/store/result_store.h>

#include <string>

namespace argos {

/** @return a word of a command for a POSIX shell, in quotes if it needs them. */
std::string QuoteForShell(const std::string& word);

/** @return "robots=5, speed=10, "; empty without factors. */
std::string DescribeLevels(const SCampaign& campaign, const SCombination& combination);

/** @return a command that executes a run of the campaign alone, outside of the campaign. */
std::string MakeRepeatCommand(const SCampaign& campaign, const SCombination& combination,
                              UInt32 seed);

/**
 * The last crash or error in a log, on one line and shortened, with the line below a report of a
 * crash.
 * @return empty if there is none.
 */
std::string FindErrorMessage(const std::string& log);

/**
 * Lists the runs of the newest generation that have failed, by combination and seed: the levels,
 * the seed, the status, the first error message, and the command that repeats the run.
 * @param most  further runs are counted only.
 * @return empty if there is none.
 */
std::string DescribeFailedRuns(const SCampaign& campaign, const CResultStore& store,
                               size_t most = 20);

}  // namespace argos

#endif
