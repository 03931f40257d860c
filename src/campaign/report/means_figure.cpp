#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/mean_points.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/campaign/report/summary_tables.h>

#include <fmt/format.h>

#include <algorithm>

namespace argos {

namespace {

std::string DescribeAxes(const SFigureRequest& request) {
  if (request.IsXLogarithmic && request.IsLogarithmic) {
    return ", logarithmic axes";
  }
  return request.IsXLogarithmic  ? ", logarithmic in " + MakeLabel(request.X, "")
         : request.IsLogarithmic ? ", logarithmic in " + MakeLabel(request.Y, "")
                                 : "";
}

// beside the curves, one below the other, unless that would leave little room for these
std::string PlaceKey(const SFigureRequest& request, const CFigureGroups& groups) {
  constexpr size_t kMaxLength = 14;
  size_t longest = request.ReferenceLabel.size();
  for (size_t group = 0; group < groups.GetCount(); ++group) {
    longest = std::max(longest, groups.GetTitle(group).size());
  }
  return longest > kMaxLength ? "set key outside top center horizontal\n"
                              : "set key outside right center vertical\n";
}

// lines, points above them, and the reference below both
std::string MakePlots(const SFigureRequest& request, const SMeans& means,
                      const CFigureGroups& groups) {
  std::string lines;
  std::string points;
  if (request.Reference) {
    const std::string key = request.ReferenceLabel.empty()
                                ? " notitle"
                                : " title " + QuoteForGnuplot(request.ReferenceLabel);
    lines = fmt::format("{} with lines dashtype 2 linewidth 1.5 linecolor rgb '#555555'{}",
                        FormatForGnuplot(*request.Reference), key);
  }
  for (size_t group = 0; group < means.Groups.size(); ++group) {
    lines +=
        fmt::format("{}{} index {} using 1:2 with lines linewidth 1.5 linecolor rgb '{}' notitle",
                    lines.empty() ? "" : ", \\\n  ", kDataName, group, GetColor(group));
    points += ", \\\n  " + MakePointsPlot(group, groups.MakeKey(group));
  }
  return "plot " + lines + points + '\n';
}

}  // namespace

SFigureDraft MakeMeansFigure(const CReportData& data, const SFigureRequest& request) {
  RequireName(request, "y", request.Y);
  RequireName(request, "x", request.X);
  if (request.Reference && request.IsLogarithmic) {
    RequirePositive("reference", *request.Reference);
  }
  const CFigureGroups groups(data, request.Group);
  const SMeans means = SMeans::Collect(data, request, groups);
  SFigureDraft draft;
  draft.Data = means.MakeData(request, groups);
  draft.Script = means.MakeFrame(data, request) + PlaceKey(request, groups) +
                 MakePlots(request, means, groups);
  draft.Caption = fmt::format(
      "{} against {}{}: means of {} each with {}.{}{}", MakeLabel(request.Y, ""),
      MakeLabel(request.X, ""), DescribeAxes(request), means.DescribePointCounts(),
      request.HasDeviationBars ? "standard deviations" : FormatLevel(kReportLevel) + " t intervals",
      means.DescribeNotPositive(), DescribePooled(data, {request.X, request.Group}));
  return draft;
}

}  // namespace argos
