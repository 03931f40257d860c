#ifndef ARGOS3_CAMPAIGN_SLURM_SUBMISSION_H
#define ARGOS3_CAMPAIGN_SLURM_SUBMISSION_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/scheduling/campaign_manager.h>
#include <argos3/campaign/scheduling/run_plan.h>
#include <argos3/campaign/slurm/submission_files.h>

#include <string>
#include <vector>

namespace argos {

/** What a submission executes, and how: scripts that are not written yet. */
struct SSubmission {
  UInt32 Number = 1; /**< number of the submission; no number is used twice */
  std::vector<UInt32> Tasks; /**< shares that have runs; empty: nothing is missing */
  UInt64 Runs = 0; /**< runs of all tasks */
  std::string RunsScript, MergingScript; /**< their texts */
};

/**
 * Prepares a submission of what is missing.
 * @param known          runs that are stored.
 * @param resubmissions  how often the merging job may submit what is still missing.
 * @param failed         Repeated: the tasks execute stored runs that have failed again; then
 *   @p known lacks these.
 */
SSubmission PrepareSubmission(const SCampaign& campaign, const std::vector<SKnownRun>& known,
                              UInt32 resubmissions, EFailedRuns failed = EFailedRuns::Known);

/**
 * Writes the scripts, and queues both jobs. Their numbers are in NAME.slurm/jobs.
 * @throws CARGoSException if Slurm rejects one of them; then none stays in the queue.
 */
SSubmittedJobs QueueSubmission(const SCampaign& campaign, const SSubmission& submission);

/** @throws CARGoSException if jobs of the last submission wait or run. */
void ThrowIfQueued(const SCampaign& campaign);

}  // namespace argos

#endif
