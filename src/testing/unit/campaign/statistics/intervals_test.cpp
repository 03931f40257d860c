#include "hostile_values.h"
#include "samples.h"

#include <argos3/campaign/statistics/mean_interval.h>
#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/proportion_interval.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace intervals_test {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

std::vector<Real> SleepDifferences() {
  std::vector<Real> differences;
  for (size_t i = 0; i < kSleepDrug1.size(); ++i) {
    differences.push_back(kSleepDrug1[i] - kSleepDrug2[i]);
  }
  return differences;
}

}  // namespace

TEST_CASE("student's t: quantiles of the printed tables", "[campaign][statistics]") {
  struct SEntry {
    Real Level;
    Real Freedom;
    Real Quantile;
  };
  const std::vector<SEntry> table = {{0.95, 1, 12.706},  {0.95, 2, 4.303},  {0.95, 3, 3.182},
                                     {0.95, 5, 2.571},   {0.95, 10, 2.228}, {0.95, 30, 2.042},
                                     {0.95, 120, 1.980}, {0.99, 1, 63.657}, {0.99, 5, 4.032},
                                     {0.99, 10, 3.169},  {0.90, 4, 2.132},  {0.80, 20, 1.325}};
  for (const SEntry& entry : table) {
    CAPTURE(entry.Level, entry.Freedom);
    // rounded to three decimals
    CHECK_THAT(ComputeCentralStudentQuantile(entry.Level, entry.Freedom),
               WithinAbs(entry.Quantile, 0.0005 + 1e-9));
  }
  // R 4.2: qt(0.975, 1), qt(0.995, 2), qt(0.9, 1000), qt(0.9995, 3)
  CHECK_THAT(ComputeCentralStudentQuantile(0.95, 1.0), WithinRel(12.70620473617469, 1e-12));
  CHECK_THAT(ComputeCentralStudentQuantile(0.99, 2.0), WithinRel(9.92484320091829, 1e-12));
  CHECK_THAT(ComputeCentralStudentQuantile(0.8, 1000.0), WithinRel(1.28239872146092, 1e-12));
  CHECK_THAT(ComputeCentralStudentQuantile(0.999, 3.0), WithinRel(12.923978636688, 1e-12));
}

TEST_CASE("student's t: the quantile inverts the distribution", "[campaign][statistics]") {
  const Real level = GENERATE(1e-9, 0.001, 0.1, 0.5, 0.9, 0.999, 1.0 - 1e-9);
  for (Real freedom = 1.0; freedom < 2e6; freedom = std::ceil(freedom * 1.7)) {
    CAPTURE(level, freedom);
    const Real t = ComputeCentralStudentQuantile(level, freedom);
    const Real outside = 2.0 * ComputeStudentLowerTail(-t, freedom);
    // the quantile is found to 1e-14, GSL's distribution is known to 1e-12
    CHECK_THAT(outside, WithinRel(1.0 - level, 1e-11));
  }
  CHECK_THROWS_WITH(ComputeCentralStudentQuantile(0.95, 0.5), Contains("degrees of freedom"));
}

TEST_CASE("probability: numbers of R", "[campaign][statistics]") {
  // R 4.2: pt(-2.5, 7), pchisq(5.5, 3, lower = FALSE), qnorm(0.975)
  CHECK_THAT(ComputeStudentLowerTail(-2.5, 7.0), WithinRel(0.0204961092928764, 1e-12));
  CHECK_THAT(ComputeChiSquareUpperTail(5.5, 3.0), WithinRel(0.138638617382415, 1e-12));
  CHECK(ComputeChiSquareUpperTail(0.0, 3.0) == 1.0);
  CHECK(ComputeChiSquareUpperTail(-1e-16, 3.0) == 1.0);
  CHECK_THAT(ComputeCentralNormalQuantile(0.95), WithinRel(1.959963984540054, 1e-15));
  CHECK_THAT(ComputeNormalLowerTail(-1.959963984540054), WithinRel(0.025, 1e-14));
  CHECK_THAT(ComputeNormalUpperTail(-1.959963984540054), WithinRel(0.975, 1e-14));
}

