#include <argos3/campaign/design/factor_values.h>
#include <argos3/campaign/execution/run_execution.h>
#include <argos3/campaign/execution/worker.h>
#include <argos3/campaign/program/command_options.h>
#include <argos3/campaign/program/commands.h>
#include <argos3/campaign/scheduling/run_plan.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/support/child_process.h>
#include <argos3/support/scratch_folder.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <optional>

namespace argos {

namespace {

struct SRunOptions {
  SExecutionOptions Execution;
  std::string Seeds; /**< empty: those of the file */
  bool IsDryRun = false;
  bool AcceptsChange = false;
  bool IsResumed = false;
};

SCampaign Read(const SRunOptions& options) {
  SCampaign campaign = ReadCampaign(options.Execution.File);
  if (!options.Seeds.empty()) {
    campaign.Stopping.Seeds = ParseSeeds(options.Seeds);
    campaign.Stopping.Metric.clear();
  }
  return campaign;
}

void PrintPlan(const SCampaign& campaign, UInt64 open) {
  for (size_t i = 0; i < campaign.Combinations.size(); ++i) {
    fmt::print("{}:", i + 1);
    for (size_t factor = 0; factor < campaign.Factors.size(); ++factor) {
      fmt::print(" {}={}", campaign.Factors[factor].Name,
                 campaign.Combinations[i].Values.at(factor));
    }
    fmt::print("\n");
  }
  const size_t count = campaign.Combinations.size();
  fmt::print("{} combination{}, {} excluded\n", count, count == 1 ? "" : "s", campaign.NumExcluded);
  if (campaign.Stopping.Metric.empty()) {
    fmt::print("{} seeds: {} runs, {} of them to be executed\n", campaign.Stopping.Seeds.size(),
               count * campaign.Stopping.Seeds.size(), open);
  } else {
    fmt::print(
        "{} to {} runs of each, until the mean of {} is known: at least {} runs, {} of "
        "them to be executed\n",
        campaign.Stopping.MinRuns, campaign.Stopping.MaxRuns, campaign.Stopping.Metric,
        count * campaign.Stopping.MinRuns, open);
  }
}

[[noreturn]] void CheckInFork(const SRunSetup& setup, const SRunRequest& request) {
  bool isGood = false;
  try {
    PrepareWorker(setup);
    isGood = LoadRun(setup, request);
  } catch (...) {
    LOGERR << MarkLines(DescribeCurrentException()) << std::endl;
    LOGERR.Flush();
  }
  _exit(isGood ? 0 : 1);
}

// Loads the experiment of a run in a forked process, with its libraries, and destroys it, as
// `argos3 --check` does. Its warnings and errors go to the standard error.
//
// @param request  its folder is not used: the process works in a temporary one, which is removed.
// @return true if it loads without errors.
// @throws CARGoSException if no folder or process can be created.
bool CheckRun(const SRunSetup& setup, SRunRequest request) {
  const CScratchFolder folder("argos3_check_");
  request.Folder = folder.GetPath().string();
  // buffered text would be written twice
  LOG.Flush();
  LOGERR.Flush();
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process == 0) {
    CheckInFork(setup, request);
  }
  if (process < 0) {
    THROW_ARGOSEXCEPTION("a process cannot be started: " << std::strerror(errno));
  }
  const int status = AwaitEnd(process);
  const SProcessEnd end = DescribeEnd(status);
  if (WIFSIGNALED(status)) {
    std::fprintf(stderr, "[FATAL] loading was ended by %s\n", end.Description.c_str());
  }
  return end.IsSuccess;
}

// Runs nothing and changes no results. The experiment is loaded, with the first combination only:
// the others seldom have errors of their own.
int PrintDryRun(const SCampaign& campaign) {
  std::vector<SKnownRun> known;
  if (HasResults(campaign)) {
    const CResultStore store(campaign.ResultsFile, CResultStore::EMode::ReadOnly);
    known = ListKnownRuns(campaign, store);
  }
  PrintPlan(campaign, CRunPlan::Create(campaign, known)->CountOpen());
  SRunRequest request;
  request.Seed = campaign.Stopping.Metric.empty() ? campaign.Stopping.Seeds.front()
                                                  : campaign.Stopping.FirstSeed;
  request.Settings = campaign.Combinations.front().Settings;
  if (!CheckRun(MakeRunSetup(campaign), request)) {
    fmt::print(stderr, "[FATAL] the experiment cannot be loaded with the first combination\n");
    return CAMPAIGN_ERROR;
  }
  return CAMPAIGN_DONE;
}

int Run(const SRunOptions& options) {
  const SCampaign campaign = Read(options);
  for (const std::string& warning : campaign.Warnings) {
    PrintWarnings(warning);
  }
  if (options.IsResumed) {
    ThrowUnlessHasResults(campaign);
  }
  if (options.IsDryRun) {
    return PrintDryRun(campaign);
  }
  CResultStore store(campaign.ResultsFile, CResultStore::EMode::Write);
  const std::string warning = store.Register(campaign, options.AcceptsChange);
  PrintWarnings(warning);
  const std::vector<SKnownRun> known = ListKnownRuns(campaign, store);
  const std::unique_ptr<CRunPlan> plan = CRunPlan::Create(campaign, known);
  return ExecutePlan(campaign, store, *plan, known.size(), options.Execution);
}

void AddCommand(CLI::App& app, TCampaignCommand& chosen, bool isResumed) {
  CLI::App& command =
      *app.add_subcommand(isResumed ? "resume" : "run",
                          isResumed ? "go on with a campaign that was stopped: run what is missing"
                                    : "run what is missing of a campaign");
  const auto options = std::make_shared<SRunOptions>();
  options->IsResumed = isResumed;
  AddExecutionOptions(command, options->Execution);
  command
      .add_option("--seeds", options->Seeds,
                  "seeds of each combination, such as 3,5,8:12, instead of those of the file")
      ->type_name("LIST");
  command.add_flag(
      "--dry-run", options->IsDryRun,
      "list the combinations and the number of runs, load the experiment of the first, "
      "and execute nothing");
  command.add_flag("--accept-change", options->AcceptsChange,
                   "the experiment has changed: begin a new generation of runs");
  RunIfChosen(command, chosen, [options] { return Run(*options); });
}

}  // namespace

void AddRunCommands(CLI::App& app, TCampaignCommand& chosen) {
  AddCommand(app, chosen, false);
  AddCommand(app, chosen, true);
}

}  // namespace argos
