#ifndef ARGOS3_CAMPAIGN_STATISTICS_RANK_INTERVAL_H
#define ARGOS3_CAMPAIGN_STATISTICS_RANK_INTERVAL_H

#include <argos3/campaign/statistics/confidence_interval.h>
#include <argos3/campaign/statistics/pairwise_points.h>
#include <argos3/campaign/statistics/rank_distribution.h>
#include <argos3/campaign/statistics/rank_test_options.h>

namespace argos {

/**
 * Interval of a location that inverts an exact rank test: between two of the points.
 *
 * Level of the result is exact, mostly greater than that asked for, and smaller if the samples
 * are too small for it: then the interval spans all points.
 *
 * Source: M. Hollander and D. A. Wolfe, Nonparametric Statistical Methods, 2nd ed. (1999),
 * sections 3.3 and 4.3.
 */
SConfidenceInterval ComputeExactRankInterval(const CPairwisePoints& points,
                                             const CRankDistribution& distribution,
                                             EAlternative alternative, Real level);

/**
 * The same for a statistic with a normal approximation: the values at which the z of the test,
 * corrected for continuity, crosses its quantiles.
 *
 * R finds these crossings by a search that stops within 1e-4; the results here are the points
 * themselves. Where the samples are too small for the level, the interval spans all points
 * and has the level that the approximation gives for it.
 *
 * @param deviation  standard deviation of the statistic, corrected for ties in each sample.
 */
SConfidenceInterval ComputeNormalRankInterval(const CPairwisePoints& points, Real deviation,
                                              EAlternative alternative, Real level);

}  // namespace argos

#endif
