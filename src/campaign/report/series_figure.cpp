#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/series_bands.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

constexpr Real kMissing = std::numeric_limits<Real>::quiet_NaN();
constexpr size_t kMostPoints = 600;  // of a line in a figure; the data file has all

// 0 if runs differ in it, or the experiment has none
Real FindTicksPerSecond(const SCampaign& campaign) {
  for (const SCombination& combination : campaign.Combinations) {
    for (const SSetting& setting : combination.Settings) {
      if (setting.Path.find("ticks_per_second") != std::string::npos) {
        return 0.0;
      }
    }
  }
  Real ticksPerSecond = 0.0;
  try {
    CConfigurationDocument document;
    document.Parse(campaign.ExperimentText, campaign.ExperimentFile);
    GetNodeAttributeOrDefault(GetNode(GetNode(document.GetRoot(), "framework"), "experiment"),
                              "ticks_per_second", ticksPerSecond, 0.0);
  } catch (const CARGoSException&) {
    // ticks remain
  }
  return ticksPerSecond;
}

struct SGroupSeries {
  std::vector<UInt32> Ticks;  // of any of the runs, ascending
  std::vector<std::vector<Real>> Runs;  // (runs, ticks up to the run's last one)
};

std::vector<SGroupSeries> CollectGroups(const CReportData& data, const SFigureRequest& request,
                                        const CFigureGroups& groups) {
  const std::vector<SRunSeries> all = data.ReadSeries(request.Y);
  std::vector<SGroupSeries> collected(groups.GetCount());
  for (const SRunSeries& run : all) {
    std::vector<UInt32>& ticks = collected[groups.GetGroup(run.Combination)].Ticks;
    ticks.insert(ticks.end(), run.Series.Ticks.begin(), run.Series.Ticks.end());
  }
  for (SGroupSeries& group : collected) {
    std::sort(group.Ticks.begin(), group.Ticks.end());
    group.Ticks.erase(std::unique(group.Ticks.begin(), group.Ticks.end()), group.Ticks.end());
  }
  for (const SRunSeries& run : all) {
    SGroupSeries& group = collected[groups.GetGroup(run.Combination)];
    std::vector<Real>& values = group.Runs.emplace_back();
    for (size_t i = 0; i < run.Series.Ticks.size(); ++i) {
      const auto place =
          std::lower_bound(group.Ticks.begin(), group.Ticks.end(), run.Series.Ticks[i]);
      values.resize(static_cast<size_t>(place - group.Ticks.begin()), kMissing);
      values.push_back(run.Series.Values[i]);
      if (request.IsLogarithmic && !std::isnan(run.Series.Values[i])) {
        RequirePositive(request.Y, run.Series.Values[i]);
      }
    }
  }
  return collected;
}

// means with t intervals at each tick, which have width 0 if there is one run only
SSeriesBands ComputeIntervals(const std::vector<std::vector<Real>>& runs) {
  // counts, and checks of the values
  SSeriesBands bands = ComputeSeriesBands(runs);
  std::vector<Real> values;
  for (size_t tick = 0; tick < bands.Counts.size(); ++tick) {
    if (bands.Counts[tick] == 0) {
      continue;
    }
    values.clear();
    for (const std::vector<Real>& run : runs) {
      if (tick < run.size() && !std::isnan(run[tick])) {
        values.push_back(run[tick]);
      }
    }
    bands.Median[tick] = bands.Lower[tick] = bands.Upper[tick] = ComputeMoments(values).Mean;
    if (values.size() >= 2) {
      const SConfidenceInterval interval = ComputeMeanInterval(values, kReportLevel);
      bands.Lower[tick] = interval.Lower;
      bands.Upper[tick] = interval.Upper;
    }
  }
  return bands;
}

// from the least value of any run to the top of the bands; NaN without values
struct SBandRange {
  Real Low = kMissing;
  Real High = kMissing;
};

