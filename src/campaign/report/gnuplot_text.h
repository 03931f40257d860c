#ifndef ARGOS3_CAMPAIGN_REPORT_GNUPLOT_TEXT_H
#define ARGOS3_CAMPAIGN_REPORT_GNUPLOT_TEXT_H

// private: parts of scripts for gnuplot

#include <argos3/core/utility/datatypes/datatypes.h>

#include <string>
#include <utility>
#include <vector>

namespace argos {

/** Groups that differ in colour. */
constexpr size_t kMaxColors = 9;

/** "#332288", ...: distinguishable with colour blindness. @param index  below kMaxColors. */
const char* GetColor(size_t index);

/** Users' text as a string of gnuplot, which expands nothing in it. */
std::string QuoteForGnuplot(const std::string& text);

/** The look of all figures. */
std::string MakeStyle(const std::string& title, const std::string& xLabel,
                      const std::string& yLabel);

/** Labelled places of an axis, "x" or "y"; labels that would not fit side by side are rotated. */
std::string MakeTics(const std::string& axis,
                     const std::vector<std::pair<Real, std::string>>& placesAndLabels);

/** Space between values and the ends of a logarithmic axis, as a factor. */
constexpr Real kLogarithmicMargin = 1.2;

/**
 * A logarithmic axis from @p low to @p high, both positive. Tics are at 1, 2, 5, 10, ..., or, of
 * more than two decades, at powers of ten. A range in which there are not two is widened. If a tic
 * is below 0.01 or from 10^4 on, all are written as powers.
 * @param axis  "x", "y", or "cb", the scale of colours.
 */
std::string MakeLogarithmicAxis(const std::string& axis, Real low, Real high);

/**
 * The commands that draw the figure a second time, for each format.
 * @param isOpaque  an SVG has a white background; other formats always have.
 */
std::string MakeTerminal(const std::string& format, UInt32 width, UInt32 height,
                         bool isOpaque = false);

/** A number in data and scripts. */
std::string FormatForGnuplot(Real value);

}  // namespace argos

#endif
