#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/statistics/quantile.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

constexpr Real kWhiskerRanges = 1.5;  // Tukey's, in interquartile ranges
constexpr Real kGroupsWidth = 0.8;  // width of the boxes of a level; levels are 1 apart
constexpr Real kWidestBox = 0.45;

struct SBox {
  Real LowerWhisker, LowerQuartile, Median, UpperQuartile, UpperWhisker;
};

SBox ComputeBox(const std::vector<Real>& sorted) {
  SBox box{sorted.front(), ComputeQuantile(sorted, 0.25), ComputeMedian(sorted),
           ComputeQuantile(sorted, 0.75), sorted.back()};
  const Real reach = kWhiskerRanges * (box.UpperQuartile - box.LowerQuartile);
  for (const Real value : sorted) {
    if (value >= box.LowerQuartile - reach) {
      box.LowerWhisker = std::min(value, box.LowerQuartile);
      break;
    }
  }
  for (auto value = sorted.rbegin(); value != sorted.rend(); ++value) {
    if (*value <= box.UpperQuartile + reach) {
      box.UpperWhisker = std::max(*value, box.UpperQuartile);
      break;
    }
  }
  return box;
}

// (groups, levels): the values, ascending
typedef std::vector<std::vector<std::vector<Real>>> TSamples;

TSamples CollectSamples(const CReportData& data, const SFigureRequest& request, size_t factor,
                        const CFigureGroups& groups) {
  TSamples samples(groups.GetCount(),
                   std::vector<std::vector<Real>>(data.GetLevels(factor).size()));
  bool isEmpty = true;
  for (const SRunValue& value : data.ReadMetric(request.Y)) {
    if (!std::isfinite(value.Value)) {
      continue;
    }
    if (request.IsLogarithmic) {
      RequirePositive(request.Y, value.Value);
    }
    isEmpty = false;
    samples[groups.GetGroup(value.Combination)][data.GetLevel(value.Combination, factor)].push_back(
        value.Value);
  }
  if (isEmpty) {
    THROW_ARGOSEXCEPTION("no run has a finite value of \"" << request.Y << '"');
  }
  for (auto& levels : samples) {
    for (std::vector<Real>& values : levels) {
      values = Sorted(values);
    }
  }
  return samples;
}

struct SRange {
  Real Low = std::numeric_limits<Real>::infinity();
  Real High = -std::numeric_limits<Real>::infinity();
};

SRange FindRange(const TSamples& samples) {
  SRange range;
  for (const auto& levels : samples) {
    for (const std::vector<Real>& values : levels) {
      if (!values.empty()) {
        range.Low = std::min(range.Low, values.front());
        range.High = std::max(range.High, values.back());
      }
    }
  }
  return range;
}

// spreads the points of a box over its width, the same way each time
Real GetJitter(size_t index) {
  constexpr Real kGoldenRatio = 0.6180339887498949;
  const Real share = kGoldenRatio * static_cast<Real>(index + 1);
  return share - std::floor(share) - 0.5;
}

std::string MakeBoxes(const std::vector<std::vector<Real>>& levels, Real offset) {
  std::string text;
  for (size_t level = 0; level < levels.size(); ++level) {
    const std::string position = FormatForGnuplot(static_cast<Real>(level) + offset);
    if (levels[level].empty()) {
      text += position + " NaN NaN NaN NaN NaN 0\n";
      continue;
    }
    const SBox box = ComputeBox(levels[level]);
    text += position;
    for (const Real number :
         {box.LowerWhisker, box.LowerQuartile, box.Median, box.UpperQuartile, box.UpperWhisker}) {
      text += ' ' + FormatForGnuplot(number);
    }
    text += fmt::format(" {}\n", levels[level].size());
  }
  return text + "\n\n";
}

std::string MakePoints(const std::vector<std::vector<Real>>& levels, Real offset, Real width) {
  std::string text;
  for (size_t level = 0; level < levels.size(); ++level) {
    for (size_t i = 0; i < levels[level].size(); ++i) {
      text += fmt::format(
          "{} {}\n",
          FormatForGnuplot(static_cast<Real>(level) + offset + 0.6 * width * GetJitter(i)),
          FormatForGnuplot(levels[level][i]));
    }
  }
  return (text.empty() ? "NaN NaN\n" : text) + "\n\n";
}

