#include <argos3/campaign/report/mean_points.h>

#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/moments.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace argos {

namespace {

// where x comes from
class CPointAxis {
 public:
  CPointAxis(const CReportData& data, const std::string& name) {
    const std::vector<std::string> metrics = data.GetStore().ListMetrics();
    const auto& factors = data.GetCampaign().Factors;
    const bool isFactor = std::ranges::find(factors, name, &SFactor::Name) != factors.end();
    if (!isFactor && std::find(metrics.begin(), metrics.end(), name) != metrics.end()) {
      for (const SRunValue& value : data.ReadMetric(name)) {
        m_values[{value.Combination, value.Seed}] = value.Value;
      }
      m_isMetric = true;
      return;
    }
    const size_t factor = data.FindFactor(name);
    std::vector<Real> levels;
    if (!ParseLevels(data.GetLevels(factor), levels)) {
      THROW_ARGOSEXCEPTION("x=\"" << name << "\": the levels of the factor are not all numbers");
    }
    for (size_t i = 0; i < data.GetCampaign().Combinations.size(); ++i) {
      m_levels.push_back(levels[data.GetLevel(i, factor)]);
    }
  }

  bool IsMetric() const { return m_isMetric; }
  Real GetX(const SRunValue& run) const {
    return m_isMetric ? m_values.at({run.Combination, run.Seed}) : m_levels[run.Combination];
  }

 private:
  bool m_isMetric = false;
  std::vector<Real> m_levels;  // (combinations), of a factor
  std::map<std::pair<size_t, UInt32>, Real> m_values;  // values of a metric by combination and seed
};

SMeanPoint MakePoint(const std::vector<Real>& x, const std::vector<Real>& y,
                     bool hasDeviationBars) {
  const SMoments moments = ComputeMoments(y);
  SMeanPoint point{ComputeMoments(x).Mean, moments.Mean, moments.Mean, moments.Mean, y.size()};
  if (y.size() < 2) {
    return point;
  }
  if (hasDeviationBars) {
    point.Lower -= moments.StandardDeviation;
    point.Upper += moments.StandardDeviation;
  } else {
    const SConfidenceInterval interval = ComputeMeanInterval(y, kReportLevel);
    point.Lower = interval.Lower;
    point.Upper = interval.Upper;
  }
  return point;
}

// a logarithmic axis has no place for bounds that are not positive: such bars end below all others
void LimitBars(std::vector<SGroupMeans>& groups) {
  constexpr Real kBelowMean = 0.2;
  Real least = std::numeric_limits<Real>::infinity();
  for (const SGroupMeans& group : groups) {
    for (const SMeanPoint& point : group.Points) {
      least = std::min(least, point.Lower > 0.0 ? point.Lower : kBelowMean * point.Mean);
    }
  }
  for (SGroupMeans& group : groups) {
    for (SMeanPoint& point : group.Points) {
      point.Lower = std::max(point.Lower, least);
    }
  }
}

// removes means that a logarithmic axis cannot show
void KeepPositive(const std::string& metric, SMeans& means) {
  size_t numKept = 0;
  for (SGroupMeans& group : means.Groups) {
    const size_t count = group.Points.size();
    std::erase_if(group.Samples, [](const SPowerLawSample& sample) {
      return ComputeMoments(sample.Y).Mean <= 0.0;
    });
    std::erase_if(group.Points, [](const SMeanPoint& point) { return point.Mean <= 0.0; });
    means.NumMeansNotPositive += count - group.Points.size();
    means.NumRunsNotPositive += static_cast<size_t>(
        std::count_if(group.Y.begin(), group.Y.end(), [](Real value) { return value <= 0.0; }));
    numKept += group.Points.size();
  }
  if (numKept == 0) {
    THROW_ARGOSEXCEPTION("no mean of \""
                         << metric << "\" is positive, and a logarithmic axis shows no other");
  }
}

std::string MakeLinearAxis(Real low, Real high) {
  constexpr Real kLinearMargin = 0.05;
  const Real margin = high > low ? kLinearMargin * (high - low) : 1.0;
  return fmt::format("set xrange [{}:{}]\n", FormatForGnuplot(low - margin),
                     FormatForGnuplot(high + margin));
}

}  // namespace

