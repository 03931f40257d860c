#include <argos3/campaign/statistics/dunn_test.h>

#include <argos3/campaign/statistics/group_ranks.h>
#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

std::vector<SGroupComparison> CompareByDunn(std::span<const std::vector<Real>> groups,
                                            EPValueAdjustment adjustment) {
  RequireGroups(groups, 2, 1);
  const SGroupRanks ranks = RankGroups(groups);
  const auto n = static_cast<Real>(ranks.Count);
  // variance of one rank
  const Real variance = std::max(0.0, n * (n + 1.0) - ranks.TieTerm / (n - 1.0)) / 12.0;
  std::vector<SGroupComparison> comparisons;
  std::vector<Real> pValues;
  for (size_t first = 0; first < groups.size(); ++first) {
    for (size_t second = first + 1; second < groups.size(); ++second) {
      const auto size1 = static_cast<Real>(groups[first].size());
      const auto size2 = static_cast<Real>(groups[second].size());
      const Real difference = ranks.RankSums[first] / size1 - ranks.RankSums[second] / size2;
      const Real deviation = std::sqrt(variance * (1.0 / size1 + 1.0 / size2));
      const Real z = deviation > 0.0 ? difference / deviation : 0.0;
      pValues.push_back(std::min(1.0, 2.0 * ComputeNormalUpperTail(std::abs(z))));
      comparisons.push_back({first, second, z, pValues.back(), 0.0});
    }
  }
  const std::vector<Real> adjusted = AdjustPValues(pValues, adjustment);
  for (size_t i = 0; i < comparisons.size(); ++i) {
    comparisons[i].AdjustedPValue = adjusted[i];
  }
  return comparisons;
}

}  // namespace argos
