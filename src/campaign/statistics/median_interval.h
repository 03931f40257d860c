#ifndef ARGOS3_CAMPAIGN_STATISTICS_MEDIAN_INTERVAL_H
#define ARGOS3_CAMPAIGN_STATISTICS_MEDIAN_INTERVAL_H

#include <argos3/campaign/statistics/confidence_interval.h>

#include <span>

namespace argos {

/**
 * Distribution-free interval of the median: [x(k), x(n + 1 - k)] of the sorted values, with the
 * greatest k for which the binomial probability of containing the median is at least the level.
 *
 * Level of the result is that probability, exact for continuous distributions. If even the whole
 * range has a smaller one (fewer than 6 values for 0.95), the range is returned.
 *
 * @param level  of confidence, in (0,1).
 * @throws CARGoSException for no values, values that RequireSample() refuses, or a level out of
 * range.
 *
 * Source: W. J. Conover, Practical Nonparametric Statistics, 3rd ed. (1999), section 3.2.
 * R: k is qbinom((1 - level) / 2, n, 0.5).
 */
SConfidenceInterval ComputeMedianInterval(std::span<const Real> values, Real level = 0.95);

}  // namespace argos

#endif
