#include <argos3/campaign/report/figures.h>

#include <argos3/campaign/design/combination_filter.h>
#include <argos3/campaign/design/figure_kinds.h>
#include <argos3/campaign/report/figure_parts.h>
#include <argos3/campaign/report/gnuplot_text.h>
#include <argos3/campaign/report/report_text.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/text/lists.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace argos {

CFigureGroups::CFigureGroups(const CReportData& data, const std::string& factor) : m_data(data) {
  if (factor.empty()) {
    return;
  }
  m_factor = data.FindFactor(factor);
  if (GetCount() > kMaxColors) {
    THROW_ARGOSEXCEPTION("group=\"" << factor << "\": the factor has " << GetCount()
                                    << " levels; the colours of at most " << kMaxColors
                                    << " groups can be told apart");
  }
}

size_t CFigureGroups::GetGroup(size_t combination) const {
  return m_factor ? m_data.GetLevel(combination, *m_factor) : 0;
}

std::string CFigureGroups::GetTitle(size_t group) const {
  return m_factor ? m_data.GetCampaign().Factors[*m_factor].Name + " = " +
                        m_data.GetLevels(*m_factor).at(group)
                  : "";
}

std::string CFigureGroups::MakeKey(size_t group, const std::string& addition) const {
  const std::string title = GetTitle(group);
  const std::string text =
      title.empty() || addition.empty() ? title + addition : title + ": " + addition;
  return text.empty() ? " notitle" : " title " + QuoteForGnuplot(text);
}

void RequireName(const SFigureRequest& request, const char* attribute, const std::string& value) {
  if (value.empty()) {
    THROW_ARGOSEXCEPTION("a figure of the kind " << request.Kind << " needs " << attribute);
  }
}

void RequirePositive(const std::string& metric, Real value) {
  if (value <= 0.0) {
    THROW_ARGOSEXCEPTION("\"" << metric << "\" has the value " << value
                              << ", which a logarithmic axis cannot show");
  }
}

std::string MakeMetricLabel(const CReportData& data, const std::string& name, bool isSeries,
                            const std::string& wanted) {
  return wanted.empty() ? MakeLabel(name, data.GetStore().GetUnit(name, isSeries)) : wanted;
}

std::string MakeValueAxis(Real low, Real high) {
  // values at the end of an axis would be cut; offsets would move a given bound, too
  const char* const kSpace = "set offsets 0, 0, graph 0.05, graph 0.05\n";
  if (!(low >= 0.0)) {
    return kSpace;
  }
  return low <= high / 2.0 && high > 0.0 ? "set offsets 0, 0, graph 0.05, 0\nset yrange [0:*]\n"
                                         : std::string(kSpace) + "set yrange [0 < * : *]\n";
}

std::string DescribePooled(const CReportData& data, const std::vector<std::string>& shown) {
  std::string names;
  for (size_t factor = 0; factor < data.GetCampaign().Factors.size(); ++factor) {
    const std::string& name = data.GetCampaign().Factors[factor].Name;
    if (data.GetLevels(factor).size() > 1 &&
        std::find(shown.begin(), shown.end(), name) == shown.end()) {
      AppendItem(names, name);
    }
  }
  return names.empty() ? "" : " Runs at all levels of " + names + " are taken together.";
}

std::string DescribeCounts(const std::vector<size_t>& counts) {
  const auto [least, most] = std::minmax_element(counts.begin(), counts.end());
  return *least == *most ? Count(*most, "run")
                         : fmt::format("{} to {}", *least, Count(*most, "run"));
}

namespace {

struct SFigureMaker {
  std::string_view Kind;
  SFigureDraft (*Make)(const CReportData&, const SFigureRequest&);
};

constexpr SFigureMaker kMakers[] = {{"boxplot", &MakeBoxplot},
                                    {"series", &MakeSeriesFigure},
                                    {"difference", &MakeDifferenceFigure},
                                    {"means", &MakeMeansFigure},
                                    {"scaling", &MakeScalingFigure},
                                    {"heatmap", &MakeHeatmap}};
static_assert(std::ranges::equal(kMakers, kFigureKinds, {}, &SFigureMaker::Kind,
                                 &SFigureKind::Name),
              "each kind of figure has a function, in the order of kFigureKinds");

}  // namespace

SFigureDraft MakeFigure(const CReportData& data, const SFigureRequest& request) {
  if (!request.Where.empty()) {
    const SCampaign part = SelectCombinations(data.GetCampaign(), request.Where);
    SFigureRequest ofPart = request;
    ofPart.Where.clear();
    SFigureDraft draft = MakeFigure(CReportData(part, data.GetStore()), ofPart);
    draft.Caption += " Only runs with " + MakeLine(request.Where) + '.';
    return draft;
  }
  std::vector<std::string> known;
  for (const SFigureMaker& maker : kMakers) {
    if (request.Kind == maker.Kind) {
      return maker.Make(data, request);
    }
    known.emplace_back(maker.Kind);
  }
  THROW_ARGOSEXCEPTION("there is no kind of figure \"" << request.Kind << '"'
                                                       << DidYouMean(request.Kind, known));
}

std::string MakeFigureName(const SFigureRequest& request) {
  std::string name = request.File;
  if (name.empty()) {
    name = request.Kind;
    for (const std::string* part : {&request.Z, &request.Y, &request.X, &request.Group}) {
      name += part->empty() ? "" : '_' + *part;
    }
  }
  constexpr size_t kMaxLength = 100;
  name.resize(std::min(name.size(), kMaxLength));
  for (char& c : name) {
    const bool isPlain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                         (c >= '0' && c <= '9') || c == '_' || c == '-';
    c = isPlain ? c : '-';
  }
  return name;
}

}  // namespace argos
