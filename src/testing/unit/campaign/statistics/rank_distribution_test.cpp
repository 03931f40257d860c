#include <argos3/campaign/statistics/pairwise_points.h>
#include <argos3/campaign/statistics/rank_distribution.h>
#include <argos3/campaign/statistics/rank_interval.h>
#include <argos3/campaign/statistics/rank_p_value.h>
#include <argos3/campaign/statistics/ranks.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rank_distribution_test {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

// the greatest value whose lower tail is at most a probability; -1 if there is none
int FindCritical(const CRankDistribution& distribution, Real tail) {
  size_t above = 0;
  while (distribution.ComputeLowerTail(above) <= tail) {
    ++above;
  }
  return static_cast<int>(above) - 1;
}

}  // namespace

TEST_CASE("ranks: ties share the mean", "[campaign][statistics]") {
  const SRanking ranking = ComputeRanks(std::vector<Real>{3.0, -1.0, 3.0, 0.0, -0.0, 3.0, 8.0});
  CHECK(ranking.Ranks == std::vector<Real>{5.0, 1.0, 5.0, 2.5, 2.5, 5.0, 7.0});
  CHECK(ranking.TieTerm == 24.0 + 6.0);
  CHECK(ComputeRanks({}).Ranks.empty());
  CHECK(ComputeRanks(std::vector<Real>{2.0, 1.0}).TieTerm == 0.0);
}

TEST_CASE("signed-rank distribution: critical values of the printed tables",
          "[campaign][statistics]") {
  struct SEntry {
    size_t N;
    int At5Percent;  // two sides
    int At1Percent;
  };
  // F. Wilcoxon and R. A. Wilcox (1964), as reprinted in many books
  const std::vector<SEntry> table = {
      {5, -1, -1},  {6, 0, -1},   {7, 2, -1},   {8, 3, 0},    {9, 5, 1},    {10, 8, 3},
      {11, 10, 5},  {12, 13, 7},  {13, 17, 9},  {14, 21, 12}, {15, 25, 15}, {16, 29, 19},
      {17, 34, 23}, {18, 40, 27}, {19, 46, 32}, {20, 52, 37}, {25, 89, 68}, {30, 137, 109}};
  for (const SEntry& entry : table) {
    CAPTURE(entry.N);
    const CRankDistribution distribution = CRankDistribution::SignedRank(entry.N);
    CHECK(FindCritical(distribution, 0.025) == entry.At5Percent);
    CHECK(FindCritical(distribution, 0.005) == entry.At1Percent);
  }
}

TEST_CASE("rank-sum distribution: critical values of the printed tables",
          "[campaign][statistics]") {
  struct SEntry {
    size_t M;
    size_t N;
    int At5Percent;  // two sides
  };
  // H. B. Mann and D. R. Whitney (1947), extended by D. Auble (1953), as reprinted in many books
  const std::vector<SEntry> table = {{3, 4, -1},  {3, 5, 0},    {4, 4, 0},    {5, 5, 2},
                                     {6, 6, 5},   {7, 7, 8},    {8, 8, 13},   {9, 9, 17},
                                     {5, 10, 8},  {10, 5, 8},   {7, 12, 18},  {10, 10, 23},
                                     {6, 15, 19}, {15, 15, 64}, {20, 20, 127}};
  for (const SEntry& entry : table) {
    CAPTURE(entry.M, entry.N);
    CHECK(FindCritical(CRankDistribution::RankSum(entry.M, entry.N), 0.025) == entry.At5Percent);
  }
}

