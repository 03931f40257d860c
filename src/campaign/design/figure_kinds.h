#ifndef ARGOS3_CAMPAIGN_DESIGN_FIGURE_KINDS_H
#define ARGOS3_CAMPAIGN_DESIGN_FIGURE_KINDS_H

#include <algorithm>
#include <array>
#include <string_view>

namespace argos {

/** Kinds of things that an attribute of a figure names. */
enum class EAxis { Metric, Series, Factor, FactorOrMetric };

/** An attribute of a figure that says what is shown. */
struct SFigureAxis {
  std::string_view Attribute; /**< empty: there is none, in the rest of an array */
  EAxis Kind = EAxis::Metric;
  bool IsRequired = true;
};

/** A kind of figure of the campaign file, and of --plot. */
struct SFigureKind {
  std::string_view Name; /**< also the tag */
  std::array<SFigureAxis, 3> Axes;
  std::array<std::string_view, 5> Looks; /**< attributes besides those of all kinds */

  constexpr bool HasLook(std::string_view attribute) const {
    return std::ranges::find(Looks, attribute) != Looks.end();
  }
};

/** All kinds. report/figures.cpp has the function of each one, in the same order. */
inline constexpr SFigureKind kFigureKinds[] = {
    {"boxplot", {{{"y"}, {"x", EAxis::Factor}, {"group", EAxis::Factor, false}}}, {"scale"}},
    {"series",
     {{{"y", EAxis::Series}, {"group", EAxis::Factor, false}}},
     {"scale", "xscale", "band", "ended"}},
    {"difference", {{{"y", EAxis::Series}, {"group", EAxis::Factor}}}, {"xscale"}},
    {"means",
     {{{"y"}, {"x", EAxis::FactorOrMetric}, {"group", EAxis::Factor, false}}},
     {"scale", "xscale", "bars", "reference", "reference_label"}},
    {"scaling", {{{"y"}, {"x", EAxis::FactorOrMetric}, {"group", EAxis::Factor, false}}}, {}},
    {"heatmap", {{{"z"}, {"x", EAxis::Factor}, {"y", EAxis::Factor}}}, {"scale"}}};

}  // namespace argos

#endif
