#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/mean_points.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>
#include <argos3/campaign/statistics/power_law_fit.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace argos {

namespace {

// None with too few values, or equal x. Runs that are not positive have no logarithm, and a law
// that is fitted to the others is too high: then means are fitted, in all groups, so that exponents
// can be compared.
std::optional<SPowerLawFit> Fit(const SGroupMeans& group, bool isOfMeans) {
  if (group.Points.size() < 2) {
    return std::nullopt;
  }
  if (!isOfMeans) {
    return group.X.size() >= 3 ? FitPowerLaw(group.X, group.Y, kReportLevel)
                               : std::optional<SPowerLawFit>();
  }
  const bool hasDeviations =
      std::all_of(group.Samples.begin(), group.Samples.end(),
                  [](const SPowerLawSample& sample) { return sample.Y.size() >= 2; });
  return hasDeviations ? FitPowerLawOfMeans(group.Samples, kReportLevel)
                       : std::optional<SPowerLawFit>();
}

std::string DescribeExponent(const SPowerLawFit& fit) {
  return fmt::format("exponent {:.3g} ({:.3g} to {:.3g})", fit.Exponent, fit.ExponentInterval.Lower,
                     fit.ExponentInterval.Upper);
}

std::string MakePlots(const SMeans& means, const CFigureGroups& groups) {
  std::string text;
  for (size_t group = 0; group < means.Groups.size(); ++group) {
    const std::vector<SMeanPoint>& points = means.Groups[group].Points;
    const std::optional<SPowerLawFit> fit = Fit(means.Groups[group], means.NumRunsNotPositive > 0);
    text += (group == 0 ? "plot " : ", \\\n  ") +
            MakePointsPlot(group, groups.MakeKey(group, fit ? DescribeExponent(*fit) : ""));
    if (fit) {
      text += fmt::format(
          ", \\\n  [{}:{}] {} * x ** {} with lines dashtype 2 linewidth 1.5 linecolor rgb '{}' "
          "notitle",
          FormatForGnuplot(points.front().X), FormatForGnuplot(points.back().X),
          FormatForGnuplot(fit->Factor), fmt::format("({})", FormatForGnuplot(fit->Exponent)),
          GetColor(group));
    }
  }
  return text + '\n';
}

}  // namespace

SFigureDraft MakeScalingFigure(const CReportData& data, const SFigureRequest& request) {
  RequireName(request, "y", request.Y);
  RequireName(request, "x", request.X);
  SFigureRequest logarithmic = request;
  logarithmic.IsLogarithmic = logarithmic.IsXLogarithmic = true;
  const CFigureGroups groups(data, request.Group);
  const SMeans means = SMeans::Collect(data, logarithmic, groups);
  SFigureDraft draft;
  draft.Data = means.MakeData(logarithmic, groups);
  draft.Script = means.MakeFrame(data, logarithmic) + MakePlots(means, groups);
  draft.Caption = fmt::format(
      "{} against {}, logarithmic axes: means of {} each with {} t intervals, and power laws "
      "fitted to the {}; exponents with their {} intervals.{}{}",
      MakeLabel(request.Y, ""), MakeLabel(request.X, ""), means.DescribePointCounts(),
      FormatLevel(kReportLevel), means.NumRunsNotPositive > 0 ? "means" : "runs",
      FormatLevel(kReportLevel), means.DescribeNotPositive(),
      DescribePooled(data, {request.X, request.Group}));
  return draft;
}

}  // namespace argos