TEST_CASE("rank distributions: numbers of R", "[campaign][statistics]") {
  // R 4.2: psignrank(300, 49), pwilcox(900, 49, 49), pwilcox(40, 3, 20)
  CHECK_THAT(CRankDistribution::SignedRank(49).ComputeLowerTail(300),
             WithinRel(0.000751764235129571, 1e-12));
  CHECK_THAT(CRankDistribution::RankSum(49, 49).ComputeLowerTail(900),
             WithinRel(0.0163088635258742, 1e-12));
  CHECK_THAT(CRankDistribution::RankSum(3, 20).ComputeLowerTail(40),
             WithinRel(0.822699040090344, 1e-12));
  // R 4.2: qsignrank(0.025, 10), qsignrank(0.05, 15), qwilcox(0.025, 7, 8)
  CHECK(CRankDistribution::SignedRank(10).ComputeQuantile(0.025) == 9);
  CHECK(CRankDistribution::SignedRank(15).ComputeQuantile(0.05) == 31);
  CHECK(CRankDistribution::RankSum(7, 8).ComputeQuantile(0.025) == 11);
  // exactly at a step: P(V <= 0) = 1/4 for two values
  CHECK(CRankDistribution::SignedRank(2).ComputeQuantile(0.25) == 0);
  CHECK(CRankDistribution::SignedRank(2).ComputeQuantile(0.26) == 1);
  CHECK(CRankDistribution::SignedRank(2).ComputeQuantile(1.0) == 3);
  // beyond all of it
  CHECK(CRankDistribution::SignedRank(2).ComputeQuantile(1.1) == 3);
  CHECK(CRankDistribution::SignedRank(2).ComputeLowerTail(4) == 1.0);
}

TEST_CASE("p values of ranks: at most 1 in the middle of the distribution",
          "[campaign][statistics]") {
  // P(V <= 3) = P(V >= 3) = 5/8 for three values
  const CRankDistribution three = CRankDistribution::SignedRank(3);
  CHECK(ComputeExactPValue(3, three, EAlternative::TwoSided) == 1.0);
  CHECK(ComputeExactPValue(3, three, EAlternative::Less) == 0.625);
  CHECK(ComputeExactPValue(2, three, EAlternative::TwoSided) == 0.75);
  // the correction for continuity goes beyond the mean
  CHECK(ComputeNormalPValue(0.25, 1.0, EAlternative::TwoSided) == 1.0);
  CHECK(ComputeNormalPValue(0.0, 1.0, EAlternative::TwoSided) == 1.0);
}

TEST_CASE("intervals of ranks: levels near 0 give the last point at most",
          "[campaign][statistics]") {
  // the averages of pairs of 1 and 2 are 1, 1.5 and 2
  const CPairwisePoints points = CPairwisePoints::WalshAverages(std::vector<Real>{1.0, 2.0});
  const Real deviation = std::sqrt(5.0 / 4.0);
  const SConfidenceInterval above =
      ComputeNormalRankInterval(points, deviation, EAlternative::Greater, 0.001);
  CHECK(above.Lower == 2.0);
  CHECK(above.Level == 0.001);
  CHECK(ComputeNormalRankInterval(points, deviation, EAlternative::Less, 0.001).Upper == 1.0);
  // level 1/2 on one side: the point in the middle
  CHECK(ComputeNormalRankInterval(points, deviation, EAlternative::Greater, 0.5).Lower == 1.5);
  // one point: no interval has any level
  const CPairwisePoints one = CPairwisePoints::WalshAverages(std::vector<Real>{3.0});
  const SConfidenceInterval none =
      ComputeNormalRankInterval(one, 0.5, EAlternative::TwoSided, 0.95);
  CHECK(none.Lower == 3.0);
  CHECK(none.Upper == 3.0);
  CHECK(none.Level == 0.0);
}

