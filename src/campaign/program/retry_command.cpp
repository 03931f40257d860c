#include <argos3/campaign/design/expression.h>
#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/scheduling/run_plan.h>
#include <argos3/campaign/store/failed_runs.h>
#include <argos3/core/utility/text/lists.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

namespace {

struct SRetryOptions {
  SExecutionOptions Execution;
  std::vector<std::string> Statuses;  // empty: the default
  std::string Where;
};

std::vector<std::string> ListDefaultStatuses(bool hasCondition) {
  std::vector<std::string> statuses = {"failed", "crashed", "timeout", "out_of_memory"};
  if (hasCondition) {
    statuses.insert(statuses.end(), {"done", "robots_stopped"});
  }
  return statuses;
}

/** A condition about what is stored of a run: factors, metrics, seed. */
class CRunCondition {
 public:
  CRunCondition(std::string where, const SCampaign& campaign, const CResultStore& store)
      : m_where(std::move(where)), m_campaign(campaign) {
    for (const std::string& name : store.ListMetrics()) {
      std::map<TRun, Real>& values = m_metrics[name];
      for (const CResultStore::SValue& value : store.ReadMetric(name)) {
        values.emplace(TRun(value.Combination, value.Seed), value.Value);
      }
    }
  }

  // a metric that a run has not recorded is not a number
  bool Holds(const SStoredRun& run, const SCombination& combination) {
    m_expressions.SetNames({{"seed", std::to_string(run.Seed)}});
    for (size_t f = 0; f < m_campaign.Factors.size(); ++f) {
      m_expressions.AddName(m_campaign.Factors[f].Name, combination.Values.at(f));
    }
    for (const auto& [name, values] : m_metrics) {
      const auto place = values.find({run.Combination, run.Seed});
      m_expressions.AddNumber(
          name, place != values.end() ? place->second : std::numeric_limits<Real>::quiet_NaN());
    }
    return m_expressions.IsTrue(m_where);
  }

 private:
  using TRun = std::pair<UInt32, UInt32>;  // id of the combination, seed

  std::string m_where;
  const SCampaign& m_campaign;
  std::map<std::string, std::map<TRun, Real>> m_metrics;
  CExpressions m_expressions;
};

std::vector<SPlannedRun> ListRuns(const SCampaign& campaign, const CResultStore& store,
                                  const std::vector<ERunStatus>& statuses,
                                  CRunCondition* condition) {
  std::map<UInt32, size_t> indexOf;  // by id in the store
  for (size_t i = 0; i < campaign.Combinations.size(); ++i) {
    indexOf.emplace(store.GetCombinationId(campaign.Combinations[i].ComputeKey()), i);
  }
  std::vector<SPlannedRun> runs;
  for (const SStoredRun& run : store.ListRuns()) {
    const auto index = indexOf.find(run.Combination);
    if (index != indexOf.end() &&
        std::find(statuses.begin(), statuses.end(), run.Result.Status) != statuses.end() &&
        (condition == nullptr || condition->Holds(run, campaign.Combinations.at(index->second)))) {
      runs.push_back({index->second, run.Seed});
    }
  }
  return runs;
}

int Retry(const SRetryOptions& options) {
  const std::vector<std::string> names =
      options.Statuses.empty() ? ListDefaultStatuses(!options.Where.empty()) : options.Statuses;
  std::vector<ERunStatus> statuses;
  for (const std::string& name : names) {
    statuses.push_back(ToRunStatus(name));
  }
  const SCampaign campaign = ReadCampaign(options.Execution.File);
  ThrowUnlessHasResults(campaign);
  CResultStore store(campaign.ResultsFile, CResultStore::EMode::Write);
  const std::string warning = store.Register(campaign, false);
  PrintWarnings(warning);
  std::unique_ptr<CRunCondition> condition;
  if (!options.Where.empty()) {
    condition = std::make_unique<CRunCondition>(options.Where, campaign, store);
  }
  std::vector<SPlannedRun> runs = ListRuns(campaign, store, statuses, condition.get());
  const size_t others = store.ListRuns().size() - runs.size();
  if (runs.empty()) {
    const std::string which =
        options.Where.empty() ? "" : " for which \"" + options.Where + "\" is true";
    fmt::print("no stored run has the status {}{}: nothing is repeated\n", JoinItems(names), which);
    const std::string failures = DescribeFailedRuns(campaign, store);
    return failures.empty() ? CAMPAIGN_DONE : CAMPAIGN_RUNS_FAILED;
  }
  fmt::print("{} run{} repeated\n", runs.size(), runs.size() == 1 ? " is" : "s are");
  CRunListPlan plan(std::move(runs), campaign.Combinations.size());
  return ExecutePlan(campaign, store, plan, others, options.Execution);
}

}  // namespace

void AddRetryCommand(CLI::App& app, TCampaignCommand& chosen) {
  CLI::App& command = *app.add_subcommand(
      "retry", "repeat runs that have failed, or others; their results replace the stored ones");
  const auto options = std::make_shared<SRetryOptions>();
  AddExecutionOptions(command, options->Execution);
  command
      .add_option(
          "--status", options->Statuses,
          "which: of failed, crashed, timeout, out_of_memory, robots_stopped, done; default: "
          "the first four, or all with --where")
      ->delimiter(',')
      ->type_name("LIST");
  command
      .add_option("--where", options->Where,
                  "only runs for which this Lua expression of factors, metrics and seed is true, "
                  "such as \"other_load > 0.1\"")
      ->type_name("CONDITION");
  RunIfChosen(command, chosen, [options] { return Retry(*options); });
}

}  // namespace argos
