#include <argos3/campaign/design/combination_filter.h>
#include <argos3/campaign/design/element_reading.h>
#include <argos3/campaign/design/figure_kinds.h>
#include <argos3/campaign/design/section_readers.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>
#include <iterator>
#include <span>

namespace argos {

namespace {

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

void CheckAxes(TConfigurationNode& node, std::span<const SFigureAxis> axes,
               const SCampaign& campaign) {
  for (const SFigureAxis& axis : axes) {
    const std::string attribute(axis.Attribute);
    if (attribute.empty() || (!axis.IsRequired && !NodeAttributeExists(node, attribute))) {
      continue;
    }
    const std::string problem = FindAxisProblem(campaign, axis.Kind, ReadText(node, attribute));
    if (!problem.empty()) {
      ThrowAt(node, "attribute \"" + attribute + "\": " + problem);
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

void ReadFigure(TConfigurationNode& node, const SFigureKind& kind, SCampaign& campaign) {
  // reads what every figure has: its data and its look
  static constexpr std::string_view kLooks[] = {"where",  "title",  "file",  "xlabel",
                                                "ylabel", "zlabel", "width", "height"};
  CheckAxes(node, kind.Axes, campaign);
  CheckSelection(node, campaign);
  SFigure figure;
  figure.Kind = node.Value();
  figure.Line = static_cast<int>(node.GetLine());
  for (const std::string& name : node.GetAttributeNames()) {
    const bool isAxis =
        std::ranges::find(kind.Axes, name, &SFigureAxis::Attribute) != kind.Axes.end();
    const bool isLook = std::ranges::find(kLooks, name) != std::end(kLooks) || kind.HasLook(name);
    // others are reported as unused
    if (isAxis || isLook) {
      CheckLook(node, name);
      figure.Attributes.emplace_back(name, ReadText(node, name));
    }
  }
  campaign.Figures.push_back(figure);
}

SComparison ReadComparison(TConfigurationNode& node, const SCampaign& campaign) {
  static constexpr SFigureAxis kAxes[] = {{"metric", EAxis::Metric}, {"factor", EAxis::Factor}};
  CheckAxes(node, kAxes, campaign);
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
  for (const SFigureKind& kind : kFigureKinds) {
    readers[std::string(kind.Name)] = [&campaign, &kind](TConfigurationNode& element) {
      ReadFigure(element, kind, campaign);
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