TEST_CASE("rank distributions: equal to the enumeration of all cases", "[campaign][statistics]") {
  const size_t m = GENERATE(1u, 2u, 4u);
  const size_t n = GENERATE(1u, 3u, 5u);
  CAPTURE(m, n);
  const size_t all = m + n;
  std::vector<Real> atMost(m * n + 1, 0.0);
  std::vector<Real> signedAtMost(all * (all + 1) / 2 + 1, 0.0);
  Real numSubsets = 0.0;
  for (size_t subset = 0; subset < (size_t(1) << all); ++subset) {
    size_t size = 0;
    size_t rankSum = 0;
    for (size_t i = 0; i < all; ++i) {
      size += subset >> i & 1;
      rankSum += (subset >> i & 1) * (i + 1);
    }
    for (size_t v = rankSum; v < signedAtMost.size(); ++v) {
      signedAtMost[v] += 1.0;
    }
    if (size == m) {
      numSubsets += 1.0;
      for (size_t u = rankSum - m * (m + 1) / 2; u < atMost.size(); ++u) {
        atMost[u] += 1.0;
      }
    }
  }
  const CRankDistribution rankSum = CRankDistribution::RankSum(m, n);
  REQUIRE(rankSum.GetMax() == m * n);
  for (size_t u = 0; u <= m * n; ++u) {
    // one rounding of a quotient
    CHECK_THAT(rankSum.ComputeLowerTail(u), WithinRel(atMost[u] / numSubsets, 1e-15));
    CHECK_THAT(rankSum.ComputeUpperTail(m * n - u), WithinRel(atMost[u] / numSubsets, 1e-15));
  }
  const CRankDistribution signedRank = CRankDistribution::SignedRank(all);
  for (size_t v = 0; v < signedAtMost.size(); ++v) {
    CHECK(signedRank.ComputeLowerTail(v) == signedAtMost[v] / static_cast<Real>(size_t(1) << all));
  }
  CHECK(rankSum.ComputeUpperTail(m * n + 1) == 0.0);
  CHECK(rankSum.ComputeLowerTail(m * n + 1) == 1.0);
}

TEST_CASE("rank distributions: sizes out of range are errors", "[campaign][statistics]") {
  CHECK_THROWS_WITH(CRankDistribution::SignedRank(0), Contains("number of values 0"));
  CHECK_THROWS_WITH(CRankDistribution::SignedRank(1001), Contains("1 to 1000 allowed"));
  CHECK_THROWS_WITH(CRankDistribution::RankSum(3, 0), Contains("number of values 0"));
  CHECK_THROWS_WITH(CRankDistribution::RankSum(101, 1), Contains("1 to 100 allowed"));
  CHECK_THAT(CRankDistribution::SignedRank(1000).ComputeLowerTail(250250), WithinAbs(0.5, 1e-4));
  CHECK_THAT(CRankDistribution::RankSum(100, 100).ComputeLowerTail(5000), WithinAbs(0.5, 1e-3));
}

TEST_CASE("pairwise points: those of a sorted list", "[campaign][statistics]") {
  CRandomStream stream(5, "test", "pairwise", "points");
  const int numSteps = GENERATE(3, 10, 1000000);
  const Real scale = GENERATE(1.0, 1e-3, 1e149);
  std::vector<Real> x;
  std::vector<Real> y;
  for (int i = 0; i < 12; ++i) {
    x.push_back(scale * static_cast<Real>(stream.UniformInteger(-numSteps, numSteps)));
    y.push_back(scale * static_cast<Real>(stream.UniformInteger(-numSteps, numSteps)));
  }
  y.pop_back();
  std::vector<Real> averages;
  std::vector<Real> differences;
  for (size_t i = 0; i < x.size(); ++i) {
    for (size_t j = i; j < x.size(); ++j) {
      averages.push_back(0.5 * x[i] + 0.5 * x[j]);
    }
    for (const Real other : y) {
      differences.push_back(x[i] - other);
    }
  }
  std::sort(averages.begin(), averages.end());
  std::sort(differences.begin(), differences.end());
  const CPairwisePoints ofOne = CPairwisePoints::WalshAverages(x);
  const CPairwisePoints ofTwo = CPairwisePoints::Differences(x, y);
  REQUIRE(ofOne.GetCount() == averages.size());
  REQUIRE(ofTwo.GetCount() == differences.size());
  for (size_t i = 0; i < averages.size(); ++i) {
    CHECK(ofOne.Select(i) == averages[i]);
  }
  for (size_t i = 0; i < differences.size(); ++i) {
    CHECK(ofTwo.Select(i) == differences[i]);
  }
  // 78 and 132 points
  CHECK(ofOne.ComputeMedian() == 0.5 * (averages[38] + averages[39]));
  CHECK(ofTwo.ComputeMedian() == 0.5 * (differences[65] + differences[66]));
}

}  // namespace rank_distribution_test
