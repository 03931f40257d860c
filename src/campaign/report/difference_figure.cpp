#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/series_lines.h>
#include <argos3/campaign/report/series_times.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/statistics/signed_rank_test.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace argos {

namespace {

// if there are fewer, no interval of the signed-rank test has a level of 95 %
constexpr size_t kMinPairs = 6;

// differences of the pairs at each time
typedef std::map<Real, std::vector<Real>> TDifferences;

size_t FindComparedFactor(const CReportData& data, const std::string& name) {
  const size_t factor = data.FindFactor(name);
  const size_t numLevels = data.GetLevels(factor).size();
  if (numLevels != 2) {
    THROW_ARGOSEXCEPTION("group=\"" << name << "\": the factor has " << numLevels
                                    << " levels; a difference is that of two, which \"where\" may "
                                       "select");
  }
  return factor;
}

// first level minus the second, of runs that are equal in the seed and all other factors
TDifferences ComputeDifferences(const CReportData& data, const std::string& series, size_t factor,
                                Real ticksPerSecond) {
  typedef std::pair<std::string, UInt32> TKey;  // the other factors, seed
  std::map<TKey, std::array<std::map<Real, Real>, 2>> pairs;
  for (const SRunSeries& run : data.ReadSeries(series)) {
    const TKey key(data.DescribeCombination(run.Combination, {factor}), run.Seed);
    std::map<Real, Real>& values = pairs[key][data.GetLevel(run.Combination, factor)];
    for (size_t i = 0; i < run.Series.Ticks.size(); ++i) {
      const Real tick = run.Series.Ticks[i];
      values[ticksPerSecond > 0.0 ? tick / ticksPerSecond : tick] = run.Series.Values[i];
    }
  }
  TDifferences differences;
  for (const auto& [key, values] : pairs) {
    for (const auto& [time, first] : values[0]) {
      const auto second = values[1].find(time);
      if (second != values[1].end() && !std::isnan(first - second->second)) {
        differences[time].push_back(first - second->second);
      }
    }
  }
  return differences;
}

// "30 pairs of runs" or "20 to 30 pairs of runs"
std::string DescribePairs(const std::vector<size_t>& counts) {
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  const std::string range = *least == *most ? "" : fmt::format("{} to ", *least);
  return range + Count(*most, "pair") + " of runs";
}

}  // namespace

SFigureDraft MakeDifferenceFigure(const CReportData& data, const SFigureRequest& request) {
  RequireName(request, "y", request.Y);
  RequireName(request, "group", request.Group);
  const size_t factor = FindComparedFactor(data, request.Group);
  const CFigureGroups groups(data, request.Group);
  const Real ticksPerSecond = FindTicksPerSecond(data.GetCampaign());
  const std::string timeLabel = MakeTimeLabel(ticksPerSecond);
  const std::string title = groups.GetTitle(0) + " minus " + groups.GetTitle(1);

  SFigureDraft draft;
  draft.Data = fmt::format(
      "# {}: {}\n# {}, lower bound, Hodges and Lehmann's estimate, upper bound, number of pairs\n",
      MakeLine(request.Y), MakeLine(title), timeLabel);
  std::vector<size_t> counts;
  std::vector<Real> times;
  for (const auto& [time, values] : ComputeDifferences(data, request.Y, factor, ticksPerSecond)) {
    if (values.size() < kMinPairs || (request.IsXLogarithmic && time <= 0.0)) {
      continue;
    }
    times.push_back(time);
    SRankTestOptions options;
    options.Level = kReportLevel;
    // no value is the location, so differences of 0 are kept; the interval does not change
    options.Location = *std::min_element(values.begin(), values.end()) - 1.0;
    const SRankTestResult result = TestSignedRank(values, options);
    draft.Data += fmt::format(
        "{} {} {} {} {}\n", FormatForGnuplot(time), FormatForGnuplot(result.Interval.Lower),
        FormatForGnuplot(result.Estimate), FormatForGnuplot(result.Interval.Upper), values.size());
    counts.push_back(values.size());
  }
  if (counts.empty()) {
    THROW_ARGOSEXCEPTION("at no time there are " << kMinPairs
                                                 << " pairs of runs that are done and have "
                                                    "values of the series \""
                                                 << request.Y << '"');
  }
  draft.Script =
      MakeStyle(request.Title, request.XLabel.empty() ? timeLabel : request.XLabel,
                request.YLabel.empty() ? MakeMetricLabel(data, request.Y, true, "") + ", difference"
                                       : request.YLabel) +
      (request.IsXLogarithmic ? MakeLogarithmicAxis("x", times.front(), times.back()) : "") +
      "set offsets 0, 0, graph 0.05, graph 0.05\n" +
      fmt::format(
          "plot {0} using 1:2:4 with filledcurves fillstyle transparent solid 0.2 noborder "
          "linecolor rgb '{1}' notitle, \\\n  0 with lines linecolor rgb 'gray40' "
          "dashtype 2 notitle, \\\n  {0} using 1:3 with lines linewidth 2 linecolor rgb "
          "'{1}' title {2}\n",
          kDataName, GetColor(0), QuoteForGnuplot(title));
  draft.Caption = fmt::format(
      "{} over time, {}: Hodges and Lehmann's estimate (line) and its {} interval (band) from "
      "Wilcoxon's signed-rank test at each time, of {} that are equal in the seed and the other "
      "factors.",
      MakeLabel(request.Y, ""), title, FormatLevel(kReportLevel), DescribePairs(counts));
  return draft;
}

}  // namespace argos
