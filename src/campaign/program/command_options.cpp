#include <argos3/campaign/program/command_options.h>

#include <argos3/campaign/report/equal_levels.h>
#include <argos3/campaign/store/failed_runs.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/run/run_status.h>

#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <sched.h>

#include <cstdio>
#include <filesystem>
#include <sstream>

namespace argos {

namespace {

UInt32 CountProcessors() {
  cpu_set_t processors;
  CPU_ZERO(&processors);
  return sched_getaffinity(0, sizeof(processors), &processors) == 0
             ? static_cast<UInt32>(CPU_COUNT(&processors))
             : 1;
}

}  // namespace

void RunIfChosen(CLI::App& command, TCampaignCommand& chosen, const TCampaignCommand& run) {
  command.callback([&chosen, run] { chosen = run; });
}

void AddFile(CLI::App& command, std::string& file) {
  command.add_option("FILE", file, "the campaign file")->required();
}

void AddExecutionOptions(CLI::App& command, SExecutionOptions& options) {
  AddFile(command, options.File);
  command
      .add_option("-j,--jobs", options.Jobs,
                  "runs at the same time; default: what the file says, or the number of processors")
      ->type_name("N")
      ->check(CLI::Range(1U, kMaxJobs));
  command.add_flag("--quiet", options.IsQuiet, "print no progress");
  command.add_flag("--live-socket", options.HasLiveViews,
                   "let viewers come and go in each run: `argos3-campaign live` lists them");
}

void PrintWarnings(const std::string& lines) {
  std::istringstream stream(lines);
  for (std::string line; std::getline(stream, line);) {
    fmt::print(stderr, "[WARNING] {}\n", line);
  }
}

bool HasResults(const SCampaign& campaign) {
  std::error_code error;
  return std::filesystem::exists(campaign.ResultsFile, error);
}

void ThrowUnlessHasResults(const SCampaign& campaign) {
  if (!HasResults(campaign)) {
    THROW_ARGOSEXCEPTION("there is no database \""
                         << campaign.ResultsFile << "\" yet: begin the campaign with "
                         << "`argos3-campaign run " << QuoteForShell(campaign.File) << '`');
  }
}

int ExecutePlan(const SCampaign& campaign, CResultStore& store, CRunPlan& plan, UInt64 known,
                const SExecutionOptions& options) {
  CCampaignManager::SOptions managerOptions;
  const UInt32 jobs = options.Jobs > 0 ? options.Jobs : campaign.Jobs;
  managerOptions.Jobs = jobs > 0 ? jobs : CountProcessors();
  managerOptions.IsQuiet = options.IsQuiet;
  managerOptions.HasLiveViews = options.HasLiveViews;
  SCampaignEnd end;
  {
    CCampaignManager manager(campaign, store, plan, known, managerOptions);
    end = manager.Run();
  }
  for (const std::string& warning : WarnOfEqualLevels(CReportData(campaign, store))) {
    PrintWarnings(warning);
  }
  const std::string failures = DescribeFailedRuns(campaign, store);
  std::fputs(failures.c_str(), stdout);
  if (end.Signal != 0) {
    fmt::print("stopped; {} run{} missing. Go on with `argos3-campaign resume {}`\n", end.OpenRuns,
               end.OpenRuns == 1 ? " is" : "s are", QuoteForShell(campaign.File));
    return ToExitStatus(ERunStatus::Interrupted, end.Signal);
  }
  return failures.empty() ? CAMPAIGN_DONE : CAMPAIGN_RUNS_FAILED;
}

}  // namespace argos
