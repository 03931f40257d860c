#include "hostile_values.h"
#include "samples.h"

#include <argos3/campaign/statistics/correlation.h>
#include <argos3/campaign/statistics/line_fit.h>
#include <argos3/campaign/statistics/power_law_fit.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace fits_test {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

namespace {

// lightness and quality of canned tuna: M. Hollander and D. A. Wolfe (1973), 187; R: ?cor.test
const std::vector<Real> kLightness = {44.4, 45.9, 41.9, 53.3, 44.7, 44.1, 50.7, 45.2, 60.1};
const std::vector<Real> kQuality = {2.6, 3.1, 2.5, 5.0, 3.6, 4.0, 5.2, 2.8, 3.8};

std::vector<Real> Negated(std::vector<Real> values) {
  for (Real& value : values) {
    value = -value;
  }
  return values;
}

}  // namespace

TEST_CASE("fit of a line: stopping distances of cars", "[campaign][statistics]") {
  // R 4.2: summary(lm(dist ~ speed, cars)); published: slope 3.932, error 0.4155
  const SLineFit fit = FitLine(kCarSpeeds, kCarDistances);
  CHECK_THAT(fit.Slope, WithinRel(3.93240875912409, 1e-13));
  CHECK_THAT(fit.SlopeError, WithinRel(0.415512776657122, 1e-13));
  CHECK_THAT(fit.Intercept, WithinRel(-17.57909489051089, 1e-12));
  CHECK_THAT(fit.InterceptError, WithinRel(6.758440169379234, 1e-12));
  CHECK_THAT(fit.ResidualDeviation, WithinRel(15.379586748819907, 1e-13));
  CHECK_THAT(fit.Determination, WithinRel(0.651079380758251, 1e-12));
  CHECK(fit.DegreesOfFreedom == 48);
}

TEST_CASE("fit of a line: a line is found", "[campaign][statistics]") {
  const std::vector<Real> x = {1e9, 1e9 + 1.0, 1e9 + 2.0, 1e9 + 5.0};
  const SLineFit fit = FitLine(x, std::vector<Real>{3.0, 1.0, -1.0, -7.0});
  CHECK_THAT(fit.Slope, WithinRel(-2.0, 1e-14));
  CHECK_THAT(fit.SlopeError, WithinAbs(0.0, 1e-14));
  CHECK_THAT(fit.Determination, WithinAbs(1.0, 1e-14));
  const SLineFit level = FitLine(x, std::vector<Real>(4, 0.3));
  CHECK(level.Slope == 0.0);
  CHECK(level.Intercept == 0.3);
  CHECK(level.Determination == 1.0);
}

TEST_CASE("fit of a power law: stopping distances of cars", "[campaign][statistics]") {
  // R 4.2: l <- lm(log(dist) ~ log(speed), cars); confint(l)
  const SPowerLawFit fit = FitPowerLaw(kCarSpeeds, kCarDistances);
  CHECK_THAT(fit.Exponent, WithinRel(1.602391206440507, 1e-12));
  CHECK_THAT(fit.ExponentError, WithinRel(0.139537613294002, 1e-12));
  CHECK_THAT(fit.Factor, WithinRel(0.4820686488987, 1e-11));
  CHECK_THAT(fit.Determination, WithinRel(0.733144439277278, 1e-12));
  CHECK_THAT(fit.ExponentInterval.Lower, WithinRel(1.32183203115566, 1e-12));
  CHECK_THAT(fit.ExponentInterval.Upper, WithinRel(1.8829503817253563, 1e-12));
}

TEST_CASE("fit of a power law: an exact law is found", "[campaign][statistics]") {
  const Real exponent = GENERATE(-1.5, 0.0, 2.0);
  const std::vector<Real> x = {1.0, 10.0, 100.0, 1000.0};
  std::vector<Real> y;
  for (const Real value : x) {
    y.push_back(0.25 * std::pow(value, exponent));
  }
  const SPowerLawFit fit = FitPowerLaw(x, y);
  CHECK_THAT(fit.Exponent, WithinAbs(exponent, 1e-14));
  CHECK_THAT(fit.Factor, WithinRel(0.25, 1e-13));
}