std::string MakeBlock(const SGroupSeries& group, Real ticksPerSecond, bool showsInterval,
                      SBandRange& range) {
  if (group.Runs.empty()) {
    return "NaN NaN NaN NaN 0\n\n\n";
  }
  const SSeriesBands bands =
      showsInterval ? ComputeIntervals(group.Runs) : ComputeSeriesBands(group.Runs);
  // an interval may reach below 0 though no value does; fmin() and fmax() ignore NaN
  for (const std::vector<Real>& run : group.Runs) {
    for (const Real value : run) {
      range.Low = std::fmin(range.Low, value);
    }
  }
  std::string text;
  for (size_t i = 0; i < bands.Median.size(); ++i) {
    const Real time = ticksPerSecond > 0.0 ? group.Ticks[i] / ticksPerSecond : group.Ticks[i];
    range.High = std::fmax(range.High, bands.Upper[i]);
    text += FormatForGnuplot(time);
    for (const Real number : {bands.Lower[i], bands.Median[i], bands.Upper[i]}) {
      text += ' ' + FormatForGnuplot(number);
    }
    text += fmt::format(" {}\n", bands.Counts[i]);
  }
  return text + "\n\n";
}

// bands of all groups, and then the lines above them
std::string MakePlots(const std::vector<SGroupSeries>& collected, const CFigureGroups& groups) {
  std::string bands;
  std::string lines;
  for (size_t group = 0; group < collected.size(); ++group) {
    const size_t count = collected[group].Ticks.size();
    const std::string source = fmt::format("{} index {} every {}", kDataName, group,
                                           (count + kMostPoints - 1) / kMostPoints + (count == 0));
    bands += fmt::format(
        "{}{} using 1:2:4 with filledcurves fillstyle transparent solid 0.2 noborder linecolor rgb "
        "'{}' notitle",
        group == 0 ? "plot " : ", \\\n  ", source, GetColor(group));
    lines += fmt::format(", \\\n  {} using 1:3 with lines linewidth 2 linecolor rgb '{}'{}", source,
                         GetColor(group), groups.MakeKey(group));
  }
  return bands + lines + '\n';
}

}  // namespace

SFigureDraft MakeSeriesFigure(const CReportData& data, const SFigureRequest& request) {
  RequireName(request, "y", request.Y);
  const CFigureGroups groups(data, request.Group);
  const std::vector<SGroupSeries> collected = CollectGroups(data, request, groups);
  const Real ticksPerSecond = FindTicksPerSecond(data.GetCampaign());
  const char* const timeLabel = ticksPerSecond > 0.0 ? "time (s)" : "time (ticks)";

  SFigureDraft draft;
  draft.Data = fmt::format(
      "# {}: a block for each group\n# {}, {}, number of runs\n", MakeLine(request.Y), timeLabel,
      request.ShowsInterval ? "lower bound of the t interval, mean, upper bound"
                            : "lower quartile, median, upper quartile");
  std::vector<size_t> counts;
  SBandRange range;
  for (size_t group = 0; group < collected.size(); ++group) {
    draft.Data += "# " + MakeLine(groups.GetTitle(group)) + '\n' +
                  MakeBlock(collected[group], ticksPerSecond, request.ShowsInterval, range);
    if (!collected[group].Runs.empty()) {
      counts.push_back(collected[group].Runs.size());
    }
  }
  if (counts.empty()) {
    THROW_ARGOSEXCEPTION("no run that is done has values of the series \"" << request.Y << '"');
  }
  draft.Script =
      MakeStyle(request.Title, request.XLabel.empty() ? timeLabel : request.XLabel,
                MakeMetricLabel(data, request.Y, true, request.YLabel)) +
      (request.IsLogarithmic ? "set logscale y\n" : MakeValueAxis(range.Low, range.High)) +
      MakePlots(collected, groups);
  draft.Caption = fmt::format(
      "{} over time: {} (band) of {}{}.{}", MakeLabel(request.Y, ""),
      request.ShowsInterval
          ? "mean (line) and its " + FormatLevel(kReportLevel) + " t interval at each time"
          : "median (line) and quartiles",
      DescribeCounts(counts), request.Group.empty() ? "" : " for each level of " + request.Group,
      DescribePooled(data, {request.Group}));
  return draft;
}

}  // namespace argos
