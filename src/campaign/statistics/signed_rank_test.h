#ifndef ARGOS3_CAMPAIGN_STATISTICS_SIGNED_RANK_TEST_H
#define ARGOS3_CAMPAIGN_STATISTICS_SIGNED_RANK_TEST_H

#include <argos3/campaign/statistics/rank_test_options.h>
#include <argos3/campaign/statistics/rank_test_result.h>

#include <span>

namespace argos {

/**
 * Wilcoxon's signed-rank test of the hypothesis that a distribution is symmetric about
 * options.Location, with Hodges and Lehmann's estimate of its centre (pseudomedian) and an
 * interval.
 *
 * Values equal to the location are dropped, also for the estimate, as in R. The distribution is
 * exact for fewer than 50 values if none is dropped and no absolute differences are tied,
 * else the normal approximation with corrections for continuity and ties. If nothing is left,
 * the p value is 1 and the interval the location, with level 0 (R: NaN).
 *
 * The interval is about the centre itself, and independent of the location unless values are
 * dropped. Equal values have that value as interval, with a level from the formulas (0 with the
 * normal approximation).
 *
 * @param values  at least one.
 * @throws CARGoSException for no values, values that RequireSample() refuses, a level or a
 * location out of range.
 *
 * Source: M. Hollander and D. A. Wolfe, Nonparametric Statistical Methods, 2nd ed. (1999),
 * sections 3.1 to 3.3. R: wilcox.test(x, mu = location, conf.int = TRUE).
 */
SRankTestResult TestSignedRank(std::span<const Real> values, const SRankTestOptions& options = {});

/**
 * The same for pairs: of the differences x - y. Equal differences that are rounded differently are
 * not tied.
 *
 * @throws CARGoSException also if the samples are not equally long.
 *
 * R: wilcox.test(x, y, paired = TRUE, conf.int = TRUE).
 */
SRankTestResult TestSignedRankOfPairs(std::span<const Real> x, std::span<const Real> y,
                                      const SRankTestOptions& options = {});

}  // namespace argos

#endif
