#include <argos3/campaign/statistics/rank_sum_test.h>

#include <argos3/campaign/statistics/pairwise_points.h>
#include <argos3/campaign/statistics/rank_distribution.h>
#include <argos3/campaign/statistics/rank_interval.h>
#include <argos3/campaign/statistics/rank_p_value.h>
#include <argos3/campaign/statistics/ranks.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos {

namespace {

// Mann and Whitney's count, and the ties of all values
struct SCount {
  Real Statistic;
  Real TieTerm;
};

SCount CountGreater(std::span<const Real> x, std::span<const Real> y, Real location) {
  std::vector<Real> both;
  for (const Real value : x) {
    both.push_back(value - location);
  }
  both.insert(both.end(), y.begin(), y.end());
  const SRanking ranking = ComputeRanks(both);
  const auto m = static_cast<Real>(x.size());
  Real sum = -m * (m + 1.0) / 2.0;
  for (size_t i = 0; i < x.size(); ++i) {
    sum += ranking.Ranks[i];
  }
  return {sum, ranking.TieTerm};
}

Real ComputeDeviation(Real m, Real n, Real tieTerm) {
  const Real all = m + n;
  const Real variance = m * n / 12.0 * (all + 1.0 - tieTerm / (all * (all - 1.0)));
  return std::sqrt(std::max(0.0, variance));
}

}  // namespace

SRankTestResult TestRankSum(std::span<const Real> x, std::span<const Real> y,
                            const SRankTestOptions& options) {
  RequireSample(x, 1, "rank-sum test, x");
  RequireSample(y, 1, "rank-sum test, y");
  RequireSample(std::span(&options.Location, 1), 1, "location of the rank-sum test");
  RequireLevel(options.Level);
  const SCount count = CountGreater(x, y, options.Location);
  const CPairwisePoints points = CPairwisePoints::Differences(x, y);
  const bool isExact = options.NullDistribution == ENullDistribution::Automatic &&
                       x.size() < kExactBelow && y.size() < kExactBelow && count.TieTerm == 0.0;
  if (!isExact) {
    const auto m = static_cast<Real>(x.size());
    const auto n = static_cast<Real>(y.size());
    const Real tiesWithin = ComputeRanks(x).TieTerm + ComputeRanks(y).TieTerm;
    return {count.Statistic,
            ComputeNormalPValue(count.Statistic - m * n / 2.0,
                                ComputeDeviation(m, n, count.TieTerm), options.Alternative),
            false, points.ComputeMedian(),
            ComputeNormalRankInterval(points, ComputeDeviation(m, n, tiesWithin),
                                      options.Alternative, options.Level)};
  }
  const CRankDistribution distribution = CRankDistribution::RankSum(x.size(), y.size());
  return {
      count.Statistic,
      ComputeExactPValue(static_cast<size_t>(count.Statistic), distribution, options.Alternative),
      true, points.ComputeMedian(),
      ComputeExactRankInterval(points, distribution, options.Alternative, options.Level)};
}

}  // namespace argos
