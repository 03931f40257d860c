#include <argos3/campaign/statistics/ranks.h>

#include <algorithm>
#include <numeric>

namespace argos {

SRanking ComputeRanks(std::span<const Real> values) {
  std::vector<size_t> order(values.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::ranges::sort(order, {}, [values](size_t i) { return values[i]; });
  SRanking ranking;
  ranking.Ranks.resize(values.size());
  for (size_t begin = 0; begin < order.size();) {
    size_t end = begin + 1;
    while (end < order.size() && values[order[end]] == values[order[begin]]) {
      ++end;
    }
    const Real shared = 0.5 * static_cast<Real>(begin + 1 + end);
    for (size_t i = begin; i < end; ++i) {
      ranking.Ranks[order[i]] = shared;
    }
    const auto tied = static_cast<Real>(end - begin);
    ranking.TieTerm += tied * (tied * tied - 1.0);
    begin = end;
  }
  return ranking;
}

}  // namespace argos
