#include <argos3/campaign/statistics/kruskal_wallis_test.h>

#include <argos3/campaign/statistics/group_ranks.h>
#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/sample_checks.h>

namespace argos {

SChiSquareResult TestKruskalWallis(std::span<const std::vector<Real>> groups) {
  RequireGroups(groups, 2, 1);
  const SGroupRanks ranks = RankGroups(groups);
  const auto n = static_cast<Real>(ranks.Count);
  const Real untied = 1.0 - ranks.TieTerm / (n * n * n - n);
  Real statistic = 0.0;
  if (untied > 0.0) {
    // sum of n_i (mean rank - (n + 1) / 2)^2: no cancellation if the groups are alike
    for (size_t i = 0; i < groups.size(); ++i) {
      const auto size = static_cast<Real>(groups[i].size());
      const Real excess = ranks.RankSums[i] - size * (n + 1.0) / 2.0;
      statistic += excess * excess / size;
    }
    statistic *= 12.0 / (n * (n + 1.0)) / untied;
  }
  const size_t freedom = groups.size() - 1;
  return {statistic, freedom, ComputeChiSquareUpperTail(statistic, static_cast<Real>(freedom))};
}

}  // namespace argos
