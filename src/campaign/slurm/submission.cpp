#include <argos3/campaign/slurm/submission.h>

#include <argos3/campaign/store/failed_runs.h>
#include <argos3/campaign/slurm/job_scripts.h>
#include <argos3/campaign/slurm/run_share.h>
#include <argos3/campaign/slurm/slurm_client.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace argos {

namespace {

// known runs of a campaign, with the indices that a share has
std::vector<SKnownRun> Reindex(const SCampaign& campaign, const SCampaign& selected,
                               const std::vector<SKnownRun>& known) {
  std::map<std::string, size_t> indexOf;
  for (size_t i = 0; i < selected.Combinations.size(); ++i) {
    indexOf.emplace(selected.Combinations[i].ComputeKey(), i);
  }
  std::vector<SKnownRun> reindexed;
  for (const SKnownRun& run : known) {
    const auto place = indexOf.find(campaign.Combinations.at(run.Combination).ComputeKey());
    if (place != indexOf.end()) {
      reindexed.push_back({place->second, run.Seed, run.Value});
    }
  }
  return reindexed;
}

UInt64 CountOpenRuns(const SCampaign& campaign, const SRunShare& share,
                     const std::vector<SKnownRun>& known) {
  const SCampaign selected = SelectCombinations(campaign, share);
  return CreateSharePlan(selected, share, Reindex(campaign, selected, known))->CountOpen();
}

}  // namespace

SSubmission PrepareSubmission(const SCampaign& campaign, const std::vector<SKnownRun>& known,
                              UInt32 resubmissions, EFailedRuns failed) {
  SSubmission submission;
  SScriptOptions options;
  for (const SSubmittedJobs& earlier : ReadJobs(SSubmissionPaths(campaign))) {
    submission.Number = std::max(submission.Number, earlier.Number + 1);
  }
  for (UInt32 task = 1; task <= campaign.Slurm.Tasks; ++task) {
    const UInt64 open = CountOpenRuns(campaign, {task, campaign.Slurm.Tasks}, known);
    submission.Runs += open;
    if (open > 0) {
      submission.Tasks.push_back(task);
    }
  }
  options.Number = submission.Number;
  options.Resubmissions = resubmissions;
  options.RepeatsFailedRuns = failed == EFailedRuns::Repeated;
  options.Program = fs::read_symlink("/proc/self/exe").string();
  options.WorkingFolder = fs::current_path().string();
  options.Tasks = submission.Tasks;
  submission.RunsScript = MakeRunsScript(campaign, options);
  submission.MergingScript = MakeMergingScript(campaign, options);
  return submission;
}

SSubmittedJobs QueueSubmission(const SCampaign& campaign, const SSubmission& submission) {
  const SSubmissionPaths paths(campaign);
  fs::create_directories(paths.Folder);
  fs::create_directories(paths.Parts);
  const std::string runsScript = GetRunsScriptPath(paths, submission.Number);
  const std::string mergingScript = GetMergingScriptPath(paths, submission.Number);
  WriteTextFile(runsScript, submission.RunsScript);
  WriteTextFile(mergingScript, submission.MergingScript);
  SSubmittedJobs jobs;
  jobs.Number = submission.Number;
  jobs.Runs = QueueJob(runsScript);
  try {
    // written before the other one is queued: this program may be killed in between
    WriteJobs(paths, jobs);
    jobs.Merging = QueueJob(mergingScript, jobs.Runs);
    WriteJobs(paths, jobs);
  } catch (const CARGoSException&) {
    // runs that are not merged are of no use
    CancelJob(jobs.Runs);
    throw;
  }
  return jobs;
}

void ThrowIfQueued(const SCampaign& campaign) {
  const std::vector<SSubmittedJobs> all = ReadJobs(SSubmissionPaths(campaign));
  if (all.empty()) {
    return;
  }
  std::string numbers;
  for (const std::string& job : ListQueuedJobs(all.back().List())) {
    numbers += " " + job;
  }
  if (!numbers.empty()) {
    THROW_ARGOSEXCEPTION("jobs of this campaign are still in the queue:"
                         << numbers << "; wait until they end, or cancel them with `scancel"
                         << numbers << "`. `argos3-campaign status " << QuoteForShell(campaign.File)
                         << "` shows how far they are");
  }
}

}  // namespace argos
