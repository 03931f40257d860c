#ifndef ARGOS3_CAMPAIGN_STATISTICS_QUANTILE_H
#define ARGOS3_CAMPAIGN_STATISTICS_QUANTILE_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

/** The values in ascending order. */
std::vector<Real> Sorted(std::span<const Real> values);

/**
 * Quantile of sorted values: linear interpolation between the order statistics around
 * 1 + (n - 1) p.
 *
 * @param sorted       ascending, at least one.
 * @param probability  in [0,1].
 * @throws CARGoSException for no values, or a probability out of range.
 *
 * Source: R. J. Hyndman and Y. Fan, "Sample Quantiles in Statistical Packages", The American
 * Statistician 50 (1996), definition 7; R: quantile(x, p, type = 7).
 */
Real ComputeQuantile(std::span<const Real> sorted, Real probability);

/** Median of sorted values, at least one: the middle one, or the mean of the two in the middle. */
Real ComputeMedian(std::span<const Real> sorted);

}  // namespace argos

#endif