SMeans SMeans::Collect(const CReportData& data, const SFigureRequest& request,
                       const CFigureGroups& groups) {
  typedef std::pair<std::vector<Real>, std::vector<Real>> TSample;
  const CPointAxis axis(data, request.X);
  SMeans means;
  means.IsXMetric = axis.IsMetric();
  means.Groups.resize(groups.GetCount());
  // runs are of one point if they have the same level, or, with a metric, the same combination
  std::vector<std::map<Real, TSample>> samples(groups.GetCount());
  bool isEmpty = true;
  for (const SRunValue& run : data.ReadMetric(request.Y)) {
    const Real x = axis.GetX(run);
    if (!std::isfinite(run.Value) || !std::isfinite(x)) {
      continue;
    }
    if (request.IsXLogarithmic) {
      RequirePositive(request.X, x);
    }
    isEmpty = false;
    const size_t group = groups.GetGroup(run.Combination);
    TSample& sample = samples[group][axis.IsMetric() ? static_cast<Real>(run.Combination) : x];
    sample.first.push_back(x);
    sample.second.push_back(run.Value);
    means.Groups[group].X.push_back(x);
    means.Groups[group].Y.push_back(run.Value);
  }
  if (isEmpty) {
    THROW_ARGOSEXCEPTION("no run has finite values of \"" << request.Y << "\" and \"" << request.X
                                                          << '"');
  }
  for (size_t group = 0; group < samples.size(); ++group) {
    std::vector<SMeanPoint>& points = means.Groups[group].Points;
    std::vector<SPowerLawSample>& runs = means.Groups[group].Samples;
    for (auto& [key, sample] : samples[group]) {
      points.push_back(MakePoint(sample.first, sample.second, request.HasDeviationBars));
      runs.push_back({points.back().X, std::move(sample.second)});
    }
    std::ranges::stable_sort(points, {}, &SMeanPoint::X);
    std::ranges::stable_sort(runs, {}, &SPowerLawSample::X);
  }
  if (request.IsLogarithmic) {
    KeepPositive(request.Y, means);
    LimitBars(means.Groups);
  }
  return means;
}

std::string SMeans::MakeData(const SFigureRequest& request, const CFigureGroups& groups) const {
  std::string text =
      fmt::format("# {} against {}: a block for each group\n# x, mean, {}, number of runs\n",
                  MakeLine(request.Y), MakeLine(request.X),
                  request.HasDeviationBars ? "mean - and + standard deviation"
                                           : "lower and upper bound of its t interval");
  for (size_t group = 0; group < Groups.size(); ++group) {
    text += "# " + MakeLine(groups.GetTitle(group)) + '\n';
    for (const SMeanPoint& point : Groups[group].Points) {
      text +=
          fmt::format("{} {} {} {} {}\n", FormatForGnuplot(point.X), FormatForGnuplot(point.Mean),
                      FormatForGnuplot(point.Lower), FormatForGnuplot(point.Upper), point.Count);
    }
    text += Groups[group].Points.empty() ? "NaN NaN NaN NaN 0\n\n\n" : "\n\n";
  }
  return text;
}

// tics of x are the levels themselves if they are few
std::string SMeans::MakeFrame(const CReportData& data, const SFigureRequest& request) const {
  constexpr size_t kMaxLabels = 9;
  std::map<Real, std::string> levels;
  Real low = request.Reference.value_or(std::numeric_limits<Real>::infinity());
  Real high = request.Reference.value_or(-std::numeric_limits<Real>::infinity());
  bool isNegative = low < 0.0;
  for (const SGroupMeans& group : Groups) {
    isNegative = isNegative || std::ranges::any_of(group.Y, [](Real value) { return value < 0.0; });
    for (const SMeanPoint& point : group.Points) {
      levels[point.X] = FormatNumber(point.X);
      low = std::min(low, point.Lower);
      high = std::max(high, point.Upper);
    }
  }
  // an interval may reach below 0 though no run does
  low = isNegative ? low : std::max(low, 0.0);
  const std::string xLabel =
      IsXMetric ? MakeMetricLabel(data, request.X, false, "") : MakeLabel(request.X, "");
  const bool hasLevels = !IsXMetric && levels.size() <= kMaxLabels;
  return MakeStyle(request.Title, request.XLabel.empty() ? xLabel : request.XLabel,
                   MakeMetricLabel(data, request.Y, false, request.YLabel)) +
         (request.IsXLogarithmic
              ? MakeLogarithmicAxis("x", levels.begin()->first / kLogarithmicMargin,
                                    levels.rbegin()->first * kLogarithmicMargin)
              : MakeLinearAxis(levels.begin()->first, levels.rbegin()->first)) +
         (hasLevels ? MakeTics("x", {levels.begin(), levels.end()}) : "") +
         (request.IsLogarithmic
              ? MakeLogarithmicAxis("y", low / kLogarithmicMargin, high * kLogarithmicMargin)
              : MakeValueAxis(low, high));
}

std::string SMeans::DescribePointCounts() const {
  std::vector<size_t> counts;
  for (const SGroupMeans& group : Groups) {
    for (const SMeanPoint& point : group.Points) {
      counts.push_back(point.Count);
    }
  }
  return DescribeCounts(counts);
}

std::string SMeans::DescribeNotPositive() const {
  std::string text;
  if (NumRunsNotPositive > 0) {
    text += fmt::format(
        " {} with values of 0 or less: they count in the means, and bars that would reach 0 end at "
        "the lower edge.",
        Count(NumRunsNotPositive, "run"));
  }
  if (NumMeansNotPositive > 0) {
    text += fmt::format(" {} of 0 or less left out.", Count(NumMeansNotPositive, "mean"));
  }
  return text;
}

std::string MakePointsPlot(size_t group, const std::string& key) {
  return fmt::format(
      "{} index {} using 1:2:3:4 with yerrorbars pointtype 7 pointsize 0.8 linewidth 1.2 "
      "linecolor rgb '{}'{}",
      kDataName, group, GetColor(group), key);
}

}  // namespace argos
