#include "hostile_values.h"
#include "samples.h"

#include <argos3/campaign/statistics/dunn_test.h>
#include <argos3/campaign/statistics/friedman_test.h>
#include <argos3/campaign/statistics/kruskal_wallis_test.h>
#include <argos3/campaign/statistics/p_value_adjustment.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace group_tests_test {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

// mucociliary efficiency: M. Hollander and D. A. Wolfe (1973), 116; R: ?kruskal.test
const std::vector<std::vector<Real>> kMucociliary = {
    {2.9, 3.0, 2.5, 2.6, 3.2}, {3.8, 2.7, 4.0, 2.4}, {2.8, 3.4, 3.7, 2.2, 2.0}};

// times of 22 players to round first base by three methods: the same book, 140ff; R: ?friedman.test
const std::vector<std::vector<Real>> kRoundingTimes = {
    {5.40, 5.50, 5.55}, {5.85, 5.70, 5.75}, {5.20, 5.60, 5.50}, {5.55, 5.50, 5.40},
    {5.90, 5.85, 5.70}, {5.45, 5.55, 5.60}, {5.40, 5.40, 5.35}, {5.45, 5.50, 5.35},
    {5.25, 5.15, 5.00}, {5.85, 5.80, 5.70}, {5.25, 5.20, 5.10}, {5.65, 5.55, 5.45},
    {5.60, 5.35, 5.45}, {5.05, 5.00, 4.95}, {5.50, 5.50, 5.40}, {5.45, 5.55, 5.50},
    {5.55, 5.55, 5.35}, {5.45, 5.50, 5.55}, {5.50, 5.45, 5.25}, {5.65, 5.60, 5.40},
    {5.70, 5.65, 5.55}, {6.30, 6.30, 6.25}};

void CheckValues(const std::vector<Real>& found, const std::vector<Real>& expected) {
  REQUIRE(found.size() == expected.size());
  for (size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK_THAT(found[i], WithinRel(expected[i], 1e-11));
  }
}

}  // namespace

TEST_CASE("kruskal-wallis test: published examples", "[campaign][statistics]") {
  // published: 0.77143, df = 2, p = 0.68; 29.267, df = 4, p = 6.901e-06; digits: R 4.2
  const SChiSquareResult efficiency = TestKruskalWallis(kMucociliary);
  CHECK_THAT(efficiency.Statistic, WithinRel(0.771428571428572, 1e-13));
  CHECK(efficiency.DegreesOfFreedom == 2);
  CHECK_THAT(efficiency.PValue, WithinRel(0.679964773578894, 1e-12));
  const SChiSquareResult ozone = TestKruskalWallis(kOzone);
  CHECK_THAT(ozone.Statistic, WithinRel(29.2665763061169, 1e-13));
  CHECK(ozone.DegreesOfFreedom == 4);
  CHECK_THAT(ozone.PValue, WithinRel(6.90071411854678e-06, 1e-11));
}

TEST_CASE("kruskal-wallis test: only the order of values counts", "[campaign][statistics]") {
  std::vector<std::vector<Real>> transformed = {kOzone[4], kOzone[1], kOzone[0], kOzone[3],
                                                kOzone[2]};
  for (std::vector<Real>& group : transformed) {
    for (Real& value : group) {
      value = std::exp(0.1 * value);
    }
  }
  CHECK_THAT(TestKruskalWallis(transformed).Statistic,
             WithinRel(TestKruskalWallis(kOzone).Statistic, 1e-13));
}

TEST_CASE("kruskal-wallis test: hostile input", "[campaign][statistics]") {
  CHECK_THROWS_WITH(TestKruskalWallis({}), Contains("number of groups 0, at least 2"));
  CHECK_THROWS_WITH(TestKruskalWallis(std::vector<std::vector<Real>>{{1.0, 2.0}}),
                    Contains("number of groups 1, at least 2"));
  CHECK_THROWS_WITH(TestKruskalWallis(std::vector<std::vector<Real>>{{1.0}, {}}),
                    Contains("group 2: number of values 0"));
  CheckRefusesHostileValues({1.0, 2.0}, [](const std::vector<Real>& values) {
    TestKruskalWallis(std::vector<std::vector<Real>>{{1.0}, values});
  });
  const SChiSquareResult equal =
      TestKruskalWallis(std::vector<std::vector<Real>>{{0.1, 0.1}, {0.1}, {0.1, 0.1}});
  CHECK(equal.Statistic == 0.0);
  CHECK(equal.PValue == 1.0);
  // one value each: the ranks are 1 and 2; R 4.2: statistic 1, p = 0.3173
  const SChiSquareResult ones = TestKruskalWallis(std::vector<std::vector<Real>>{{4.0}, {7.0}});
  CHECK_THAT(ones.Statistic, WithinAbs(1.0, 1e-15));
  CHECK_THAT(ones.PValue, WithinRel(0.317310507862914, 1e-12));
}

