#include <argos3/campaign/design/combination_filter.h>
#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/design/section_readers.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <map>

namespace argos {

namespace {

// kinds of things that an attribute of a figure names
enum class EAxis { Metric, Series, Factor, FactorOrMetric };

struct SAxis {
  std::string Attribute;
  EAxis Kind;
  bool IsRequired;
};

struct SFigureKind {
  std::vector<SAxis> Axes;
  std::vector<std::string> OwnLooks; /**< attributes besides those of all kinds */
};

const std::map<std::string, SFigureKind>& ListFigureKinds() {
  static const std::vector<SAxis> kPoints = {{"y", EAxis::Metric, true},
                                             {"x", EAxis::FactorOrMetric, true},
                                             {"group", EAxis::Factor, false}};
  static const std::map<std::string, SFigureKind> kKinds = {
      {"boxplot",
       {{{"y", EAxis::Metric, true}, {"x", EAxis::Factor, true}, {"group", EAxis::Factor, false}},
        {"scale"}}},
      {"series",
       {{{"y", EAxis::Series, true}, {"group", EAxis::Factor, false}},
        {"scale", "xscale", "band", "ended"}}},
      {"difference", {{{"y", EAxis::Series, true}, {"group", EAxis::Factor, true}}, {"xscale"}}},
      {"means", {kPoints, {"scale", "xscale", "bars", "reference", "reference_label"}}},
      {"scaling", {kPoints, {}}},
      {"heatmap",
       {{{"z", EAxis::Metric, true}, {"x", EAxis::Factor, true}, {"y", EAxis::Factor, true}},
        {"scale"}}}};
  return kKinds;
}

std::string FindFactorProblem(const SCampaign& campaign, const std::string& name) {
  const std::vector<std::string> names = campaign.ListFactors();
  return std::find(names.begin(), names.end(), name) != names.end()
             ? ""
             : "there is no factor \"" + name + '"' + DidYouMean(name, names);
}

std::string FindAxisProblem(const SCampaign& campaign, EAxis kind, const std::string& name) {
  std::string factorProblem = FindFactorProblem(campaign, name);
  switch (kind) {
    case EAxis::Factor:
      return factorProblem;
    case EAxis::FactorOrMetric:
      return factorProblem.empty() || FindMetricProblem(campaign, name, false).empty()
                 ? ""
                 : factorProblem;
    default:
      return FindMetricProblem(campaign, name, kind == EAxis::Series);
  }
}

void CheckAxes(TConfigurationNode& node, const std::vector<SAxis>& axes,
               const SCampaign& campaign) {
  for (const SAxis& axis : axes) {
    if (!axis.IsRequired && !NodeAttributeExists(node, axis.Attribute)) {
      continue;
    }
    const std::string problem =
        FindAxisProblem(campaign, axis.Kind, ReadText(node, axis.Attribute));
    if (!problem.empty()) {
      ThrowAt(node, "attribute \"" + axis.Attribute + "\": " + problem);
    }
  }
}

void CheckSelection(TConfigurationNode& node, const SCampaign& campaign) {
  const std::string where = ReadOptionalText(node, "where");
  // there are none if factors have errors
  if (where.empty() || campaign.Combinations.empty()) {
    return;
  }
  try {
    SelectCombinations(campaign, where);
  } catch (const CARGoSException& error) {
    ThrowAt(node, "attribute \"where\": " + WithoutMark(error));
  }
}

void CheckLook(TConfigurationNode& node, const std::string& name) {
  if (name == "scale" || name == "xscale") {
    ReadChoice(node, name, {"linear", "log"});
  } else if (name == "bars") {
    ReadChoice(node, name, {"interval", "deviation"});
  } else if (name == "band") {
    ReadChoice(node, name, {"quartiles", "interval"});
  } else if (name == "ended") {
    ReadChoice(node, name, {"survivors", "hold", "drop"});
  } else if (name == "reference") {
    Real reference = 0.0;
    GetNodeAttribute(node, name, reference);
  } else if (name == "width" || name == "height") {
    UInt32 side = 0;
    GetNodeAttribute(node, name, side);
    if (side < SFigure::kMinSide || side > SFigure::kMaxSide) {
      ThrowAt(node, "attribute \"" + name + "\": expected a number of pixels from " +
                        std::to_string(SFigure::kMinSide) + " to " +
                        std::to_string(SFigure::kMaxSide) + ", found " + std::to_string(side));
    }
  }
}

bool IsOneOf(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void ReadFigure(TConfigurationNode& node, const SFigureKind& kind, SCampaign& campaign) {
  // reads what every figure has: its data and its look
  static const std::vector<std::string> kLooks = {"where",  "title",  "file",  "xlabel",
                                                  "ylabel", "zlabel", "width", "height"};
  CheckAxes(node, kind.Axes, campaign);
  CheckSelection(node, campaign);
  SFigure figure;
  figure.Kind = node.Value();
  figure.Line = static_cast<int>(node.GetLine());
  for (const std::string& name : node.GetAttributeNames()) {
    const bool isAxis = std::ranges::find(kind.Axes, name, &SAxis::Attribute) != kind.Axes.end();
    // others are reported as unused
    if (isAxis || IsOneOf(name, kLooks) || IsOneOf(name, kind.OwnLooks)) {
      CheckLook(node, name);
      figure.Attributes.emplace_back(name, ReadText(node, name));
    }
  }
  campaign.Figures.push_back(figure);
}

SComparison ReadComparison(TConfigurationNode& node, const SCampaign& campaign) {
  CheckAxes(node, {{"metric", EAxis::Metric, true}, {"factor", EAxis::Factor, true}}, campaign);
  SComparison comparison;
  comparison.Metric = ReadText(node, "metric");
  comparison.Factor = ReadText(node, "factor");
  GetNodeAttributeOrDefault(node, "paired", comparison.IsPaired, false);
  comparison.Line = static_cast<int>(node.GetLine());
  for (const SFactor& factor : campaign.Factors) {
    if (factor.Name == comparison.Factor && factor.Levels.size() < 2) {
      ThrowAt(node, "attribute \"factor\": \"" + factor.Name +
                        "\" has one value only: there is nothing to compare");
    }
  }
  return comparison;
}

}  // namespace

void ReadFigures(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign) {
  TChildReaders readers;
  for (const auto& [tag, kind] : ListFigureKinds()) {
    const SFigureKind& ofTag = kind;
    readers[tag] = [&campaign, &ofTag](TConfigurationNode& element) {
      ReadFigure(element, ofTag, campaign);
    };
  }
  ReadChildren(errors, node, readers);
}

void ReadTests(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign) {
  const auto readComparison = [&campaign](TConfigurationNode& element) {
    campaign.Comparisons.push_back(ReadComparison(element, campaign));
  };
  ReadChildren(errors, node, {{"compare", readComparison}});
}

void ReadSlurm(CLoadErrors& errors, TConfigurationNode& node, SCampaign& campaign) {
  errors.Try("", [&] { campaign.Slurm.Tasks = ReadCount(node, "tasks", 1, 1); });
  errors.Try("", [&] { campaign.Slurm.Jobs = ReadCount(node, "jobs", 1, 1); });
  errors.Try("", [&] {
    campaign.Slurm.Resubmissions = ReadCount(node, "resubmit", 0, campaign.Slurm.Resubmissions);
  });
  errors.Try("", [&] { campaign.Slurm.Account = ReadOptionalText(node, "account"); });
  errors.Try("", [&] { campaign.Slurm.Partition = ReadOptionalText(node, "partition"); });
  errors.Try("", [&] { campaign.Slurm.TimeLimit = ReadOptionalText(node, "time"); });
  errors.Try("", [&] { campaign.Slurm.MemoryPerTask = ReadOptionalText(node, "memory_per_task"); });
  const auto readOption = [&campaign](TConfigurationNode& element) {
    campaign.Slurm.Options.push_back(ReadText(element, "value"));
  };
  ReadChildren(errors, node, {{"option", readOption}});
}

}  // namespace argos
