#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/scheduling/run_plan.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

namespace argos {

namespace {

struct SRetryOptions {
  SExecutionOptions Execution;
  std::vector<std::string> Statuses = {"failed", "crashed", "timeout", "out_of_memory"};
};

std::vector<SPlannedRun> ListRuns(const SCampaign& campaign, const CResultStore& store,
                                  const std::vector<ERunStatus>& statuses) {
  std::map<UInt32, size_t> indexOf;  // by id in the store
  for (size_t i = 0; i < campaign.Combinations.size(); ++i) {
    indexOf.emplace(store.GetCombinationId(campaign.Combinations[i].ComputeKey()), i);
  }
  std::vector<SPlannedRun> runs;
  for (const SStoredRun& run : store.ListRuns()) {
    const auto index = indexOf.find(run.Combination);
    if (index != indexOf.end() &&
        std::find(statuses.begin(), statuses.end(), run.Result.Status) != statuses.end()) {
      runs.push_back({index->second, run.Seed});
    }
  }
  return runs;
}

int Retry(const SRetryOptions& options) {
  std::vector<ERunStatus> statuses;
  for (const std::string& status : options.Statuses) {
    statuses.push_back(ToRunStatus(status));
  }
  const SCampaign campaign = ReadCampaign(options.Execution.File);
  ThrowUnlessHasResults(campaign);
  CResultStore store(campaign.ResultsFile, CResultStore::EMode::Write);
  const std::string warning = store.Register(campaign, false);
  PrintWarnings(warning);
  std::vector<SPlannedRun> runs = ListRuns(campaign, store, statuses);
  const size_t others = store.ListRuns().size() - runs.size();
  fmt::print("{} run{} repeated\n", runs.size(), runs.size() == 1 ? " is" : "s are");
  CRunListPlan plan(std::move(runs), campaign.Combinations.size());
  return ExecutePlan(campaign, store, plan, others, options.Execution);
}

}  // namespace

void AddRetryCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand(
      "retry", "repeat runs that have failed; their results replace the stored ones");
  const auto options = std::make_shared<SRetryOptions>();
  AddExecutionOptions(command, options->Execution);
  command
      .add_option("--status", options->Statuses,
                  "which: of failed, crashed, timeout, out_of_memory, robots_stopped; default: all "
                  "but the last")
      ->delimiter(',')
      ->type_name("LIST");
  command.callback([options, &chosen] { chosen = [options] { return Retry(*options); }; });
}

}  // namespace argos