TEST_CASE("fit of a power law to means: values of 0 count", "[campaign][statistics]") {
  // means 2 and 200; only the first has a variance, 8: of its logarithm 8 / (2 2^2) = 1, with one
  // degree of freedom; the weights of the slope are -1 and 1 over log(10)
  const std::vector<SPowerLawSample> samples = {{1.0, {0.0, 4.0}}, {10.0, {200.0, 200.0}}};
  const SPowerLawFit fit = FitPowerLawOfMeans(samples);
  CHECK_THAT(fit.Exponent, WithinAbs(2.0, 1e-14));
  CHECK_THAT(fit.Factor, WithinRel(2.0, 1e-14));
  CHECK_THAT(fit.ExponentError, WithinRel(0.43429448190325182, 1e-14));
  // qt(0.975, 1) = 12.706204736174694
  CHECK_THAT(fit.ExponentInterval.Upper,
             WithinRel(2.0 + 12.706204736174694 * 0.43429448190325182, 1e-12));
  // a constant without any variance
  const SPowerLawFit constant =
      FitPowerLawOfMeans(std::vector<SPowerLawSample>{{1.0, {3.0, 3.0}}, {10.0, {3.0, 3.0}}});
  CHECK(constant.Exponent == 0.0);
  CHECK(constant.Determination == 1.0);
  CHECK(constant.ExponentInterval.Lower == 0.0);
  CHECK(constant.ExponentInterval.Upper == 0.0);
  CHECK_THROWS_WITH(FitPowerLawOfMeans(std::vector<SPowerLawSample>{{1.0, {0, 0}}, {2.0, {1, 1}}}),
                    Contains("means: value 1 is 0; positive"));
  CHECK_THROWS_WITH(FitPowerLawOfMeans(std::vector<SPowerLawSample>{{1.0, {1, 2}}}),
                    Contains("number of values 1, at least 2"));
  CHECK_THROWS_WITH(FitPowerLawOfMeans(std::vector<SPowerLawSample>{{1.0, {1}}, {2.0, {1, 2}}}),
                    Contains("number of values 1, at least 2"));
  CHECK_THROWS_WITH(FitPowerLawOfMeans(std::vector<SPowerLawSample>{{3.0, {1, 2}}, {3.0, {1, 2}}}),
                    Contains("all x are 3"));
}

TEST_CASE("fits: hostile input", "[campaign][statistics]") {
  const std::vector<Real> some = {1.0, 2.0, 4.0};
  const std::vector<Real> equal(3, 2.0);
  CHECK_THROWS_WITH(FitLine({}, {}), Contains("number of values 0, at least 3"));
  CHECK_THROWS_WITH(FitLine(std::vector<Real>{1, 2}, std::vector<Real>{1, 2}),
                    Contains("number of values 2, at least 3"));
  CHECK_THROWS_WITH(FitLine(some, std::vector<Real>{1, 2}), Contains("x has 3, y has 2"));
  CHECK_THROWS_WITH(FitLine(equal, some), Contains("all x are 2"));
  CHECK_THROWS_WITH(FitPowerLaw(equal, some), Contains("all x are"));
  CHECK_THROWS_WITH(FitPowerLaw(some, std::vector<Real>{1.0, 0.0, 2.0}),
                    Contains("y: value 2 is 0; positive"));
  CHECK_THROWS_WITH(FitPowerLaw(std::vector<Real>{1.0, 3.0, -2.0}, some),
                    Contains("x: value 3 is -2; positive"));
  CHECK_THROWS_WITH(FitPowerLaw(some, some, 0.0), Contains("confidence level 0"));
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& x) { FitLine(x, some); });
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& y) { FitLine(some, y); });
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& x) { FitPowerLaw(x, some); });
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& y) { FitPowerLaw(some, y); });
}

TEST_CASE("pearson's correlation: published examples", "[campaign][statistics]") {
  // R 4.2: cor.test(speed, dist), cor.test(x, y) of ?cor.test: 0.5712, p = 0.1082
  const SCorrelation cars = ComputePearsonCorrelation(kCarSpeeds, kCarDistances);
  CHECK_THAT(cars.Coefficient, WithinRel(0.806894900689210, 1e-13));
  CHECK_THAT(cars.PValue, WithinRel(1.48983649629509e-12, 1e-9));
  const SCorrelation tuna = ComputePearsonCorrelation(kLightness, kQuality);
  CHECK_THAT(tuna.Coefficient, WithinRel(0.571181557563829, 1e-13));
  CHECK_THAT(tuna.PValue, WithinRel(0.108173054349494, 1e-12));
  const SCorrelation mirrored = ComputePearsonCorrelation(kLightness, Negated(kQuality));
  CHECK_THAT(mirrored.Coefficient, WithinRel(-tuna.Coefficient, 1e-14));
  CHECK_THAT(mirrored.PValue, WithinRel(tuna.PValue, 1e-12));
}

