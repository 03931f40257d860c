#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <type_traits>

namespace angles_test {

using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

constexpr Real kPi = 3.141592653589793;

// reference: the definition by repeated steps
Real WrapByRepetition(Real value, Real min, Real max) {
  const Real span = max - min;
  while (value > max) {
    value -= span;
  }
  while (value < min) {
    value += span;
  }
  return value;
}

// the constants are initialised at compile time, so that static initialisers of users can use them
static_assert(CRadians::PI.GetValue() == kPi);
static_assert(CRadians::TWO_PI.GetValue() == 2.0 * kPi);
static_assert(CRadians::PI_OVER_TWO.GetValue() == kPi / 2.0);
static_assert(CRadians::PI_OVER_THREE.GetValue() == kPi / 3.0);
static_assert(CRadians::PI_OVER_FOUR.GetValue() == kPi / 4.0);
static_assert(CRadians::PI_OVER_SIX.GetValue() == kPi / 6.0);
static_assert(CRadians::ZERO.GetValue() == 0.0);
static_assert(CRadians::SIGNED_RANGE.GetMin() == -CRadians::PI);
static_assert(CRadians::SIGNED_RANGE.GetMax() == CRadians::PI);
static_assert(CRadians::UNSIGNED_RANGE.GetMin() == CRadians::ZERO);
static_assert(CRadians::UNSIGNED_RANGE.GetMax() == CRadians::TWO_PI);
static_assert(CRadians::RADIANS_TO_DEGREES == 180.0 / kPi);
static_assert(ARGOS_PI == kPi);

}  // namespace

TEMPLATE_TEST_CASE("angles: arithmetic equals that of numbers", "[core][math]", CRadians,
                   CDegrees) {
  using TAngle = TestType;
  STATIC_REQUIRE(std::is_trivially_copyable_v<TAngle>);
  STATIC_REQUIRE(sizeof(TAngle) == sizeof(Real));
  STATIC_REQUIRE_FALSE(std::is_convertible_v<Real, TAngle>);

  const TAngle three(3.0);
  TAngle angle(1.5);
  CHECK(TAngle().GetValue() == 0.0);
  CHECK((-three).GetValue() == -3.0);
  CHECK((-three).GetAbsoluteValue() == 3.0);
  CHECK(&+angle == &angle);
  CHECK((angle + three).GetValue() == 4.5);
  CHECK((angle - three).GetValue() == -1.5);
  CHECK((angle * 2.0).GetValue() == 3.0);
  CHECK((2.0 * angle).GetValue() == 3.0);
  CHECK((angle / 2.0).GetValue() == 0.75);
  CHECK(three / angle == 2.0);

  CHECK((angle += three).GetValue() == 4.5);
  CHECK((angle -= three).GetValue() == 1.5);
  CHECK((angle *= 4.0).GetValue() == 6.0);
  CHECK((angle /= 2.0).GetValue() == 3.0);
  CHECK(angle == three);
  angle.SetValue(-1.0);
  CHECK(angle != three);
  CHECK(angle < three);
  CHECK(angle <= three);
  CHECK(three > angle);
  CHECK(three >= three);

  // angles are keys in the readings of rotating sensors
  std::map<TAngle, int> readings{{three, 1}, {angle, 2}};
  CHECK(readings.begin()->second == 2);
}

TEST_CASE("angles: radians and degrees convert into each other", "[core][math]") {
  CHECK(ToDegrees(CRadians::PI).GetValue() == 180.0);
  CHECK(ToRadians(CDegrees(180.0)) == CRadians::PI);
  CHECK(ToRadians(CDegrees(-90.0)) == -CRadians::PI_OVER_TWO);
  CRadians radians;
  radians.FromValueInDegrees(90.0);
  CHECK(radians == CRadians::PI_OVER_TWO);
  CHECK(radians.Negate().GetValue() == -kPi / 2.0);
  CDegrees degrees;
  degrees.FromValueInRadians(kPi);
  CHECK(degrees.GetValue() == 180.0);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<CDegrees, CRadians>);
  STATIC_REQUIRE_FALSE(std::is_convertible_v<CRadians, CDegrees>);
}

TEST_CASE("angles: normalisation equals repeated steps within a few turns", "[core][math]") {
  const Real value = GENERATE(range(-40.0, 40.0, 0.37));
  CAPTURE(value);
  CHECK(CRadians(value).SignedNormalize().GetValue() == WrapByRepetition(value, -kPi, kPi));
  CHECK(CRadians(value).UnsignedNormalize().GetValue() == WrapByRepetition(value, 0.0, 2.0 * kPi));
  const Real degrees = value * 30.0;
  CHECK(CDegrees(degrees).SignedNormalize().GetValue() == WrapByRepetition(degrees, -180.0, 180.0));
  CHECK(CDegrees(degrees).UnsignedNormalize().GetValue() == WrapByRepetition(degrees, 0.0, 360.0));
}

