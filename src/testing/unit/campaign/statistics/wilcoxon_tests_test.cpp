#include "hostile_values.h"
#include "samples.h"

#include <argos3/campaign/statistics/rank_sum_test.h>
#include <argos3/campaign/statistics/signed_rank_test.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace wilcoxon_tests_test {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

constexpr Real kDigits = 1e-12;  // R printed 15

SRankTestOptions With(EAlternative alternative,
                      ENullDistribution distribution = ENullDistribution::Automatic) {
  SRankTestOptions options;
  options.Alternative = alternative;
  options.NullDistribution = distribution;
  return options;
}

void CheckInterval(const SConfidenceInterval& interval, Real lower, Real upper, Real level) {
  // the data have two or three decimals
  if (std::isinf(lower)) {
    CHECK(interval.Lower == lower);
  } else {
    CHECK_THAT(interval.Lower, WithinAbs(lower, 1e-12));
  }
  if (std::isinf(upper)) {
    CHECK(interval.Upper == upper);
  } else {
    CHECK_THAT(interval.Upper, WithinAbs(upper, 1e-12));
  }
  CHECK_THAT(interval.Level, WithinAbs(level, 1e-12));
}

std::vector<Real> DrawNormal(CRandomStream& stream, size_t count, Real mean) {
  std::vector<Real> values;
  for (size_t i = 0; i < count; ++i) {
    values.push_back(stream.Gaussian(1.0, mean));
  }
  return values;
}

}  // namespace

TEST_CASE("signed-rank test: depression data of Hollander and Wolfe", "[campaign][statistics]") {
  // published: V = 40, p = 0.0195 for the greater alternative, estimate 0.46; levels from the
  // distribution for 9 pairs; R 4.2: wilcox.test(x, y, paired = TRUE, conf.int = TRUE)
  const SRankTestResult greater =
      TestSignedRankOfPairs(kDepressionBefore, kDepressionAfter, With(EAlternative::Greater));
  CHECK(greater.IsExact);
  CHECK(greater.Statistic == 40.0);
  CHECK(greater.PValue == 0.01953125);
  CHECK_THAT(greater.Estimate, WithinAbs(0.46, 1e-12));
  CheckInterval(greater.Interval, 0.175, kInfinity, 0.951171875);
  const SRankTestResult less =
      TestSignedRankOfPairs(kDepressionBefore, kDepressionAfter, With(EAlternative::Less));
  CHECK(less.PValue == 0.986328125);
  CheckInterval(less.Interval, -kInfinity, 0.726, 0.951171875);
  const SRankTestResult both = TestSignedRankOfPairs(kDepressionBefore, kDepressionAfter);
  CHECK(both.PValue == 0.0390625);
  CheckInterval(both.Interval, 0.010, 0.786, 0.9609375);
}

TEST_CASE("signed-rank test: another location and level", "[campaign][statistics]") {
  // R 4.2: wilcox.test(x, y, paired = TRUE, mu = 0.3, conf.int = TRUE, conf.level = 0.9)
  SRankTestOptions options;
  options.Location = 0.3;
  options.Level = 0.9;
  const SRankTestResult result =
      TestSignedRankOfPairs(kDepressionBefore, kDepressionAfter, options);
  CHECK(result.Statistic == 28.0);
  CHECK(result.PValue == 0.5703125);
  CheckInterval(result.Interval, 0.175, 0.726, 0.90234375);
}

TEST_CASE("signed-rank test: normal approximation", "[campaign][statistics]") {
  // R 4.2: the same with exact = FALSE, tol.root = 1e-13
  const SRankTestResult both = TestSignedRankOfPairs(
      kDepressionBefore, kDepressionAfter, With(EAlternative::TwoSided, ENullDistribution::Normal));
  CHECK_FALSE(both.IsExact);
  CHECK_THAT(both.PValue, WithinRel(0.0440109840129515, kDigits));
  CheckInterval(both.Interval, 0.010, 0.786, 0.95);
  const SRankTestResult greater = TestSignedRankOfPairs(
      kDepressionBefore, kDepressionAfter, With(EAlternative::Greater, ENullDistribution::Normal));
  CHECK_THAT(greater.PValue, WithinRel(0.0220054920064757, kDigits));
  CheckInterval(greater.Interval, 0.175, kInfinity, 0.95);
}

