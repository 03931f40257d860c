#ifndef ARGOS3_CAMPAIGN_REPORT_FIGURES_H
#define ARGOS3_CAMPAIGN_REPORT_FIGURES_H

#include <argos3/campaign/report/figure_request.h>
#include <argos3/campaign/report/report_data.h>

#include <string>

namespace argos {

/** Data and script of a figure; gnuplot has not been called yet. */
struct SFigureDraft {
  std::string Data; /**< blocks with comments, for gnuplot and other programs */
  std::string Script; /**< ranges from the style to the plot; reads the file that kDataName names */
  std::string Caption; /**< says what is shown; plain text */
};

/** The variable of SFigureDraft::Script that has the name of the data file. */
constexpr const char* kDataName = "data_file";

/**
 * Computes what a figure shows.
 *
 * - boxplot: median, quartiles and whiskers (the last values within 1.5 interquartile ranges of the
 *   box) of a metric at each level of a factor, and the values; by groups
 * - series: median and quartiles of a time series at each time, by groups
 * - difference: of a time series between two levels of the group, at each time: Hodges and
 * Lehmann's estimate with its interval, of pairs of runs with equal seeds
 * - means: means of a metric with t intervals against a factor or another metric; by groups
 * - scaling: means of a metric with t intervals against a factor or another metric, on logarithmic
 *   axes, with a power law fitted to the runs; by groups
 * - heatmap: means of a metric at the levels of two factors
 *
 * With Where, of the combinations for which it is true. Runs at all levels of other factors are
 * taken together; the caption says so.
 * @throws CARGoSException if the kind, a metric or a factor is unknown or missing, Where fails or
 * is true for no combination, there are no values, or values are not positive on a logarithmic
 * axis.
 */
SFigureDraft MakeFigure(const CReportData& data, const SFigureRequest& request);

/** A name for the files of a figure: letters, digits, '_' and '-'. */
std::string MakeFigureName(const SFigureRequest& request);

}  // namespace argos

#endif
