#include <argos3/campaign/slurm/job_scripts.h>

#include <argos3/campaign/store/failed_runs.h>
#include <argos3/campaign/slurm/run_share.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string_view>

namespace fs = std::filesystem;

namespace argos {

namespace {

constexpr Real kMinStoppingTime = 60.0;  // s; Slurm may be that early
constexpr Real kMaxStoppingTime = 65535.0;  // s; of sbatch --signal
constexpr Real kMaxStoppingShare = 0.25;  // share of the time limit
// of a task besides its runs: manager and a worker for each job, with the libraries
constexpr UInt64 kMemoryOfManager = 256ULL << 20;
constexpr UInt64 kMebi = 1 << 20;

// a value in a line #SBATCH, where blanks, quotes, and '#' mean something
std::string QuoteForSbatch(const std::string& value) {
  const bool isPlain = std::all_of(value.begin(), value.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("_-./,:@%+=").find(c) != std::string_view::npos;
  });
  if (isPlain) {
    return value;
  }
  std::string quoted = "\"";
  for (const char c : value) {
    quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return quoted + "\"";
}

// Slurm replaces "%a" and the like in names of logs
std::string EscapePattern(const std::string& path) {
  std::string escaped;
  for (const char c : path) {
    escaped += c == '%' ? std::string("%%") : std::string(1, c);
  }
  return escaped;
}

void AddOption(std::string& script, const std::string& name, const std::string& value) {
  if (!value.empty()) {
    script += "#SBATCH --" + name + "=" + QuoteForSbatch(value) + "\n";
  }
}

std::string BeginScript(const SCampaign& campaign, const SScriptOptions& options,
                        const std::string& what, const std::string& log) {
  const std::string name = fs::path(campaign.File).stem().string();
  std::string script = "#!/bin/sh\n# " + what + "; written by argos3-campaign submit\n";
  AddOption(script, "job-name", name);
  AddOption(script, "partition", campaign.Slurm.Partition);
  AddOption(script, "account", campaign.Slurm.Account);
  AddOption(script, "time", campaign.Slurm.TimeLimit);
  AddOption(script, "ntasks", "1");
  AddOption(script, "chdir", options.WorkingFolder);
  AddOption(script, "output", log);
  // a job that Slurm repeats goes on in the same log
  AddOption(script, "open-mode", "append");
  return script;
}

void AddUserOptions(std::string& script, const SCampaign& campaign) {
  for (const std::string& option : campaign.Slurm.Options) {
    script += "#SBATCH " + option + "\n";
  }
}

// "minutes", "minutes:seconds", "hours:minutes:seconds", "days-hours", "days-hours:minutes" and
// "days-hours:minutes:seconds"; 0: another text, which Slurm judges
Real ParseTimeLimit(const std::string& text) {
  std::istringstream stream(text.find('-') == std::string::npos ? "0-" + text : text);
  const bool hasDays = text.find('-') != std::string::npos;
  std::array<UInt32, 4> numbers{};
  size_t count = 0;
  char separator = 0;
  do {
    if (!(stream >> numbers.at(count++))) {
      return 0.0;
    }
  } while (count < numbers.size() && stream >> separator);
  const auto [days, first, second, third] = numbers;
  constexpr Real kMinute = 60.0, kHour = 3600.0, kDay = 86400.0;
  const bool hasHours = hasDays || count == numbers.size();
  return days * kDay +
         (hasHours ? first * kHour + second * kMinute + third : first * kMinute + second);
}

// s before the end of a task at which it begins no further run: the time that a run may take, but
// most of the task's time is for runs
Real GetStoppingTime(const SCampaign& campaign) {
  const Real wanted =
      std::clamp(std::ceil(campaign.Limits.WallTime), kMinStoppingTime, kMaxStoppingTime);
  const Real limit = ParseTimeLimit(campaign.Slurm.TimeLimit);
  return limit > 0.0 ? std::min(wanted, std::floor(limit * kMaxStoppingShare)) : wanted;
}

// memory of a task; empty: what the partition gives
std::string GetMemory(const SCampaign& campaign) {
  if (!campaign.Slurm.MemoryPerTask.empty() || campaign.Limits.Memory == 0) {
    return campaign.Slurm.MemoryPerTask;
  }
  const UInt64 bytes = campaign.Slurm.Jobs * campaign.Limits.Memory + kMemoryOfManager;
  return fmt::format("{}M", (bytes + kMebi - 1) / kMebi);
}

}  // namespace

std::string FormatArray(const std::vector<UInt32>& tasks) {
  std::string text;
  for (size_t first = 0; first < tasks.size();) {
    size_t last = first;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) {
      ++last;
    }
    text += text.empty() ? "" : ",";
    text += last == first ? fmt::format("{}", tasks[first])
                          : fmt::format("{}-{}", tasks[first], tasks[last]);
    first = last + 1;
  }
  return text;
}

std::string MakeRunsScript(const SCampaign& campaign, const SScriptOptions& options) {
  const SSubmissionPaths paths(campaign);
  std::string script = BeginScript(
      campaign, options, "the tasks of a campaign, each of which executes a share of its runs",
      EscapePattern(paths.Folder) + fmt::format("/runs_{}_%a.log", options.Number));
  AddOption(script, "array", FormatArray(options.Tasks));
  AddOption(script, "cpus-per-task", fmt::format("{}", campaign.Slurm.Jobs));
  AddOption(script, "mem", GetMemory(campaign));
  AddOption(script, "signal", fmt::format("B:TERM@{:.0f}", GetStoppingTime(campaign)));
  AddUserOptions(script, campaign);
  script += fmt::format(
      "exec {} run-share {} --share \"$SLURM_ARRAY_TASK_ID/{}\" --part "
      "{}/\"$SLURM_ARRAY_TASK_ID\".sqlite --submission {} --jobs {}{}\n",
      QuoteForShell(options.Program), QuoteForShell(fs::absolute(campaign.File).string()),
      campaign.Slurm.Tasks, QuoteForShell(paths.Parts), ComputeSubmissionDigest(campaign),
      campaign.Slurm.Jobs, options.RepeatsFailedRuns ? " --retry" : "");
  return script;
}

std::string MakeMergingScript(const SCampaign& campaign, const SScriptOptions& options) {
  const SSubmissionPaths paths(campaign);
  std::string script = BeginScript(
      campaign, options,
      fmt::format("merges what the tasks of runs_{}.sh have stored, after they have ended",
                  options.Number),
      EscapePattern(paths.Folder) + fmt::format("/merging_{}.log", options.Number));
  AddOption(script, "cpus-per-task", "1");
  AddUserOptions(script, campaign);
  script += fmt::format("exec {} merge {} --submission {} --resubmit {}\n",
                        QuoteForShell(options.Program),
                        QuoteForShell(fs::absolute(campaign.File).string()),
                        ComputeSubmissionDigest(campaign), options.Resubmissions);
  return script;
}

std::string GetRunsScriptPath(const SSubmissionPaths& paths, UInt32 number) {
  return fmt::format("{}/runs_{}.sh", paths.Folder, number);
}

std::string GetMergingScriptPath(const SSubmissionPaths& paths, UInt32 number) {
  return fmt::format("{}/merging_{}.sh", paths.Folder, number);
}

}  // namespace argos
