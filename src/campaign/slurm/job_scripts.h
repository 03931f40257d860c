#ifndef ARGOS3_CAMPAIGN_SLURM_JOB_SCRIPTS_H
#define ARGOS3_CAMPAIGN_SLURM_JOB_SCRIPTS_H

#include <argos3/campaign/design/campaign.h>
#include <argos3/campaign/slurm/submission_files.h>

#include <string>
#include <vector>

namespace argos {

/** What the scripts of a submission need, besides the campaign. */
struct SScriptOptions {
  UInt32 Number = 1; /**< number of the submission */
  UInt32 Resubmissions = 0; /**< number that may follow */
  std::string Program; /**< path of argos3-campaign */
  std::string WorkingFolder; /**< of the jobs */
  bool RepeatsFailedRuns = false; /**< of those that are stored */
  std::vector<UInt32> Tasks; /**< numbers of the shares that have runs, ascending */
};

/** "1-4,7": what sbatch --array takes. */
std::string FormatArray(const std::vector<UInt32>& tasks);

/** The array job: each task executes a share of the runs. */
std::string MakeRunsScript(const SCampaign& campaign, const SScriptOptions& options);
/** The job that merges what the tasks have stored, and resubmits what is missing. */
std::string MakeMergingScript(const SCampaign& campaign, const SScriptOptions& options);

/** NAME.slurm/runs_1.sh and NAME.slurm/merging_1.sh. */
std::string GetRunsScriptPath(const SSubmissionPaths& paths, UInt32 number);
std::string GetMergingScriptPath(const SSubmissionPaths& paths, UInt32 number);

}  // namespace argos

#endif
