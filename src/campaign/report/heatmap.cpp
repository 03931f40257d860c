#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/statistics/moments.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

constexpr size_t kMaxNumbers = 100;  // cells whose numbers can be read

struct SCells {
  std::vector<std::vector<Real>> Means;  // (levels of x, levels of y); NaN without values
  std::vector<size_t> Counts;  // numbers of cells with values
  Real Least = std::numeric_limits<Real>::infinity();
  Real Greatest = -std::numeric_limits<Real>::infinity();
};

SCells CollectCells(const CReportData& data, const SFigureRequest& request, size_t x, size_t y) {
  const size_t columns = data.GetLevels(x).size();
  const size_t rows = data.GetLevels(y).size();
  std::vector<std::vector<Real>> values(columns * rows);
  for (const SRunValue& value : data.ReadMetric(request.Z)) {
    if (std::isfinite(value.Value)) {
      values[data.GetLevel(value.Combination, x) * rows + data.GetLevel(value.Combination, y)]
          .push_back(value.Value);
    }
  }
  SCells cells;
  cells.Means.assign(columns, std::vector<Real>(rows, std::numeric_limits<Real>::quiet_NaN()));
  for (size_t i = 0; i < values.size(); ++i) {
    if (values[i].empty()) {
      continue;
    }
    const Real mean = ComputeMoments(values[i]).Mean;
    if (request.IsLogarithmic) {
      RequirePositive(request.Z, mean);
    }
    cells.Means[i / rows][i % rows] = mean;
    cells.Counts.push_back(values[i].size());
    cells.Least = std::min(cells.Least, mean);
    cells.Greatest = std::max(cells.Greatest, mean);
  }
  if (cells.Counts.empty()) {
    THROW_ARGOSEXCEPTION("no run has a finite value of \"" << request.Z << '"');
  }
  return cells;
}

std::string MakeData(const SCells& cells, bool isLogarithmic) {
  const auto scale = [isLogarithmic](Real value) {
    return isLogarithmic ? std::log(value) : value;
  };
  const Real middle = (scale(cells.Least) + scale(cells.Greatest)) / 2.0;
  std::string text = "# index of the x level, index of the y level, mean, color of its number\n";
  for (size_t column = 0; column < cells.Means.size(); ++column) {
    for (size_t row = 0; row < cells.Means[column].size(); ++row) {
      const Real mean = cells.Means[column][row];
      text += fmt::format("{} {} {} {}\n", column, row, FormatForGnuplot(mean),
                          scale(mean) < middle ? "0xffffff" : "0x222222");
    }
  }
  return text;
}

std::vector<std::pair<Real, std::string>> ListTics(const std::vector<std::string>& levels) {
  std::vector<std::pair<Real, std::string>> tics;
  for (const std::string& level : levels) {
    tics.emplace_back(static_cast<Real>(tics.size()), level);
  }
  return tics;
}

std::string MakeScript(const CReportData& data, const SFigureRequest& request, const SCells& cells,
                       size_t x, size_t y) {
  std::string script =
      MakeStyle(request.Title, request.XLabel.empty() ? MakeLabel(request.X, "") : request.XLabel,
                request.YLabel.empty() ? MakeLabel(request.Y, "") : request.YLabel) +
      MakeTics("x", ListTics(data.GetLevels(x))) + MakeTics("y", ListTics(data.GetLevels(y)));
  script += "set cblabel " +
            QuoteForGnuplot(MakeMetricLabel(data, request.Z, false, request.ZLabel)) +
            " noenhanced textcolor rgb '#333333'\n";
  // cividis: J. R. Nunez, C. R. Anderton and R. S. Renslow, PLOS ONE 13 (2018)
  script +=
      "unset grid\nset border 0\nset palette defined (0 '#00204c', 0.25 '#414d6b', 0.5 '#7c7b78', "
      "0.75 '#bcae6c', 1 '#ffe945')\n";
  // a palette needs a range that is not empty
  const Real margin =
      cells.Least == cells.Greatest ? std::max(std::abs(cells.Least) / 10.0, Real{1e-9}) : 0.0;
  script += request.IsLogarithmic
                ? MakeLogarithmicAxis("cb", cells.Least, cells.Greatest)
                : fmt::format("set cbrange [{}:{}]\n", FormatForGnuplot(cells.Least - margin),
                              FormatForGnuplot(cells.Greatest + margin));
  script += fmt::format("set xrange [-0.5:{}]\nset yrange [-0.5:{}]\n",
                        FormatForGnuplot(static_cast<Real>(cells.Means.size()) - 0.5),
                        FormatForGnuplot(static_cast<Real>(cells.Means.front().size()) - 0.5));
  script += fmt::format(
      "plot {} using 1:2:(0.49):(0.49):3 with boxxyerror fillstyle solid 1.0 noborder linecolor "
      "palette notitle",
      kDataName);
  if (cells.Counts.size() <= kMaxNumbers) {
    script += fmt::format(
        ", \\\n  {} using 1:2:(valid(3) ? sprintf('%.3g', $3) : ''):4 with labels noenhanced "
        "textcolor rgb variable notitle",
        kDataName);
  }
  return script + '\n';
}

}  // namespace

SFigureDraft MakeHeatmap(const CReportData& data, const SFigureRequest& request) {
  RequireName(request, "z", request.Z);
  RequireName(request, "x", request.X);
  RequireName(request, "y", request.Y);
  const size_t x = data.FindFactor(request.X);
  const size_t y = data.FindFactor(request.Y);
  if (x == y) {
    THROW_ARGOSEXCEPTION("a heatmap needs two different factors, but x and y are both \""
                         << request.X << '"');
  }
  const SCells cells = CollectCells(data, request, x, y);
  SFigureDraft draft;
  draft.Data =
      fmt::format("# {} at the levels of {} and {}\n", MakeLine(request.Z), request.X, request.Y) +
      MakeData(cells, request.IsLogarithmic);
  draft.Script = MakeScript(data, request, cells, x, y);
  draft.Caption = fmt::format(
      "{} at the levels of {} and {}: means of {} each.{}", MakeLabel(request.Z, ""), request.X,
      request.Y, DescribeCounts(cells.Counts), DescribePooled(data, {request.X, request.Y}));
  return draft;
}

}  // namespace argos
