#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/store/failed_runs.h>
#include <argos3/campaign/slurm/job_scripts.h>
#include <argos3/campaign/slurm/part_merging.h>
#include <argos3/campaign/slurm/slurm_client.h>
#include <argos3/campaign/slurm/submission.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <memory>

namespace argos {

namespace {

struct SSubmitOptions {
  std::string File;
  bool IsDryRun = false;
  bool AcceptsChange = false;
  EFailedRuns Failed = EFailedRuns::Known;
};

// changes nothing, and needs no Slurm
int PrintScripts(const SCampaign& campaign, EFailedRuns failed) {
  std::vector<SKnownRun> known;
  if (HasResults(campaign)) {
    const CResultStore store(campaign.ResultsFile, CResultStore::EMode::ReadOnly);
    known = ListKnownRuns(campaign, store, failed);
  }
  const SSubmission submission =
      PrepareSubmission(campaign, known, campaign.Slurm.Resubmissions, failed);
  if (submission.Tasks.empty()) {
    fmt::print("all runs are stored: nothing would be submitted\n");
    return CAMPAIGN_DONE;
  }
  const SSubmissionPaths paths(campaign);
  fmt::print("==> {} <==\n{}\n==> {} <==\n{}", GetRunsScriptPath(paths, submission.Number),
             submission.RunsScript, GetMergingScriptPath(paths, submission.Number),
             submission.MergingScript);
  return CAMPAIGN_DONE;
}

int Submit(const SSubmitOptions& options) {
  const SCampaign campaign = ReadCampaign(options.File);
  for (const std::string& warning : campaign.Warnings) {
    PrintWarnings(warning);
  }
  if (options.IsDryRun) {
    return PrintScripts(campaign, options.Failed);
  }
  ThrowUnlessHasSlurm();
  ThrowIfQueued(campaign);
  CResultStore store(campaign.ResultsFile, CResultStore::EMode::WriteShared);
  PrintWarnings(store.Register(campaign, options.AcceptsChange));
  // removes what a submission has left that was cancelled before it was merged
  const SMergedParts merged = MergeParts(campaign, store);
  if (!merged.Problems.empty()) {
    THROW_ARGOSEXCEPTION("a part of an earlier submission cannot be merged: "
                         << merged.Problems.front() << "\nRemove it to have its runs repeated");
  }
  const SSubmission submission =
      PrepareSubmission(campaign, ListKnownRuns(campaign, store, options.Failed),
                        campaign.Slurm.Resubmissions, options.Failed);
  if (submission.Tasks.empty()) {
    fmt::print("all runs are stored: nothing is submitted\n");
    return CAMPAIGN_DONE;
  }
  const SSubmittedJobs jobs = QueueSubmission(campaign, submission);
  fmt::print(
      "{} runs in {} tasks are submitted: array job {}, merging job {}\nscripts and logs: {}\n"
      "`argos3-campaign status {}` shows how far they are\n",
      submission.Runs, submission.Tasks.size(), jobs.Runs, jobs.Merging,
      SSubmissionPaths(campaign).Folder, QuoteForShell(campaign.File));
  return CAMPAIGN_DONE;
}

}  // namespace

void AddSubmitCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand(
      "submit", "run what is missing of a campaign on a cluster, as an array job of Slurm");
  const auto options = std::make_shared<SSubmitOptions>();
  AddFile(command, options->File);
  command.add_flag("--dry-run", options->IsDryRun, "print the job scripts, and submit nothing");
  command.add_flag("--accept-change", options->AcceptsChange,
                   "the experiment has changed: begin a new generation of runs");
  command.add_flag_callback(
      "--retry", [options] { options->Failed = EFailedRuns::Repeated; },
      "repeat stored runs that have failed, too; their results replace the stored ones");
  RunIfChosen(command, chosen, [options] { return Submit(*options); });
}

}  // namespace argos
