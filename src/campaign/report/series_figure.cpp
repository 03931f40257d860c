#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/series_lines.h>
#include <argos3/campaign/report/series_times.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

namespace argos {

namespace {

// the series of each level of the group
std::vector<SSeriesGroup> CollectGroups(const CReportData& data, const SFigureRequest& request,
                                        const CFigureGroups& groups, Real ticksPerSecond) {
  std::vector<std::vector<TTimedValues>> runs(groups.GetCount());
  for (const SRunSeries& run : data.ReadSeries(request.Y)) {
    TTimedValues& values = runs[groups.GetGroup(run.Combination)].emplace_back();
    for (size_t i = 0; i < run.Series.Ticks.size(); ++i) {
      const Real tick = run.Series.Ticks[i];
      const Real value = run.Series.Values[i];
      // logarithmic time has no place for the start
      if (request.IsXLogarithmic && tick <= 0.0) {
        continue;
      }
      values.emplace_back(ticksPerSecond > 0.0 ? tick / ticksPerSecond : tick, value);
    }
  }
  std::vector<SSeriesGroup> collected;
  for (size_t group = 0; group < runs.size(); ++group) {
    collected.push_back(MakeSeriesGroup(groups.GetTitle(group), runs[group]));
  }
  return collected;
}

}  // namespace

SFigureDraft MakeSeriesFigure(const CReportData& data, const SFigureRequest& request) {
  RequireName(request, "y", request.Y);
  const CFigureGroups groups(data, request.Group);
  const Real ticksPerSecond = FindTicksPerSecond(data.GetCampaign());
  const std::string timeLabel = MakeTimeLabel(ticksPerSecond);
  const SSeriesLines lines = MakeSeriesLines(CollectGroups(data, request, groups, ticksPerSecond),
                                             {request.ShowsInterval, request.EndedRuns, false,
                                              request.IsLogarithmic, request.IsXLogarithmic});
  if (lines.Counts.empty()) {
    THROW_ARGOSEXCEPTION("no run that is done has values of the series \"" << request.Y << '"');
  }

  SFigureDraft draft;
  draft.Data =
      fmt::format("# {}: a block for each group\n# {}, {}, number of runs\n", MakeLine(request.Y),
                  timeLabel,
                  request.ShowsInterval ? "lower bound of the t interval, mean, upper bound"
                                        : "lower quartile, median, upper quartile") +
      lines.Data;
  draft.Script = MakeStyle(request.Title, request.XLabel.empty() ? timeLabel : request.XLabel,
                           MakeMetricLabel(data, request.Y, true, request.YLabel)) +
                 lines.Axes + lines.Plot;
  draft.Caption = fmt::format(
      "{} over time: {} (band) of {}{}.{}{}", MakeLabel(request.Y, ""),
      request.ShowsInterval
          ? "mean (line) and its " + FormatLevel(kReportLevel) + " t interval at each time"
          : "median (line) and quartiles",
      DescribeCounts(lines.Counts),
      request.Group.empty() ? "" : " for each level of " + request.Group,
      lines.Ending + lines.LeftOut, DescribePooled(data, {request.Group}));
  return draft;
}

}  // namespace argos
