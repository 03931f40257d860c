// the commands that jobs of a submission execute: run-share in the tasks, and merge

#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/store/failed_runs.h>
#include <argos3/campaign/slurm/part_merging.h>
#include <argos3/campaign/slurm/run_share.h>
#include <argos3/campaign/slurm/slurm_client.h>
#include <argos3/campaign/slurm/submission.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <memory>

namespace argos {

namespace {

struct SShareOptions {
  SExecutionOptions Execution;
  std::string Share;
  std::string Part;
  std::string Submission;
  bool RepeatsFailedRuns = false;
};

struct SMergeOptions {
  std::string File;
  std::string Submission; /**< empty: called by hand */
  UInt32 Resubmissions = 0;
};

int RunShare(const SShareOptions& options) {
  const SRunShare share = ParseRunShare(options.Share);
  const SCampaign campaign = ReadCampaign(options.Execution.File);
  ThrowIfChanged(campaign, options.Submission);
  ThrowUnlessHasResults(campaign);
  SCampaign selected = SelectCombinations(campaign, share);
  std::vector<SKnownRun> known;
  {
    const CResultStore results(campaign.ResultsFile, CResultStore::EMode::ReadOnly);
    known = ListKnownRuns(selected, results,
                          options.RepeatsFailedRuns ? EFailedRuns::Repeated : EFailedRuns::Known);
  }
  CResultStore part(options.Part, CResultStore::EMode::WriteShared);
  PrintWarnings(part.Register(campaign, false));
  // Slurm repeats a task whose node has failed: it goes on
  const std::vector<SKnownRun> knownOfPart = ListKnownRuns(selected, part);
  known.insert(known.end(), knownOfPart.begin(), knownOfPart.end());
  known = SelectKnownRuns(selected, share, known);
  const std::unique_ptr<CRunPlan> plan = CreateSharePlan(selected, share, known);
  // files of runs are kept beside the part
  selected.ResultsFile = options.Part;
  return ExecutePlan(selected, part, *plan, known.size(), options.Execution);
}

int Resubmit(const SCampaign& campaign, const std::vector<SKnownRun>& known, UInt32 left) {
  const SSubmission submission = PrepareSubmission(campaign, known, left);
  const SSubmittedJobs jobs = QueueSubmission(campaign, submission);
  fmt::print("{} runs are submitted again: array job {}, merging job {}\n", submission.Runs,
             jobs.Runs, jobs.Merging);
  return CAMPAIGN_DONE;
}

int Merge(const SMergeOptions& options) {
  const SCampaign campaign = ReadCampaign(options.File);
  ThrowUnlessHasResults(campaign);
  if (options.Submission.empty() && HasSlurmQueue()) {
    ThrowIfQueued(campaign);
  }
  CResultStore store(campaign.ResultsFile, CResultStore::EMode::WriteShared);
  const SMergedParts merged = MergeParts(campaign, store);
  fmt::print("{} runs of {} parts merged into {}\n", merged.Runs, merged.Parts,
             campaign.ResultsFile);
  for (const std::string& problem : merged.Problems) {
    fmt::print(stderr, "[WARNING] {}\n", problem);
  }
  if (!options.Submission.empty()) {
    ThrowIfChanged(campaign, options.Submission);
  }
  const std::vector<SKnownRun> known = ListKnownRuns(campaign, store);
  const UInt64 open = CRunPlan::Create(campaign, known)->CountOpen();
  if (open > 0 && options.Resubmissions > 0) {
    return Resubmit(campaign, known, options.Resubmissions - 1);
  }
  if (open > 0) {
    THROW_ARGOSEXCEPTION(open << " runs are missing; the logs in "
                              << SSubmissionPaths(campaign).Folder
                              << " say why. `argos3-campaign submit "
                              << QuoteForShell(campaign.File) << "` submits them again");
  }
  const std::string failures = DescribeFailedRuns(campaign, store);
  fmt::print("all runs are stored\n{}", failures);
  if (!merged.Problems.empty()) {
    return CAMPAIGN_ERROR;
  }
  return failures.empty() ? CAMPAIGN_DONE : CAMPAIGN_RUNS_FAILED;
}

}  // namespace

void AddShareCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand("run-share", "what a task of a submission executes");
  // scripts use it: not listed by --help
  command.group("");
  const auto options = std::make_shared<SShareOptions>();
  AddExecutionOptions(command, options->Execution);
  command.add_option("--share", options->Share, "number and count of the shares, such as 2/4")
      ->required();
  command.add_option("--part", options->Part, "database of the share")->required();
  command.add_option("--submission", options->Submission, "digest of the submitted campaign")
      ->required();
  command.add_flag("--retry", options->RepeatsFailedRuns, "repeat stored runs that have failed");
  RunIfChosen(command, chosen, [options] { return RunShare(*options); });
}

void AddMergeCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand(
      "merge", "collect what the tasks of a submission have stored; its last job does it itself");
  const auto options = std::make_shared<SMergeOptions>();
  AddFile(command, options->File);
  command.add_option("--submission", options->Submission, "digest of the submitted campaign")
      ->group("");
  command
      .add_option("--resubmit", options->Resubmissions, "how often missing runs may be submitted")
      ->group("");
  RunIfChosen(command, chosen, [options] { return Merge(*options); });
}

}  // namespace argos
