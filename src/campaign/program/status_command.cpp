#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/slurm/slurm_client.h>
#include <argos3/campaign/slurm/submission_files.h>
#include <argos3/campaign/store/failed_runs.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>

namespace argos {

namespace {

void PrintParts(const SSubmissionPaths& paths) {
  UInt64 all = 0;
  std::string lines;
  for (const std::string& part : ListParts(paths)) {
    lines += "  task " + std::filesystem::path(part).stem().string() + ": ";
    try {
      const size_t runs = CResultStore(part, CResultStore::EMode::ReadOnly).ListRuns().size();
      all += runs;
      lines += fmt::format("{} runs\n", runs);
    } catch (const CARGoSException& error) {
      // it is being created, or its task was killed; merging repairs it
      lines += fmt::format("cannot be read now: {}\n", WithoutMark(error));
    }
  }
  if (!lines.empty()) {
    fmt::print("{} more runs in parts that are not merged yet:\n{}", all, lines);
  }
}

void PrintSubmission(const SCampaign& campaign) {
  const SSubmissionPaths paths(campaign);
  PrintParts(paths);
  const std::vector<SSubmittedJobs> all = ReadJobs(paths);
  if (all.empty()) {
    return;
  }
  const SSubmittedJobs& last = all.back();
  fmt::print("submission {}: array job {}, merging job {}", last.Number, last.Runs,
             last.Merging.empty() ? "was not queued" : last.Merging);
  if (HasSlurmQueue()) {
    try {
      const std::vector<std::string> queued = ListQueuedJobs(last.List());
      fmt::print("{}", queued.empty() ? "; they have ended" : "; in the queue:");
      for (const std::string& job : queued) {
        fmt::print(" {}", job);
      }
    } catch (const CARGoSException& error) {
      fmt::print("; {}", WithoutMark(error));
    }
  }
  fmt::print("\n");
}

int PrintStatus(const std::string& file) {
  const SCampaign campaign = ReadCampaign(file);
  ThrowUnlessHasResults(campaign);
  const CResultStore store(campaign.ResultsFile, CResultStore::EMode::ReadOnly);
  std::map<std::string, UInt64> counts;
  Real cpuTime = 0.0;
  for (const SStoredRun& run : store.ListRuns()) {
    ++counts[ToText(run.Result.Status)];
    cpuTime += run.Result.CPUTime;
  }
  const std::vector<SKnownRun> known = ListKnownRuns(campaign, store);
  const std::unique_ptr<CRunPlan> plan = CRunPlan::Create(campaign, known);
  fmt::print("{}: {} runs stored, {} to be executed; {} of {} combinations complete\n",
             campaign.ResultsFile, known.size(), plan->CountOpen(),
             plan->CountCompleteCombinations(), campaign.Combinations.size());
  for (const auto& [status, count] : counts) {
    fmt::print("  {}: {}\n", status, count);
  }
  fmt::print("  CPU time of their main loops: {:.6g} s\n", cpuTime);
  PrintSubmission(campaign);
  const std::string failures = DescribeFailedRuns(campaign, store);
  fmt::print("{}", failures);
  return failures.empty() ? CAMPAIGN_DONE : CAMPAIGN_RUNS_FAILED;
}

}  // namespace

void AddStatusCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command =
      *app.add_subcommand("status", "print how many runs are done, and which have failed");
  const auto file = std::make_shared<std::string>();
  AddFile(command, *file);
  RunIfChosen(command, chosen, [file] { return PrintStatus(*file); });
}

}  // namespace argos
