#include <argos3/campaign/statistics/group_ranks.h>

#include <argos3/campaign/statistics/ranks.h>

namespace argos {

SGroupRanks RankGroups(std::span<const std::vector<Real>> groups) {
  std::vector<Real> all;
  for (const std::vector<Real>& group : groups) {
    all.insert(all.end(), group.begin(), group.end());
  }
  const SRanking ranking = ComputeRanks(all);
  SGroupRanks result;
  for (const std::vector<Real>& group : groups) {
    Real sum = 0.0;
    for (size_t i = 0; i < group.size(); ++i) {
      sum += ranking.Ranks[result.Count + i];
    }
    result.RankSums.push_back(sum);
    result.Count += group.size();
  }
  result.TieTerm = ranking.TieTerm;
  return result;
}

}  // namespace argos
