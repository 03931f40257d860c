#ifndef ARGOS3_CAMPAIGN_STATISTICS_KRUSKAL_WALLIS_TEST_H
#define ARGOS3_CAMPAIGN_STATISTICS_KRUSKAL_WALLIS_TEST_H

#include <argos3/campaign/statistics/chi_square_result.h>

#include <span>
#include <vector>

namespace argos {

/**
 * Kruskal and Wallis' test of the hypothesis that all groups come from one distribution, with the
 * correction for ties. If all values are equal, the statistic is 0 and the p value 1 (R: NaN).
 *
 * @param groups  at least two, of one or more values each; the approximation is good from about 5
 * values in each.
 * @throws CARGoSException for too few groups or values, and values that RequireSample() refuses.
 *
 * Source: W. H. Kruskal and W. A. Wallis, "Use of Ranks in One-Criterion Variance Analysis", JASA
 * 47 (1952). R: kruskal.test(list(...)).
 */
SChiSquareResult TestKruskalWallis(std::span<const std::vector<Real>> groups);

}  // namespace argos

#endif