TEST_CASE("signed-rank test: ties and zeros", "[campaign][statistics]") {
  // R 4.2: wilcox.test(ozone of May, mu = 18, conf.int = TRUE, tol.root = 1e-13)
  SRankTestOptions options;
  options.Location = 18.0;
  const SRankTestResult ozone = TestSignedRank(kOzone[0], options);
  CHECK_FALSE(ozone.IsExact);
  CHECK(ozone.Statistic == 182.5);
  CHECK_THAT(ozone.PValue, WithinRel(0.360346083586154, kDigits));
  CHECK(ozone.Estimate == 21.0);
  CheckInterval(ozone.Interval, 14.0, 28.0, 0.95);
  options.Alternative = EAlternative::Less;
  const SRankTestResult less = TestSignedRank(kOzone[0], options);
  CHECK_THAT(less.PValue, WithinRel(0.827233803956474, kDigits));
  CheckInterval(less.Interval, -kInfinity, 26.5, 0.95);
  // R 4.2: wilcox.test(extra ~ group, data = sleep, paired = TRUE, conf.int = TRUE)
  const SRankTestResult sleep = TestSignedRankOfPairs(kSleepDrug1, kSleepDrug2);
  CHECK(sleep.Statistic == 0.0);
  CHECK_THAT(sleep.PValue, WithinRel(0.00909069801592506, kDigits));
  CHECK_THAT(sleep.Estimate, WithinAbs(-1.4, 1e-12));
  CheckInterval(sleep.Interval, -2.95, -1.05, 0.95);
}

namespace {

// Checks for all alternatives that the interval of a test holds the locations that it accepts.
// @param test    the result for some options
// @param beside  smaller than the distance of any two locations that bound an interval
template <typename TEST>
void CheckHoldsAccepted(const TEST& test, Real beside) {
  const auto alternative =
      GENERATE(EAlternative::TwoSided, EAlternative::Less, EAlternative::Greater);
  const auto distribution = GENERATE(ENullDistribution::Automatic, ENullDistribution::Normal);
  CAPTURE(alternative, distribution);
  SRankTestOptions options = With(alternative, distribution);
  const SConfidenceInterval interval = test(options).Interval;
  const auto accepts = [&](Real location) {
    options.Location = location;
    return test(options).PValue > 0.05;
  };
  CHECK((alternative == EAlternative::Less) == std::isinf(interval.Lower));
  CHECK((alternative == EAlternative::Greater) == std::isinf(interval.Upper));
  if (alternative != EAlternative::Less) {
    CHECK(accepts(interval.Lower + beside));
    CHECK_FALSE(accepts(interval.Lower - beside));
  }
  if (alternative != EAlternative::Greater) {
    CHECK(accepts(interval.Upper - beside));
    CHECK_FALSE(accepts(interval.Upper + beside));
  }
}

}  // namespace

TEST_CASE("signed-rank test: the interval holds the locations that the test accepts",
          "[campaign][statistics]") {
  const size_t count = GENERATE(8u, 23u, 60u);
  CRandomStream stream(3, "test", "signed", "rank");
  const std::vector<Real> values = DrawNormal(stream, count, 0.2);
  // the distance of any two Walsh averages is greater
  CheckHoldsAccepted(
      [&values](const SRankTestOptions& options) { return TestSignedRank(values, options); }, 1e-9);
}

TEST_CASE("signed-rank test: the interval of few values with ties holds what the test accepts",
          "[campaign][statistics]") {
  // R 4.2 gives [-2, 1.5] with level 0.9 for the first sample
  const std::vector<Real> values =
      GENERATE(as<std::vector<Real>>{}, std::vector<Real>{-3, -2, -1, 1, 1, 2},
               std::vector<Real>{-5, -2, 1, 1, 1, 2, 3, 3});
  SRankTestOptions options = With(EAlternative::TwoSided, ENullDistribution::Normal);
  const SConfidenceInterval interval = TestSignedRank(values, options).Interval;
  REQUIRE(interval.Level == 0.95);
  const auto accepts = [&](Real location) {
    options.Location = location;
    return TestSignedRank(values, options).PValue > 0.05;
  };
  CHECK(accepts(interval.Lower + 1e-6));
  CHECK_FALSE(accepts(interval.Lower - 1e-6));
  CHECK(accepts(interval.Upper - 1e-6));
  CHECK_FALSE(accepts(interval.Upper + 1e-6));
}

TEST_CASE("signed-rank test: reflection exchanges the sides", "[campaign][statistics]") {
  std::vector<Real> mirrored = kOzone[1];
  std::transform(mirrored.begin(), mirrored.end(), mirrored.begin(), std::negate<>());
  const SRankTestOptions left = {EAlternative::Less, 15.0};
  const SRankTestOptions right = {EAlternative::Greater, -15.0};
  const SRankTestResult result = TestSignedRank(kOzone[1], left);
  const SRankTestResult reflection = TestSignedRank(mirrored, right);
  CHECK(reflection.PValue == result.PValue);
  CHECK(reflection.Estimate == -result.Estimate);
  CHECK(reflection.Interval.Lower == -result.Interval.Upper);
}

