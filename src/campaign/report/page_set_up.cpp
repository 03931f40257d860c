#include <argos3/campaign/report/page_parts.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/core/utility/text/lists.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace argos {

namespace {

std::string MakeNumber(const std::string& number, const std::string& what) {
  return "<li><b>" + EscapeHTML(number) + "</b>" + EscapeHTML(what) + "</li>\n";
}

// "1 to 10, 15"
std::string ListSeeds(const std::vector<UInt32>& seeds) {
  std::set<UInt32> sorted(seeds.begin(), seeds.end());
  std::string text;
  for (auto first = sorted.begin(); first != sorted.end();) {
    auto last = first;
    for (auto next = std::next(last); next != sorted.end() && *next == *last + 1; ++next) {
      last = next;
    }
    AppendItem(text,
               first == last ? std::to_string(*first) : fmt::format("{} to {}", *first, *last));
    first = std::next(last);
  }
  return text;
}

std::string DescribeSeeds(const SStopping& stopping) {
  if (stopping.Metric.empty()) {
    return ListSeeds(stopping.Seeds);
  }
  const std::string width =
      stopping.Width > 0.0
          ? "is at most " + FormatNumber(stopping.Width) + " wide"
          : "is within " + FormatLevel(stopping.Relative) + " of the mean to each side";
  return fmt::format("from {} on, until the {} interval of the mean of {} {}; {} to {} runs",
                     stopping.FirstSeed, FormatLevel(stopping.Level), stopping.Metric, width,
                     stopping.MinRuns, stopping.MaxRuns);
}

std::string FormatBytes(UInt64 bytes) {
  constexpr Real kMebi = 1024.0 * 1024.0;
  return fmt::format("{:.4g} MiB", static_cast<Real>(bytes) / kMebi);
}

std::string DescribeLimits(const SRunLimits& limits) {
  std::string text = "output " + FormatBytes(limits.Output);
  if (limits.Memory > 0) {
    text = "memory " + FormatBytes(limits.Memory) + ", " + text;
  }
  return (limits.WallTime > 0.0 ? "real time " + FormatDuration(limits.WallTime)
                                : std::string("real time unlimited")) +
         ", " + text;
}

// all levels, each once
std::string ListPaths(const SFactor& factor) {
  std::vector<std::string> paths;
  for (const SLevel& level : factor.Levels) {
    for (const SSetting& setting : level.Settings) {
      if (std::find(paths.begin(), paths.end(), setting.Path) == paths.end()) {
        paths.push_back(setting.Path);
      }
    }
  }
  return JoinItems(paths);
}

std::string JoinLevels(const std::vector<std::string>& levels) {
  constexpr size_t kMaxLevels = 40;
  std::string text;
  for (size_t i = 0; i < std::min(levels.size(), kMaxLevels); ++i) {
    text += (i == 0 ? "" : ", ") + levels[i];
  }
  return levels.size() <= kMaxLevels ? text
                                     : fmt::format("{}, ... ({} in all)", text, levels.size());
}

}  // namespace

std::string MakeOverview(const CReportData& data) {
  size_t numDone = 0;
  Real realTime = 0.0;
  Real cpuTime = 0.0;
  std::string first;
  std::string last;
  for (const SStoredRun& run : data.GetRuns()) {
    numDone += run.Result.Status == ERunStatus::Done ? 1 : 0;
    realTime += run.Result.TotalWallTime;
    cpuTime += run.Result.CPUTime;
    first = first.empty() ? run.Started : std::min(first, run.Started);
    last = std::max(last, run.Started);
  }
  const size_t count = data.GetRuns().size();
  std::string text = fmt::format(
      "<p class=\"quiet\">Experiment {}{}</p>\n", EscapeHTML(data.GetCampaign().ExperimentFile),
      count == 0 ? std::string() : EscapeHTML("; runs from " + first + " to " + last));
  text += "<ul class=\"numbers\">\n" +
          MakeNumber(std::to_string(count), count == 1 ? "run" : "runs") +
          MakeNumber(std::to_string(count - numDone), "failed") +
          MakeNumber(std::to_string(data.GetCampaign().Combinations.size()), "combinations") +
          MakeNumber(FormatDuration(realTime), "real time of all runs") +
          MakeNumber(FormatDuration(cpuTime), "CPU time of all main loops") + "</ul>\n";
  if (count == 0) {
    text += "<p class=\"notice\">There are no runs yet.</p>\n";
  }
  const UInt64 older = data.GetStore().CountOlderRuns();
  if (older > 0) {
    text +=
        fmt::format("<p class=\"notice\">{} of earlier versions of the experiment left out.</p>\n",
                    Count(older, "run"));
  }
  if (data.GetNumLeftOut() > 0) {
    text += fmt::format(
        "<p class=\"notice\">{} of combinations that the campaign file does not have any more left "
        "out.</p>\n",
        Count(data.GetNumLeftOut(), "run"));
  }
  return text;
}

std::string MakeSetUp(const CReportData& data) {
  const SCampaign& campaign = data.GetCampaign();
  std::string text = "<h2>Set-up</h2>\n";
  if (!campaign.Factors.empty()) {
    CHTMLTable factors({"factor", "levels", "attributes"}, 3);
    for (size_t i = 0; i < campaign.Factors.size(); ++i) {
      factors.AddRow({campaign.Factors[i].Name, JoinLevels(data.GetLevels(i)),
                      ListPaths(campaign.Factors[i])});
    }
    text += factors.ToText();
  }
  CHTMLTable table({"", ""}, 2);
  table.AddRow({"campaign file", campaign.File});
  table.AddRow({"experiment", campaign.ExperimentFile});
  for (const SSetting& setting : campaign.Constants) {
    table.AddRow({"changed", setting.Path + " = " + setting.Value});
  }
  table.AddRow({"combinations", campaign.NumExcluded == 0
                                    ? std::to_string(campaign.Combinations.size())
                                    : fmt::format("{}, {} excluded", campaign.Combinations.size(),
                                                  campaign.NumExcluded)});
  table.AddRow({"seeds", DescribeSeeds(campaign.Stopping)});
  table.AddRow({"limits of a run", DescribeLimits(campaign.Limits)});
  table.AddRow(
      {"isolation of runs", campaign.Isolation == EIsolation::OwnProcess ? "process" : "thread"});
  table.AddRow({"runs at the same time",
                campaign.Jobs > 0 ? std::to_string(campaign.Jobs) : "one for each processor"});
  table.AddRow({"threads of a run", std::to_string(campaign.Threads)});
  return text + table.ToText();
}

std::string MakeMachines(const CReportData& data) {
  struct SUse {
    size_t Count = 0;
    Real RealTime = 0.0, CPUTime = 0.0;
    UInt64 Memory = 0;
  };
  std::map<std::pair<std::string, std::string>, SUse> uses;
  for (const SStoredRun& run : data.GetRuns()) {
    SUse& use = uses[{run.Machine, run.Version}];
    ++use.Count;
    use.RealTime += run.Result.TotalWallTime;
    use.CPUTime += run.Result.CPUTime;
    use.Memory = std::max(use.Memory, run.Result.PeakMemory);
  }
  if (uses.empty()) {
    return "";
  }
  CHTMLTable table({"machine", "version", "runs", "real time", "CPU time", "largest run"}, 2);
  for (const auto& [key, use] : uses) {
    table.AddRow({key.first, key.second, std::to_string(use.Count), FormatDuration(use.RealTime),
                  FormatDuration(use.CPUTime), FormatBytes(use.Memory)});
  }
  return "<h2>Machines</h2>\n" + table.ToText();
}

}  // namespace argos
