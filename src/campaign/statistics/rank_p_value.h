#ifndef ARGOS3_CAMPAIGN_STATISTICS_RANK_P_VALUE_H
#define ARGOS3_CAMPAIGN_STATISTICS_RANK_P_VALUE_H

#include <argos3/campaign/statistics/rank_distribution.h>
#include <argos3/campaign/statistics/rank_test_options.h>

namespace argos {

/** p value of a statistic with an exact distribution; twice the smaller tail, at most 1, for two
 * sides. */
Real ComputeExactPValue(size_t statistic, const CRankDistribution& distribution,
                        EAlternative alternative);

/**
 * p value by the normal approximation with a correction for continuity of 1/2 towards the mean.
 *
 * @param excess     what the statistic exceeds its mean by.
 * @param deviation  its standard deviation; 0 (all values are tied) gives 1.
 */
Real ComputeNormalPValue(Real excess, Real deviation, EAlternative alternative);

}  // namespace argos

#endif