TEST_CASE("signed-rank test: hostile input", "[campaign][statistics]") {
  CHECK_THROWS_WITH(TestSignedRank({}), Contains("number of values 0"));
  CHECK_THROWS_WITH(TestSignedRankOfPairs(kSleepDrug1, kDepressionAfter),
                    Contains("x has 10, y has 9"));
  CHECK_THROWS_WITH(TestSignedRankOfPairs({}, {}), Contains("number of values 0"));
  CheckRefusesHostileValues({1.0, 2.0}, [](const std::vector<Real>& x) { TestSignedRank(x); });
  CheckRefusesHostileValues({1.0, 2.0}, [](const std::vector<Real>& x) {
    TestSignedRankOfPairs(x, std::vector<Real>{1.0, 3.0});
  });
  CHECK_THROWS_WITH(TestSignedRank(std::vector<Real>{1.0}, {EAlternative::Less, kNaN}),
                    Contains("location"));
  CHECK_THROWS_WITH(TestSignedRank(std::vector<Real>{1.0}, {EAlternative::Less, 0.0, 1.0}),
                    Contains("confidence level 1"));
  // one value: R 4.2: p = 1, interval [3, 3], level 0
  const SRankTestResult one = TestSignedRank(std::vector<Real>{3.0});
  CHECK(one.PValue == 1.0);
  CHECK(one.Estimate == 3.0);
  CheckInterval(one.Interval, 3.0, 3.0, 0.0);
  // no difference at all
  const SRankTestResult none = TestSignedRankOfPairs(kSleepDrug1, kSleepDrug1);
  CHECK(none.PValue == 1.0);
  CHECK(none.Estimate == 0.0);
  CheckInterval(none.Interval, 0.0, 0.0, 0.0);
  // equal values; R 4.2: wilcox.test(rep(2, 8)): p = 0.005962
  const SRankTestResult equal = TestSignedRank(std::vector<Real>(8, 2.0));
  CHECK_THAT(equal.PValue, WithinRel(0.00596207853209371, 1e-10));
  CheckInterval(equal.Interval, 2.0, 2.0, 0.0);
}

TEST_CASE("signed-rank test: too few values for the level give their range",
          "[campaign][statistics]") {
  // P(V <= 0) = 1/16 for four values
  const SRankTestResult exact = TestSignedRank(std::vector<Real>{1.0, 2.0, 4.0, 8.0});
  CheckInterval(exact.Interval, 1.0, 8.0, 1.0 - 2.0 / 16.0);
  const SRankTestResult approximate = TestSignedRank(std::vector<Real>{1.0, 1.0, 4.0});
  CHECK(approximate.Interval.Lower == 1.0);
  CHECK(approximate.Interval.Upper == 4.0);
  CHECK(approximate.Interval.Level > 0.7);
  CHECK(approximate.Interval.Level < 0.9);
}

TEST_CASE("rank-sum test: permeability data of Hollander and Wolfe", "[campaign][statistics]") {
  // published: W = 35, p = 0.1272 for the greater alternative;
  // R 4.2: wilcox.test(x, y, conf.int = TRUE)
  const SRankTestResult greater =
      TestRankSum(kPermeabilityAtTerm, kPermeabilityBefore, With(EAlternative::Greater));
  CHECK(greater.IsExact);
  CHECK(greater.Statistic == 35.0);
  CHECK_THAT(greater.PValue, WithinRel(0.127206127206127, kDigits));
  CHECK_THAT(greater.Estimate, WithinAbs(0.305, 1e-12));
  CheckInterval(greater.Interval, -0.08, kInfinity, 0.95038295038295038);
  const SRankTestResult less =
      TestRankSum(kPermeabilityAtTerm, kPermeabilityBefore, With(EAlternative::Less));
  CHECK_THAT(less.PValue, WithinRel(0.896769896769897, kDigits));
  CheckInterval(less.Interval, -kInfinity, 0.72, 0.95038295038295038);
  const SRankTestResult both = TestRankSum(kPermeabilityAtTerm, kPermeabilityBefore);
  CHECK_THAT(both.PValue, WithinRel(0.254412254412254, kDigits));
  CheckInterval(both.Interval, -0.15, 0.76, 0.96003996003996004);
}