TEST_CASE("interval of the mean: t.test of the sleep data", "[campaign][statistics]") {
  // R 4.2: t.test(extra ~ group, data = sleep, paired = TRUE)
  const SConfidenceInterval interval = ComputeMeanInterval(SleepDifferences());
  CHECK_THAT(interval.Lower, WithinRel(-2.459885763276982, 1e-13));
  CHECK_THAT(interval.Upper, WithinRel(-0.700114236723018, 1e-13));
  CHECK(interval.Level == 0.95);
  const SConfidenceInterval wide = ComputeMeanInterval(SleepDifferences(), 0.99);
  CHECK_THAT(wide.Lower, WithinRel(-2.844051885104825, 1e-13));
  CHECK_THAT(wide.Upper, WithinRel(-0.315948114895175, 1e-13));
}

TEST_CASE("interval of the mean: hostile input", "[campaign][statistics]") {
  const SConfidenceInterval equal = ComputeMeanInterval(std::vector<Real>(5, 0.1));
  CHECK(equal.Lower == 0.1);
  CHECK(equal.Upper == 0.1);
  CHECK_THROWS_WITH(ComputeMeanInterval({}), Contains("number of values 0, at least 2"));
  CHECK_THROWS_WITH(ComputeMeanInterval(std::vector<Real>{1.0}), Contains("values 1, at least 2"));
  CheckRefusesHostileValues({1.0, 2.0, 3.0},
                            [](const std::vector<Real>& values) { ComputeMeanInterval(values); });
  const Real level = GENERATE(0.0, 1.0, -1.0, 95.0, kNaN);
  CHECK_THROWS_WITH(ComputeMeanInterval(std::vector<Real>{1.0, 2.0}, level),
                    Contains("it must be above 0 and below 1"));
}

TEST_CASE("interval of a proportion: Wilson's, as Newcombe printed them",
          "[campaign][statistics]") {
  struct SEntry {
    size_t Successes;
    size_t Trials;
    Real Lower;
    Real Upper;
  };
  // R. G. Newcombe, "Two-sided confidence intervals for the single proportion", Statistics in
  // Medicine 17 (1998), table I, method 3
  const std::vector<SEntry> table = {{81, 263, 0.2553, 0.3662},
                                     {15, 148, 0.0624, 0.1605},
                                     {0, 20, 0.0, 0.1611},
                                     {1, 29, 0.0061, 0.1718}};
  for (const SEntry& entry : table) {
    CAPTURE(entry.Successes, entry.Trials);
    const SConfidenceInterval interval = ComputeProportionInterval(entry.Successes, entry.Trials);
    // rounded to four decimals
    CHECK_THAT(interval.Lower, WithinAbs(entry.Lower, 0.00005 + 1e-9));
    CHECK_THAT(interval.Upper, WithinAbs(entry.Upper, 0.00005 + 1e-9));
    const SConfidenceInterval mirrored =
        ComputeProportionInterval(entry.Trials - entry.Successes, entry.Trials);
    CHECK_THAT(mirrored.Lower, WithinAbs(1.0 - interval.Upper, 1e-15));
    CHECK_THAT(mirrored.Upper, WithinAbs(1.0 - interval.Lower, 1e-15));
  }
  // R 4.2: prop.test(7, 40, correct = FALSE, conf.level = 0.9)
  const SConfidenceInterval interval = ComputeProportionInterval(7, 40, 0.9);
  CHECK_THAT(interval.Lower, WithinRel(0.0977604430891172, 1e-12));
  CHECK_THAT(interval.Upper, WithinRel(0.2934192985304305, 1e-12));
}

TEST_CASE("interval of a proportion: bounds stay in [0,1], wrong counts are errors",
          "[campaign][statistics]") {
  CHECK(ComputeProportionInterval(0, 3).Lower == 0.0);
  CHECK(ComputeProportionInterval(3, 3).Upper == 1.0);
  CHECK(ComputeProportionInterval(3, 3).Lower > 0.0);
  CHECK_THROWS_WITH(ComputeProportionInterval(0, 0), Contains("0 successes in 0 trials"));
  CHECK_THROWS_WITH(ComputeProportionInterval(4, 3), Contains("4 successes in 3 trials"));
  CHECK_THROWS_WITH(ComputeProportionInterval(1, 3, 0.0), Contains("confidence level 0"));
}

}  // namespace intervals_test