TEST_CASE("dunn's test: ozone of five months", "[campaign][statistics]") {
  // R 4.2, from Dunn's formula: (m[i] - m[j]) / sqrt((N (N + 1) / 12 - sum(t^3 - t) /
  // (12 (N - 1))) (1 / n[i] + 1 / n[j])) with m = tapply(rank(Ozone), Month, mean); 2 pnorm(-|z|)
  const std::vector<SGroupComparison> comparisons = CompareByDunn(kOzone);
  std::vector<Real> z;
  std::vector<Real> pValues;
  std::vector<Real> adjusted;
  for (const SGroupComparison& comparison : comparisons) {
    z.push_back(comparison.Z);
    pValues.push_back(comparison.PValue);
    adjusted.push_back(comparison.AdjustedPValue);
  }
  CheckValues(
      z, {-0.92515861626872664, -4.41947064061155626, -4.13281342220511227, -1.32120228252016636,
          -2.24420803239467226, -2.03863548728771260, 0.00253855526952261, 0.28665721840644365,
          3.21719912427735721, 2.92282777777952330});
  CheckValues(pValues, {3.54883406425791e-01, 9.89429615000047e-06, 3.58349614331419e-05,
                        1.86433925462795e-01, 2.48190194704221e-02, 4.14864207250498e-02,
                        9.97974528119149e-01, 7.74374798113020e-01, 1.29448721645086e-03,
                        3.46868316114938e-03});
  CheckValues(adjusted, {1.0, 9.89429615000046e-05, 3.22514652898277e-04, 7.45735701851181e-01,
                         1.48914116822533e-01, 2.07432103625249e-01, 1.0, 1.0, 1.03558977316069e-02,
                         2.42807821280457e-02});
  CHECK(comparisons[1].First == 0);
  CHECK(comparisons[1].Second == 2);
  CHECK(comparisons[9].First == 3);
  CHECK(comparisons[9].Second == 4);
  const SGroupComparison bonferroni = CompareByDunn(kOzone, EPValueAdjustment::Bonferroni)[9];
  CHECK_THAT(bonferroni.AdjustedPValue, WithinRel(3.46868316114938e-02, 1e-11));
  const SGroupComparison none = CompareByDunn(kOzone, EPValueAdjustment::None)[9];
  CHECK(none.AdjustedPValue == none.PValue);
}

TEST_CASE("dunn's test: of two groups it is kruskal and wallis'", "[campaign][statistics]") {
  const std::vector<std::vector<Real>> two = {kOzone[0], kOzone[4]};
  const SGroupComparison comparison = CompareByDunn(two)[0];
  const SChiSquareResult overall = TestKruskalWallis(two);
  CHECK_THAT(comparison.Z * comparison.Z, WithinRel(overall.Statistic, 1e-12));
  CHECK_THAT(comparison.AdjustedPValue, WithinRel(overall.PValue, 1e-11));
}

TEST_CASE("dunn's test: hostile input", "[campaign][statistics]") {
  CHECK_THROWS_WITH(CompareByDunn({}), Contains("number of groups 0"));
  CHECK_THROWS_WITH(CompareByDunn(std::vector<std::vector<Real>>{{}, {1.0}}),
                    Contains("group 1: number of values 0"));
  CheckRefusesHostileValues({1.0, 2.0}, [](const std::vector<Real>& values) {
    CompareByDunn(std::vector<std::vector<Real>>{{1.0}, values});
  });
  const SGroupComparison equal =
      CompareByDunn(std::vector<std::vector<Real>>{{2.0, 2.0}, {2.0}})[0];
  CHECK(equal.Z == 0.0);
  CHECK(equal.AdjustedPValue == 1.0);
  // so many that the variance is a negative rounding error
  const SGroupComparison many =
      CompareByDunn(std::vector<std::vector<Real>>{std::vector<Real>(330291, 2.0), {2.0}})[0];
  CHECK(many.Z == 0.0);
  CHECK(many.PValue == 1.0);
}

TEST_CASE("adjustment of p values: as R's p.adjust", "[campaign][statistics]") {
  const std::vector<Real> pValues = {0.01, 0.04, 0.03, 0.005, 0.04, 0.9};
  CheckValues(AdjustPValues(pValues, EPValueAdjustment::Holm), {0.05, 0.12, 0.12, 0.03, 0.12, 0.9});
  CheckValues(AdjustPValues(pValues, EPValueAdjustment::Bonferroni),
              {0.06, 0.24, 0.18, 0.03, 0.24, 1.0});
  CHECK(AdjustPValues(pValues, EPValueAdjustment::None) == pValues);
  CHECK(AdjustPValues({}, EPValueAdjustment::Holm).empty());
  CHECK(AdjustPValues(std::vector<Real>{0.3}, EPValueAdjustment::Holm)[0] == 0.3);
  const Real wrong = GENERATE(-0.1, 1.1, kNaN, kInfinity);
  CHECK_THROWS_WITH(AdjustPValues(std::vector<Real>{wrong}, EPValueAdjustment::None),
                    Contains("p value"));
}

TEST_CASE("friedman's test: rounding first base", "[campaign][statistics]") {
  // published: 11.143, df = 2, p = 0.003805; digits: R 4.2
  const SChiSquareResult result = TestFriedman(kRoundingTimes);
  CHECK_THAT(result.Statistic, WithinRel(11.14285714285714235, 1e-13));
  CHECK(result.DegreesOfFreedom == 2);
  CHECK_THAT(result.PValue, WithinRel(0.00380504077551136, 1e-12));
}

TEST_CASE("friedman's test: hostile input", "[campaign][statistics]") {
  CHECK_THROWS_WITH(TestFriedman({}), Contains("number of groups 0"));
  CHECK_THROWS_WITH(TestFriedman(std::vector<std::vector<Real>>{{1.0}, {2.0}}),
                    Contains("number of values 1, at least 2"));
  CHECK_THROWS_WITH(TestFriedman(std::vector<std::vector<Real>>{{1.0, 2.0}, {2.0, 3.0, 4.0}}),
                    Contains("block 2 has 3 values, block 1 has 2"));
  CheckRefusesHostileValues({1.0, 2.0}, [](const std::vector<Real>& values) {
    TestFriedman(std::vector<std::vector<Real>>{{1.0, 3.0}, values});
  });
  // each block has its own level, without any difference in it
  const SChiSquareResult equal =
      TestFriedman(std::vector<std::vector<Real>>{{1.0, 1.0}, {7.0, 7.0}});
  CHECK(equal.Statistic == 0.0);
  CHECK(equal.PValue == 1.0);
}

}  // namespace group_tests_test