TEST_CASE("spearman's correlation: exact, by series, and with ties", "[campaign][statistics]") {
  // R 4.2: cor.test(x, y, method = "spearman") of ?cor.test: S = 48, rho = 0.6, p = 0.0968
  const SCorrelation tuna = ComputeSpearmanCorrelation(kLightness, kQuality);
  CHECK_THAT(tuna.Coefficient, WithinRel(0.6, 1e-14));
  CHECK_THAT(tuna.PValue, WithinRel(0.0967978395061728, 1e-13));
  const std::vector<Real> x = {-0.63, 0.18, -0.84, 1.60,  0.33, -0.82,
                               0.49,  0.74, 0.58,  -0.31, 1.51, 0.39};
  const std::vector<Real> y = {-0.94, -2.12, 0.70, 0.76, 0.15, 0.53,
                               1.07,  0.96,  1.21, 0.63, 0.83, -1.79};
  const SCorrelation twelve = ComputeSpearmanCorrelation(x, y);
  CHECK_THAT(twelve.Coefficient, WithinRel(0.5384615384615385, 1e-13));
  CHECK_THAT(twelve.PValue, WithinRel(0.0749022866724823, 1e-12));
  const SCorrelation mirrored = ComputeSpearmanCorrelation(x, Negated(y));
  CHECK_THAT(mirrored.Coefficient, WithinRel(-0.5384615384615385, 1e-13));
  CHECK_THAT(mirrored.PValue, WithinRel(0.0749022866724823, 1e-12));
  const SCorrelation cars = ComputeSpearmanCorrelation(kCarSpeeds, kCarDistances);
  CHECK_THAT(cars.Coefficient, WithinRel(0.830356838832993, 1e-13));
  CHECK_THAT(cars.PValue, WithinRel(8.82455843761991e-14, 1e-9));
}

TEST_CASE("correlation: samples of different sizes of spearman's test agree",
          "[campaign][statistics]") {
  // the series (1290 pairs) and student's t (1291 pairs) for nearly the same data
  CRandomStream stream(2, "test", "spearman", "sizes");
  std::vector<Real> x;
  std::vector<Real> y;
  for (int i = 0; i < 1290; ++i) {
    x.push_back(stream.Gaussian(1.0));
    y.push_back(0.05 * x.back() + stream.Gaussian(1.0));
  }
  const SCorrelation bySeries = ComputeSpearmanCorrelation(x, y);
  x.push_back(0.0);
  y.push_back(0.0);
  const SCorrelation byStudent = ComputeSpearmanCorrelation(x, y);
  CHECK_THAT(byStudent.PValue, WithinRel(bySeries.PValue, 0.02));
}

TEST_CASE("correlation: hostile input", "[campaign][statistics]") {
  const auto compute = GENERATE(&ComputePearsonCorrelation, &ComputeSpearmanCorrelation);
  const std::vector<Real> some = {1.0, 2.0, 4.0};
  CHECK_THROWS_WITH(compute({}, {}), Contains("number of values 0, at least 3"));
  CHECK_THROWS_WITH(compute(some, std::vector<Real>{1.0}), Contains("x has 3, y has 1"));
  CHECK_THROWS_WITH(compute(std::vector<Real>(3, 2.0), some), Contains("x: all values are 2"));
  CHECK_THROWS_WITH(compute(some, std::vector<Real>(3, 2.0)), Contains("y: all values are 2"));
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& x) { compute(x, some); });
  CheckRefusesHostileValues(some, [&](const std::vector<Real>& y) { compute(some, y); });
  CHECK_THAT(compute(some, some).Coefficient, WithinAbs(1.0, 1e-15));
  CHECK_THAT(compute(some, Negated(some)).Coefficient, WithinAbs(-1.0, 1e-15));
}

TEST_CASE("correlation: roundings leave no coefficient beyond 1", "[campaign][statistics]") {
  // the sum of products is 1.0000000000000002 here
  const std::vector<Real> some = {2.0, 5.0, 2.0};
  CHECK(ComputePearsonCorrelation(some, some).Coefficient == 1.0);
  CHECK(ComputePearsonCorrelation(some, Negated(some)).Coefficient == -1.0);
  CHECK(ComputePearsonCorrelation(some, some).PValue == 0.0);
}

TEST_CASE("fit of a line: roundings leave no negative determination", "[campaign][statistics]") {
  // no slope: the residuals exceed the deviations by a rounding
  const std::vector<Real> x = {3.0, 7.0, 7.0};
  const std::vector<Real> y = {0.8, 0.9, 0.7};
  CHECK(FitLine(x, y).Determination == 0.0);
}

TEST_CASE("correlation: perfect ones", "[campaign][statistics]") {
  const std::vector<Real> some = {1.0, 2.0, 4.0, 5.0, 9.0};
  // 1 - r is a rounding error of 1e-16
  CHECK(ComputePearsonCorrelation(some, some).PValue < 1e-20);
  // two of 5! orders
  CHECK_THAT(ComputeSpearmanCorrelation(some, some).PValue, WithinRel(2.0 / 120.0, 1e-14));
  CHECK_THAT(ComputeSpearmanCorrelation(some, Negated(some)).PValue, WithinRel(2.0 / 120.0, 1e-14));
  // in the middle of the distribution both tails are above 1/2
  const SCorrelation none = ComputeSpearmanCorrelation(std::vector<Real>{1.0, 2.0, 3.0, 4.0},
                                                       std::vector<Real>{2.0, 4.0, 1.0, 3.0});
  CHECK_THAT(none.Coefficient, WithinAbs(0.0, 1e-15));
  CHECK(none.PValue == 1.0);
}

}  // namespace fits_test