// draws a group: box and whiskers, the median as a thicker line, the values
std::string MakePlot(const CFigureGroups& groups, size_t group, bool hasPoints) {
  const char* const color = GetColor(group);
  std::string plot = fmt::format(
      "{0} index {1} using 1:3:2:6:5 with candlesticks whiskerbars 0.4 fillstyle solid 0.25 border "
      "rgb '{2}' linecolor rgb '{2}' linewidth 1.2{3}, \\\n  {0} index {1} using 1:4:4:4:4 with "
      "candlesticks linecolor rgb '{2}' linewidth 3 notitle",
      kDataName, 2 * group, color, groups.MakeKey(group));
  if (hasPoints) {
    plot += fmt::format(
        ", \\\n  {} index {} using 1:2 with points pointtype 7 pointsize 0.35 linecolor rgb "
        "'#80{}' notitle",
        kDataName, 2 * group + 1, color + 1);
  }
  return plot;
}

std::string MakeScript(const CReportData& data, const SFigureRequest& request, size_t factor,
                       const CFigureGroups& groups, const TSamples& samples, Real width,
                       bool hasPoints) {
  const SRange range = FindRange(samples);
  std::vector<std::pair<Real, std::string>> tics;
  for (const std::string& level : data.GetLevels(factor)) {
    tics.emplace_back(static_cast<Real>(tics.size()), level);
  }
  std::string script =
      MakeStyle(request.Title, request.XLabel.empty() ? MakeLabel(request.X, "") : request.XLabel,
                MakeMetricLabel(data, request.Y, false, request.YLabel)) +
      MakeTics("x", tics);
  script += fmt::format("set boxwidth {}\nset xrange [-0.6:{}]\n", FormatForGnuplot(width),
                        FormatForGnuplot(static_cast<Real>(tics.size()) - 0.4));
  script += request.IsLogarithmic ? MakeLogarithmicAxis("y", range.Low / kLogarithmicMargin,
                                                        range.High * kLogarithmicMargin)
                                  : MakeValueAxis(range.Low, range.High);
  for (size_t group = 0; group < groups.GetCount(); ++group) {
    script += (group == 0 ? "plot " : ", \\\n  ") + MakePlot(groups, group, hasPoints);
  }
  return script + '\n';
}

}  // namespace

SFigureDraft MakeBoxplot(const CReportData& data, const SFigureRequest& request) {
  constexpr size_t kMaxPoints = 100;  // points of a box; more hide it
  RequireName(request, "y", request.Y);
  RequireName(request, "x", request.X);
  const size_t factor = data.FindFactor(request.X);
  const CFigureGroups groups(data, request.Group);
  const TSamples samples = CollectSamples(data, request, factor, groups);
  const auto count = static_cast<Real>(groups.GetCount());
  const Real step = kGroupsWidth / count;
  const Real width = std::min(0.85 * step, kWidestBox);

  SFigureDraft draft;
  draft.Data = fmt::format("# {} against {}: a box for each level, then its values\n",
                           MakeLine(request.Y), request.X);
  std::vector<size_t> counts;
  bool hasPoints = true;
  for (size_t group = 0; group < samples.size(); ++group) {
    const Real offset = (static_cast<Real>(group) - (count - 1.0) / 2.0) * step;
    draft.Data += "# " + MakeLine(groups.GetTitle(group)) +
                  "\n# position, lower whisker, lower quartile, median, upper quartile, upper "
                  "whisker, number of values\n" +
                  MakeBoxes(samples[group], offset) + "# position, value\n" +
                  MakePoints(samples[group], offset, width);
    for (const std::vector<Real>& values : samples[group]) {
      if (!values.empty()) {
        counts.push_back(values.size());
      }
      hasPoints = hasPoints && values.size() <= kMaxPoints;
    }
  }
  draft.Script = MakeScript(data, request, factor, groups, samples, width, hasPoints);
  draft.Caption = fmt::format(
      "{} against {}: medians and quartiles of {} each; whiskers reach the last values within 1.5 "
      "interquartile ranges of the box.{}{}",
      MakeLabel(request.Y, ""), request.X, DescribeCounts(counts),
      hasPoints ? " Points are the runs." : "", DescribePooled(data, {request.X, request.Group}));
  return draft;
}

}  // namespace argos
