#ifndef ARGOS3_CAMPAIGN_PLOT_TABLE_FIGURES_H
#define ARGOS3_CAMPAIGN_PLOT_TABLE_FIGURES_H

#include <argos3/campaign/report/figure_drawing.h>
#include <argos3/campaign/report/figures.h>
#include <argos3/campaign/statistics/series_bands.h>

#include <limits>
#include <string>
#include <vector>

namespace argos {

/** A span of simulated time, s. */
struct SPlotSpan {
  Real From = -std::numeric_limits<Real>::infinity();
  Real To = std::numeric_limits<Real>::infinity();

  bool Contains(Real time) const { return time >= From && time <= To; }
};

struct STrajectoryRequest {
  std::string File;
  std::vector<std::string> Robots; /**< empty: all */
  UInt32 Run = 0; /**< run of an experiment that was reset */
  SPlotSpan Span;
};

/**
 * The paths of robots over the arena, with its walls and objects where they were at the start. Dots
 * are the starts, circles the ends. Up to kMaxColors robots have entries in a key, more have
 * colours of a scale.
 * @param look  set: the height shows the arena in its proportions.
 * @throws CARGoSException if the table is none, or has no such rows.
 */
SFigureDraft MakeTrajectoryFigure(const STrajectoryRequest& request, SFigureLook& look);

struct SMetricRequest {
  std::vector<std::string> Metrics;
  std::vector<std::string> Files; /**< each has the run, or the runs, of one seed */
  SPlotSpan Span;
  std::string Label; /**< label of the vertical axis; empty: name and unit of the first metric */
  EEndedRuns Ended = EEndedRuns::Survivors;
  bool IsLogarithmic = false; /**< the axis of values: times whose median is not positive are
                                   left out */
  bool IsTimeLogarithmic = false; /**< the axis of time; the state at 0 s is left out */
};

/**
 * Columns of tables against time: the median over all files and runs, and a band between the
 * quartiles. The caption says what is left out; it may be empty.
 * @throws CARGoSException if a table is none, has a row for each robot, or has no such column; if
 *   no table has a value, or none that a logarithmic axis can show.
 */
SFigureDraft MakeMetricFigure(const SMetricRequest& request);

}  // namespace argos

#endif