TEST_CASE("angles: normalisation keeps the bounds", "[core][math]") {
  CHECK(CRadians(kPi).SignedNormalize() == CRadians::PI);
  CHECK(CRadians(-kPi).SignedNormalize() == -CRadians::PI);
  CHECK(CRadians(2.0 * kPi).UnsignedNormalize() == CRadians::TWO_PI);
  CHECK(CRadians().UnsignedNormalize() == CRadians::ZERO);
  CHECK(CDegrees(-180.0).SignedNormalize() == CDegrees(-180.0));
  CHECK(CDegrees(360.0).UnsignedNormalize() == CDegrees(360.0));
}

TEST_CASE("angles: normalisation of large values takes constant time and keeps the direction",
          "[core][math]") {
  // whole turns of degrees are exact
  CHECK(CDegrees(360.0 * 1e12 + 30.0).SignedNormalize().GetValue() == 30.0);
  CHECK(CDegrees(-360.0 * 1e12 - 30.0).UnsignedNormalize().GetValue() == 330.0);

  const Real value = GENERATE(1e5, -1e5, 1e15, 1e300, -1e300, std::numeric_limits<Real>::max());
  CAPTURE(value);
  CHECK(CRadians::SIGNED_RANGE.WithinMinBoundIncludedMaxBoundIncluded(
      CRadians(value).SignedNormalize()));
  CHECK(CRadians::UNSIGNED_RANGE.WithinMinBoundIncludedMaxBoundIncluded(
      CRadians(value).UnsignedNormalize()));
  // the C library's exact remainder for a turn of 2 * kPi
  CHECK(CRadians(value).SignedNormalize().GetValue() == std::remainder(value, 2.0 * kPi));
}

TEST_CASE("angles: normalisation of infinity and NaN gives NaN", "[core][math]") {
  const Real value =
      GENERATE(std::numeric_limits<Real>::quiet_NaN(), std::numeric_limits<Real>::infinity(),
               -std::numeric_limits<Real>::infinity());
  CHECK(std::isnan(CRadians(value).SignedNormalize().GetValue()));
  CHECK(std::isnan(CDegrees(value).UnsignedNormalize().GetValue()));
}

TEST_CASE("angles: the normalised difference is in a half-open turn", "[core][math]") {
  CHECK(NormalizedDifference(CRadians::PI, CRadians::ZERO) == -CRadians::PI);
  CHECK(NormalizedDifference(CRadians::ZERO, CRadians::PI) == -CRadians::PI);
  CHECK(NormalizedDifference(CDegrees(170.0), CDegrees(-170.0)) == CDegrees(-20.0));
  CHECK(NormalizedDifference(CDegrees(-170.0), CDegrees(170.0)) == CDegrees(20.0));
  CHECK(NormalizedDifference(CDegrees(90.0), CDegrees(-90.0)) == CDegrees(-180.0));
  CHECK(NormalizedDifference(CDegrees(10.0), CDegrees(370.0)) == CDegrees(0.0));
}

TEST_CASE("angles: trigonometric functions and their inverses", "[core][math]") {
  // one rounding of a number below 2
  constexpr Real kRounding = 4e-16;
  CHECK_THAT(Sin(CRadians::PI_OVER_SIX), WithinAbs(0.5, kRounding));
  CHECK_THAT(Cos(CRadians::PI_OVER_THREE), WithinAbs(0.5, kRounding));
  CHECK_THAT(Tan(CRadians::PI_OVER_FOUR), WithinAbs(1.0, kRounding));
  CHECK(ASin(1.0) == CRadians::PI_OVER_TWO);
  CHECK(ACos(-1.0) == CRadians::PI);
  CHECK(ATan2(1.0, 0.0) == CRadians::PI_OVER_TWO);
  CHECK(ATan2(0.0, -1.0) == CRadians::PI);
  CHECK(ATan2(-1.0, 1.0) == -CRadians::PI_OVER_FOUR);

  Real sine = 0.0;
  Real cosine = 0.0;
  SinCos(CRadians(0.3), sine, cosine);
  CHECK_THAT(sine, WithinAbs(std::sin(0.3), kRounding));
  CHECK_THAT(cosine, WithinAbs(std::cos(0.3), kRounding));
  ComputeSinCos(0.3, &sine, &cosine);
  CHECK(sine == std::sin(0.3));
  CHECK(cosine == std::cos(0.3));

  CHECK(ARGOS_SIN(0.0) == 0.0);
  CHECK(ARGOS_COS(0.0) == 1.0);
  CHECK(ARGOS_TAN(0.0) == 0.0);
  CHECK(ARGOS_ASIN(0.0) == 0.0);
  CHECK(ARGOS_ACOS(1.0) == 0.0);
  CHECK(ARGOS_ATAN2(0.0, 1.0) == 0.0);
}

TEST_CASE("angles: text form", "[core][math]") {
  std::ostringstream out;
  out << CRadians::PI << " " << CDegrees(12.5);
  CHECK(out.str() == "CRadians(3.14159 -> 180 degrees) CDegrees(12.5)");

  std::istringstream in(" 1.5 -30");
  CRadians radians;
  CDegrees degrees;
  in >> radians >> degrees;
  CHECK(radians == CRadians(1.5));
  CHECK(degrees == CDegrees(-30.0));

  std::istringstream bad("east");
  CHECK_FALSE(bad >> radians);
  CHECK(radians == CRadians(1.5));
}

}  // namespace angles_test
