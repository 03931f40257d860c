#include <argos3/campaign/plot/table_figures.h>

#include <argos3/campaign/plot/table_file.h>
#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/series_lines.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <cmath>
#include <map>

namespace argos {

namespace {

/** A metric in all runs. */
struct SMetricRuns {
  std::vector<TTimedValues> Runs;
  std::string Unit;
};

void ReadMetricRuns(const std::string& path, const SMetricRequest& request,
                    std::vector<SMetricRuns>& metrics) {
  CTableFile table(path);
  if (table.HasColumn("robot")) {
    THROW_ARGOSEXCEPTION(path << ": it has a row for each robot; metrics need one for each tick");
  }
  const size_t run = table.FindColumn("run");
  const size_t time = table.FindColumn("time");
  std::vector<size_t> columns;
  for (size_t i = 0; i < metrics.size(); ++i) {
    columns.push_back(table.FindColumn(request.Metrics[i]));
    if (metrics[i].Unit.empty()) {
      metrics[i].Unit = table.GetUnit(request.Metrics[i]);
    }
  }
  std::vector<std::map<std::string, TTimedValues>> runs(metrics.size());
  while (table.ReadRow()) {
    const Real seconds = table.GetNumber(time);
    if (!request.Span.Contains(seconds) || (request.IsTimeLogarithmic && seconds <= 0.0)) {
      continue;
    }
    for (size_t i = 0; i < metrics.size(); ++i) {
      const Real value = table.GetNumber(columns[i]);
      if (!std::isnan(value)) {
        runs[i][table.GetText(run)].emplace_back(seconds, value);
      }
    }
  }
  for (size_t i = 0; i < metrics.size(); ++i) {
    for (auto& [id, values] : runs[i]) {
      metrics[i].Runs.push_back(std::move(values));
    }
  }
}

}  // namespace

SFigureDraft MakeMetricFigure(const SMetricRequest& request) {
  if (request.Metrics.size() > kMaxColors) {
    THROW_ARGOSEXCEPTION("at most " << kMaxColors << " metrics fit into one plot, found "
                                    << request.Metrics.size());
  }
  std::vector<SMetricRuns> metrics(request.Metrics.size());
  for (const std::string& file : request.Files) {
    ReadMetricRuns(file, request, metrics);
  }
  std::vector<SSeriesGroup> groups;
  std::string label = request.Label;
  bool isSeveral = false;
  for (size_t i = 0; i < metrics.size(); ++i) {
    if (metrics[i].Runs.empty()) {
      THROW_ARGOSEXCEPTION("there are no values of \"" << request.Metrics[i] << "\" to plot");
    }
    std::string name = request.Metrics[i];
    Replace(name, "_", " ");
    if (label.empty()) {
      label = name + (metrics[i].Unit.empty() ? "" : ", " + metrics[i].Unit);
    }
    isSeveral = isSeveral || metrics[i].Runs.size() > 1;
    // a single one is named by the axis
    const bool hasKey = metrics.size() > 1 || !request.Label.empty();
    groups.push_back(MakeSeriesGroup(hasKey ? name : "", metrics[i].Runs));
  }
  const SSeriesLines lines = MakeSeriesLines(
      std::move(groups),
      {false, request.Ended, true, request.IsLogarithmic, request.IsTimeLogarithmic});
  const std::string title =
      !isSeveral
          ? ""
          : "median and quartiles" + (lines.CommonRuns.empty() ? "" : " of " + lines.CommonRuns);
  SFigureDraft draft;
  draft.Data = "# time, lower quartile, median, upper quartile, number of runs\n" + lines.Data;
  draft.Script = MakeStyle(title, "time, s", label) + lines.Axes + lines.Plot;
  draft.Caption = lines.LeftOut;
  return draft;
}

}  // namespace argos
