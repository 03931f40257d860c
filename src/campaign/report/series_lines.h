#ifndef ARGOS3_CAMPAIGN_REPORT_SERIES_LINES_H
#define ARGOS3_CAMPAIGN_REPORT_SERIES_LINES_H

// private: time series of runs as lines with bands

#include <argos3/campaign/statistics/series_bands.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace argos {

/** The time series of the runs that are shown as one line. */
struct SSeriesGroup {
  std::string Title; /**< title of the key: "robots = 4"; may be empty */
  std::vector<Real> Times; /**< times of any of the runs, ascending */
  std::vector<std::vector<Real>> Runs; /**< (runs, times up to the run's last one); NaN: none */
};

/** Values and their times, ascending. */
typedef std::vector<std::pair<Real, Real>> TTimedValues;

/** Brings the series of runs to common times. */
SSeriesGroup MakeSeriesGroup(const std::string& title, const std::vector<TTimedValues>& runs);

struct SSeriesStyle {
  bool ShowsInterval = false; /**< means with intervals, not medians with quartiles */
  EEndedRuns Ended = EEndedRuns::Survivors;
  bool JoinsCounts = false; /**< the key has no numbers of runs if these are equal: CommonRuns */
  bool IsLogarithmic =
      false; /**< the axis of values: times whose middle is not positive are left out */
  bool IsTimeLogarithmic = false; /**< all times are positive */
};

/** Data and plot of lines with bands. */
struct SSeriesLines {
  /** A block for each group: time, lower, middle, upper, number of runs. With logarithmic time, a
   * second block of each has the points that are drawn. */
  std::string Data;
  std::string Plot; /**< the command `plot`; bands below lines, which are dashed with fewer runs */
  Real Low =
      std::numeric_limits<Real>::quiet_NaN(); /**< the least value of any run; NaN without values */
  Real High = std::numeric_limits<Real>::quiet_NaN(); /**< the top of the bands */
  std::vector<size_t> Counts; /**< (groups that have runs) runs */
  std::string Axes; /**< commands of the axes of values and of time */
  std::string CommonRuns; /**< "10 runs, 2 at the end"; empty unless the key lacks it */
  std::string Ending; /**< what the caption says about runs that have ended; may be empty */
  std::string LeftOut; /**< and about times that a logarithmic axis cannot show; may be empty */
};

/**
 * @param groups  at least one; one may be without runs.
 * @throws CARGoSException if a logarithmic axis can show no value.
 */
SSeriesLines MakeSeriesLines(std::vector<SSeriesGroup> groups, const SSeriesStyle& style);

}  // namespace argos

#endif
