#include "hostile_values.h"
#include "samples.h"

#include <argos3/campaign/statistics/line_fit.h>
#include <argos3/campaign/statistics/power_law_fit.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

namespace fits_test {

using Catch::Contains;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using namespace argos;

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

TEST_CASE("fit of a line: roundings leave no negative determination", "[campaign][statistics]") {
  // no slope: the residuals exceed the deviations by a rounding
  const std::vector<Real> x = {3.0, 7.0, 7.0};
  const std::vector<Real> y = {0.8, 0.9, 0.7};
  CHECK(FitLine(x, y).Determination == 0.0);
}

}  // namespace fits_test
