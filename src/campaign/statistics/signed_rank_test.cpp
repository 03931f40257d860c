#include <argos3/campaign/statistics/signed_rank_test.h>

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

// Wilcoxon's statistic and the variance of its normal approximation
struct SSignedRanks {
  Real Statistic = 0.0;
  Real Excess;  // excess of the statistic over its mean
  Real Deviation;
  bool HasTies;
};

Real ComputeDeviation(Real n, Real tieTerm) {
  // the term of ties is at most n^3 - n, which leaves a positive variance
  return std::sqrt(n * (n + 1.0) * (2.0 * n + 1.0) / 24.0 - tieTerm / 48.0);
}

SSignedRanks RankDifferences(std::span<const Real> values, Real location) {
  std::vector<Real> distances;
  for (const Real value : values) {
    distances.push_back(std::abs(value - location));
  }
  const SRanking ranking = ComputeRanks(distances);
  SSignedRanks ranks;
  for (size_t i = 0; i < values.size(); ++i) {
    ranks.Statistic += values[i] > location ? ranking.Ranks[i] : 0.0;
  }
  const auto n = static_cast<Real>(values.size());
  ranks.Excess = ranks.Statistic - n * (n + 1.0) / 4.0;
  ranks.Deviation = ComputeDeviation(n, ranking.TieTerm);
  ranks.HasTies = ranking.TieTerm > 0.0;
  return ranks;
}

SConfidenceInterval ComputeNormalInterval(std::span<const Real> values,
                                          const CPairwisePoints& points,
                                          const SRankTestOptions& options) {
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  if (*min == *max) {
    return {*min, *max, 0.0};
  }
  // near enough to a centre that is no Walsh average, only equal values are tied
  const Real deviation =
      ComputeDeviation(static_cast<Real>(values.size()), ComputeRanks(values).TieTerm);
  return ComputeNormalRankInterval(points, deviation, options.Alternative, options.Level);
}

}  // namespace

SRankTestResult TestSignedRank(std::span<const Real> values, const SRankTestOptions& options) {
  RequireSample(values, 1, "signed-rank test");
  RequireSample(std::span(&options.Location, 1), 1, "location of the signed-rank test");
  RequireLevel(options.Level);
  const Real location = options.Location;
  std::vector<Real> used;
  for (const Real value : values) {
    if (value != location) {
      used.push_back(value);
    }
  }
  if (used.empty()) {
    return {0.0, 1.0, false, location, {location, location, 0.0}};
  }
  const SSignedRanks ranks = RankDifferences(used, location);
  const CPairwisePoints points = CPairwisePoints::WalshAverages(used);
  const bool isExact = options.NullDistribution == ENullDistribution::Automatic &&
                       used.size() == values.size() && used.size() < kExactBelow && !ranks.HasTies;
  if (!isExact) {
    return {ranks.Statistic,
            ComputeNormalPValue(ranks.Excess, ranks.Deviation, options.Alternative), false,
            points.ComputeMedian(), ComputeNormalInterval(used, points, options)};
  }
  const CRankDistribution distribution = CRankDistribution::SignedRank(used.size());
  return {
      ranks.Statistic,
      ComputeExactPValue(static_cast<size_t>(ranks.Statistic), distribution, options.Alternative),
      true, points.ComputeMedian(),
      ComputeExactRankInterval(points, distribution, options.Alternative, options.Level)};
}

SRankTestResult TestSignedRankOfPairs(std::span<const Real> x, std::span<const Real> y,
                                      const SRankTestOptions& options) {
  RequirePairs(x, y);
  RequireSample(x, 1, "x");
  RequireSample(y, 1, "y");
  std::vector<Real> differences;
  for (size_t i = 0; i < x.size(); ++i) {
    differences.push_back(x[i] - y[i]);
  }
  return TestSignedRank(differences, options);
}

}  // namespace argos