TEST_CASE("rank-sum test: normal approximation and ties", "[campaign][statistics]") {
  // R 4.2: wilcox.test(x, y, exact = FALSE, conf.int = TRUE, tol.root = 1e-13)
  const SRankTestResult both = TestRankSum(kPermeabilityAtTerm, kPermeabilityBefore,
                                           With(EAlternative::TwoSided, ENullDistribution::Normal));
  CHECK_FALSE(both.IsExact);
  CHECK_THAT(both.PValue, WithinRel(0.244623605126983, kDigits));
  CheckInterval(both.Interval, -0.15, 0.76, 0.95);
  const SRankTestResult less = TestRankSum(kPermeabilityAtTerm, kPermeabilityBefore,
                                           With(EAlternative::Less, ENullDistribution::Normal));
  CHECK_THAT(less.PValue, WithinRel(0.900775348203994, kDigits));
  CheckInterval(less.Interval, -kInfinity, 0.72, 0.95);
  // R 4.2: ozone of May against August; published in ?wilcox.test: W = 127.5, p = 0.0001208
  const SRankTestResult ozone = TestRankSum(kOzone[0], kOzone[3]);
  CHECK(ozone.Statistic == 127.5);
  CHECK_THAT(ozone.PValue, WithinRel(0.000120807830768774, kDigits));
  CHECK(ozone.Estimate == -32.0);
  CheckInterval(ozone.Interval, -53.0, -15.0, 0.95);
  // R 4.2: wilcox.test(extra ~ group, data = sleep, conf.int = TRUE)
  const SRankTestResult sleep = TestRankSum(kSleepDrug1, kSleepDrug2);
  CHECK(sleep.Statistic == 25.5);
  CHECK_THAT(sleep.PValue, WithinRel(0.0693275754336266, kDigits));
  CheckInterval(sleep.Interval, -3.6, 0.1, 0.95);
}

TEST_CASE("rank-sum test: the interval holds the shifts that the test accepts",
          "[campaign][statistics]") {
  const size_t count = GENERATE(6u, 20u, 70u);
  CRandomStream stream(4, "test", "rank", "sum");
  const std::vector<Real> x = DrawNormal(stream, count, 0.4);
  const std::vector<Real> y = DrawNormal(stream, count + 3, 0.0);
  // the distance of any two differences is greater
  CheckHoldsAccepted([&](const SRankTestOptions& options) { return TestRankSum(x, y, options); },
                     1e-9);
}

TEST_CASE("rank-sum test: exchanging the samples mirrors the result", "[campaign][statistics]") {
  const SRankTestResult forward =
      TestRankSum(kPermeabilityAtTerm, kPermeabilityBefore, With(EAlternative::Greater));
  const SRankTestResult backward =
      TestRankSum(kPermeabilityBefore, kPermeabilityAtTerm, With(EAlternative::Less));
  CHECK(backward.Statistic == 50.0 - forward.Statistic);
  // the recurrence adds in another order
  CHECK_THAT(backward.PValue, WithinRel(forward.PValue, 1e-15));
  CHECK(backward.Estimate == -forward.Estimate);
  CHECK(backward.Interval.Upper == -forward.Interval.Lower);
}

TEST_CASE("rank-sum test: the normal approximation is close to the exact distribution",
          "[campaign][statistics]") {
  CRandomStream stream(9, "test", "rank", "sum");
  const std::vector<Real> x = DrawNormal(stream, 40, 0.3);
  const std::vector<Real> y = DrawNormal(stream, 45, 0.0);
  const Real exact = TestRankSum(x, y).PValue;
  const Real normal =
      TestRankSum(x, y, With(EAlternative::TwoSided, ENullDistribution::Normal)).PValue;
  // for 40 and more values, in the bulk: about 0.001
  CHECK_THAT(normal, WithinAbs(exact, 0.002));
}

TEST_CASE("rank-sum test: hostile input", "[campaign][statistics]") {
  const std::vector<Real> some = {1.0, 2.0, 4.0};
  CHECK_THROWS_WITH(TestRankSum({}, some), Contains("x: number of values 0"));
  CHECK_THROWS_WITH(TestRankSum(some, {}), Contains("y: number of values 0"));
  CHECK_THROWS_WITH(TestRankSum(some, some, {EAlternative::Less, kInfinity}), Contains("location"));
  CHECK_THROWS_WITH(TestRankSum(some, some, {EAlternative::Less, 0.0, kNaN}), Contains("level"));
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& x) { TestRankSum(x, some); });
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& y) { TestRankSum(some, y); });
  // all values equal
  const SRankTestResult equal = TestRankSum(std::vector<Real>(4, 2.0), std::vector<Real>(3, 2.0));
  CHECK(equal.PValue == 1.0);
  CHECK(equal.Estimate == 0.0);
  CHECK(equal.Interval.Lower == 0.0);
  CHECK(equal.Interval.Upper == 0.0);
  // so many that the variance is a negative rounding error
  const SRankTestResult many = TestRankSum(std::vector<Real>(330291, 2.0), std::vector<Real>{2.0});
  CHECK(many.PValue == 1.0);
  CHECK(many.Interval.Lower == 0.0);
  // one value each; R 4.2: p = 1
  const SRankTestResult ones = TestRankSum(std::vector<Real>{5.0}, std::vector<Real>{3.0});
  CHECK(ones.Statistic == 1.0);
  CHECK(ones.PValue == 1.0);
  CheckInterval(ones.Interval, 2.0, 2.0, 0.0);
}

}  // namespace wilcoxon_tests_test
