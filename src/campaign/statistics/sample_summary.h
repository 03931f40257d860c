#ifndef ARGOS3_CAMPAIGN_STATISTICS_SAMPLE_SUMMARY_H
#define ARGOS3_CAMPAIGN_STATISTICS_SAMPLE_SUMMARY_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>
#include <span>

namespace argos {

/** Describes a sample; NaN where the sample has too few values. */
struct SSampleSummary {
  static constexpr Real kNone = std::numeric_limits<Real>::quiet_NaN();

  size_t Count = 0;  // number of values that are there
  size_t NumMissing = 0;  // NaN
  Real Mean = kNone;
  Real StandardDeviation = kNone;  // has the divisor n - 1; NaN for one value
  Real Min = kNone;
  Real LowerQuartile = kNone;  // type 7, see ComputeQuantile()
  Real Median = kNone;
  Real UpperQuartile = kNone;
  Real Max = kNone;
};

/**
 * Missing values (NaN) are counted apart. Without any value, all statistics are NaN.
 *
 * @throws CARGoSException for infinite values and those beyond kMaxValue.
 *
 * R: mean, sd, and quantile(x, c(0, .25, .5, .75, 1)), with na.rm = TRUE.
 */
SSampleSummary Summarize(std::span<const Real> values);

}  // namespace argos

#endif
