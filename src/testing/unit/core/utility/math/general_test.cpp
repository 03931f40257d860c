#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/general.h>

#include <catch2/catch.hpp>

#include <limits>
#include <type_traits>

namespace general_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using namespace argos;

TEST_CASE("general maths: magnitude and sign of numbers and angles", "[core][math]") {
  CHECK(Abs(-3) == 3);
  CHECK(Abs(3) == 3);
  CHECK(Abs(-2.5) == 2.5);
  CHECK(Abs(-2.5f) == 2.5f);
  CHECK(Abs(SInt64(-7)) == 7);
  CHECK(Abs(CRadians(-1.0)) == CRadians(1.0));
  CHECK(Abs(CDegrees(30.0)) == CDegrees(30.0));
  CHECK(Abs(CDegrees()) == CDegrees());

  CHECK(Sign(-0.1) == -1);
  CHECK(Sign(0) == 0);
  CHECK(Sign(12u) == 1);
  CHECK(Sign(CRadians(-1.0)) == -1);
}

TEST_CASE("general maths: Min and Max give references for variables and values otherwise",
          "[core][math]") {
  Real small = 1.0;
  Real large = 2.0;
  STATIC_REQUIRE(std::is_same_v<decltype(Min(small, large)), Real&>);
  STATIC_REQUIRE(std::is_same_v<decltype(Max(small, 2.0)), Real>);
  CHECK(&Min(small, large) == &small);
  CHECK(&Max(small, large) == &large);
  CHECK(&Min(large, small) == &small);
  CHECK(&Max(large, small) == &large);

  const Real constant = 1.5;
  CHECK(Max(constant, large) == 2.0);
  CHECK(Min(constant, 3.0) == 1.5);
  CHECK(Max(0.5, small) == 1.0);
  CHECK(Min<Real>(small, 7) == 1.0);
  CHECK(Max<Real>(3, large) == 3.0);
  CHECK(Square(-3) == 9);
  CHECK(Square(1.5) == 2.25);
}

TEST_CASE("general maths: rounding functions follow the documented rules", "[core][math]") {
  SECTION("Floor subtracts one from every negative number, whole ones included") {
    CHECK(Floor(2.0) == 2);
    CHECK(Floor(2.9) == 2);
    CHECK(Floor(0.0) == 0);
    CHECK(Floor(-0.5) == -1);
    CHECK(Floor(-1.5) == -2);
    CHECK(Floor(-2.0) == -3);
    // adding or subtracting one would round to the next whole number
    CHECK(Floor(-0.99999999999999989) == -1);
  }
  SECTION("Ceil is the mathematical ceiling") {
    CHECK(Ceil(2.0) == 2);
    CHECK(Ceil(2.1) == 3);
    CHECK(Ceil(-2.0) == -2);
    CHECK(Ceil(-2.9) == -2);
    CHECK(Ceil(-0.5) == 0);
    CHECK(Ceil(0.99999999999999989) == 1);
  }
  SECTION("Round takes halves away from zero") {
    CHECK(Round(2.4) == 2);
    CHECK(Round(2.5) == 3);
    CHECK(Round(-2.5) == -3);
    CHECK(Round(-2.4) == -2);
    // the largest number below one half: adding 0.5 and truncating would give 1
    CHECK(Round(0.49999999999999994) == 0);
  }
  SECTION("RoundClosestToZero truncates") {
    CHECK(RoundClosestToZero(2.9) == 2);
    CHECK(RoundClosestToZero(-2.9) == -2);
    CHECK(RoundClosestToZero(-2.0) == -2);
  }
  SECTION("values out of range are clamped") {
    CHECK(Floor(-1e300) == std::numeric_limits<SInt32>::min());
    CHECK(Ceil(1e300) == std::numeric_limits<SInt32>::max());
    CHECK(Round(1e10) == std::numeric_limits<SInt32>::max());
    CHECK(Floor(std::numeric_limits<Real>::quiet_NaN()) == 0);
  }
}

TEST_CASE("general maths: equality with a tolerance scales with the larger number",
          "[core][math]") {
  CHECK(DoubleEqAbsolute(0.0, 0.009, 0.01));
  CHECK_FALSE(DoubleEqAbsolute(0.0, 0.011, 0.01));
  // |a - b| = 1 against 0.01 * 101 and 0.01 * 99.5
  CHECK(DoubleEqAbsolute(100.0, 101.0, 0.01));
  CHECK_FALSE(DoubleEqAbsolute(98.5, 99.5, 0.01));
  CHECK(DoubleEqAbsolute(-100.0, -101.0, 0.01));
  CHECK(DoubleEq(1.0, 1.00009));
  CHECK_FALSE(DoubleEq(1.0, 1.0002));
}

TEST_CASE("general maths: interpolation is linear between points and extrapolates at both ends",
          "[core][math]") {
  const std::vector<std::pair<Real, Real> > points{{0.0, 1.0}, {2.0, 5.0}, {3.0, 4.0}};
  CHECK(Interpolate(0.0, points) == 1.0);
  CHECK(Interpolate(1.0, points) == 3.0);
  CHECK(Interpolate(2.0, points) == 5.0);
  CHECK(Interpolate(2.5, points) == 4.5);
  CHECK(Interpolate(3.0, points) == 4.0);
  CHECK(Interpolate(-1.0, points) == -1.0);
  CHECK(Interpolate(5.0, points) == 2.0);

  SECTION("at a step the right value holds") {
    const std::vector<std::pair<Real, Real> > step{
        {0.0, 0.0}, {1.0, 0.0}, {1.0, 10.0}, {2.0, 10.0}};
    CHECK(Interpolate(0.5, step) == 0.0);
    CHECK(Interpolate(1.0, step) == 10.0);
    CHECK(Interpolate(1.5, step) == 10.0);
  }
  SECTION("invalid points are refused") {
    CHECK_THROWS_WITH(Interpolate(0.0, {{1.0, 1.0}}), Contains("1 point"));
    CHECK_THROWS_WITH(Interpolate(0.0, {{1.0, 1.0}, {1.0, 2.0}}), Contains("sorted"));
    CHECK_THROWS_AS(Interpolate(0.0, {}), CARGoSException);
  }
}

TEST_CASE("general maths: elementary functions are those of the C library", "[core][math]") {
  CHECK(::Sqrt(2.25) == 1.5);
  CHECK(argos::Sqrt(4) == 2.0);
  CHECK(Log(1.0) == 0.0);
  CHECK(Exp(0.0) == 1.0);
  CHECK(Mod(-5.5, 2.0) == -1.5);
  // one rounding in each function, both close to 1
  CHECK_THAT(Log(Exp(1.0)), WithinAbs(1.0, 1e-15));
}

}  // namespace general_test
