#ifndef ARGOS3_CAMPAIGN_STATISTICS_RANK_SUM_TEST_H
#define ARGOS3_CAMPAIGN_STATISTICS_RANK_SUM_TEST_H

#include <argos3/campaign/statistics/rank_test_options.h>
#include <argos3/campaign/statistics/rank_test_result.h>

#include <span>

namespace argos {

/**
 * Wilcoxon's rank-sum test (Mann and Whitney's) of the hypothesis that two samples come from
 * distributions that differ by a shift of options.Location, with Hodges and Lehmann's estimate of
 * the shift of x against y and an interval.
 *
 * The distribution is exact if both samples have fewer than 50 values and there are no ties, else
 * the normal approximation with corrections for continuity and ties. If all values are equal, the
 * p value is 1 (R: NaN). In the approximate interval, ties between the samples do not count,
 * as they vanish with the smallest shift.
 *
 * @param x,y  at least one value each.
 * @throws CARGoSException for no values, values that RequireSample() refuses, a level or a
 * location out of range.
 *
 * Source: M. Hollander and D. A. Wolfe, Nonparametric Statistical Methods, 2nd ed. (1999),
 * sections 4.1 to 4.3. R: wilcox.test(x, y, mu = location, conf.int = TRUE).
 */
SRankTestResult TestRankSum(std::span<const Real> x, std::span<const Real> y,
                            const SRankTestOptions& options = {});

}  // namespace argos

#endif
