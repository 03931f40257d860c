#ifndef ARGOS3_CAMPAIGN_STATISTICS_DUNN_TEST_H
#define ARGOS3_CAMPAIGN_STATISTICS_DUNN_TEST_H

#include <argos3/campaign/statistics/p_value_adjustment.h>

#include <span>
#include <vector>

namespace argos {

/** Comparison of two groups. */
struct SGroupComparison {
  size_t First;  // indices of the groups, First < Second
  size_t Second;
  Real Z;  // positive if the first group has the greater mean rank
  Real PValue;  // has two sides
  Real AdjustedPValue;  // is adjusted for all comparisons
};

/**
 * Dunn's comparisons of each pair of groups by their mean ranks among all values, after Kruskal
 * and Wallis' test; with the correction for ties. If all values are equal, z is 0 and p is 1.
 *
 * @param groups  at least two, of one or more values each.
 * @return in the order (0,1), (0,2), ..., (1,2), ...
 * @throws CARGoSException for too few groups or values, and values that RequireSample() refuses.
 *
 * Source: O. J. Dunn, "Multiple Comparisons Using Rank Sums", Technometrics 6 (1964).
 * R: FSA::dunnTest(method = "holm"), dunn.test::dunn.test(altp = TRUE).
 */
std::vector<SGroupComparison> CompareByDunn(std::span<const std::vector<Real>> groups,
                                            EPValueAdjustment adjustment = EPValueAdjustment::Holm);

}  // namespace argos

#endif
