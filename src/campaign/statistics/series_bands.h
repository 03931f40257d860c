#ifndef ARGOS3_CAMPAIGN_STATISTICS_SERIES_BANDS_H
#define ARGOS3_CAMPAIGN_STATISTICS_SERIES_BANDS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

/** What happens to series that end before others, because their runs have ended. */
enum class EEndedRuns {
  Survivors, /**< they do not count after their end: later times show fewer runs */
  Hold, /**< they keep their last value */
  Drop /**< times that not all series have reached are left out */
};

/**
 * Makes the lengths of series equal, unless they are survivors: cuts all after the first end, or
 * appends to each its last value that is not NaN. Series without any value get none.
 */
void ApplyToEndedRuns(std::vector<std::vector<Real>>& series, EEndedRuns rule);

/** Median and a band of quantiles at each tick of several time series. */
struct SSeriesBands {
  std::vector<size_t> Counts;  // (length of the longest series): values at each tick
  std::vector<Real> Lower;  // same shape as Counts; NaN where that is 0
  std::vector<Real> Median;
  std::vector<Real> Upper;
};

/**
 * Series with equal ticks, one for each run. A series that has ended, or is NaN at a tick, does
 * not count there, so Counts tells how many runs each point stands for.
 *
 * @param series      at least one; series may be empty.
 * @param lower,upper  probabilities in [0,1] of the band, lower <= upper; by default quartiles, see
 * ComputeQuantile().
 * @throws CARGoSException for no series, probabilities out of range, infinite values, and those
 * beyond kMaxValue; the text names series and tick.
 *
 * R: apply(matrix, 1, quantile, c(lower, .5, upper), na.rm = TRUE), one column a series.
 */
SSeriesBands ComputeSeriesBands(std::span<const std::vector<Real>> series, Real lower = 0.25,
                                Real upper = 0.75);

}  // namespace argos

#endif
