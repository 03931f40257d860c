#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector3.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <sstream>

namespace range_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

template <typename T>
T Wrap(const CRange<T>& range, T value) {
  range.WrapValue(value);
  return value;
}

template <typename T>
T Truncate(const CRange<T>& range, T value) {
  range.TruncValue(value);
  return value;
}

template <typename T>
CRange<T> Parse(const std::string& text) {
  std::istringstream in(text);
  CRange<T> range;
  in >> range;
  REQUIRE_FALSE(in.fail());
  return range;
}

}  // namespace

TEST_CASE("range: bounds and span", "[core][math]") {
  CRange<Real> range(-1.0, 3.0);
  CHECK(range.GetMin() == -1.0);
  CHECK(range.GetMax() == 3.0);
  CHECK(range.GetSpan() == 4.0);
  range.SetMin(5.0);
  range.SetMax(7.0);
  CHECK(range.GetSpan() == 2.0);
  range.Set(0.0, 1.0);
  CHECK(range.GetMax() == 1.0);

  const CRange<UInt32> empty;
  CHECK(empty.GetMin() == 0u);
  CHECK(empty.GetMax() == 0u);
  CHECK(CRange<UInt8>(10, 255).GetSpan() == 245);
  CHECK(CRange<CVector3>(CVector3::ZERO, CVector3(1, 2, 3)).GetSpan() == CVector3(1, 2, 3));
}

TEST_CASE("range: an inverted range is refused in builds with assertions", "[core][math]") {
#ifndef NDEBUG
  CHECK_THROWS_WITH(CRange<Real>(2.0, 1.0), Contains("2") && Contains("1") && Contains("nverted"));
  CRange<SInt32> range;
  CHECK_THROWS_AS(range.Set(1, -1), CARGoSException);
  // vectors that are not ordered
  CHECK_THROWS_AS(CRange<CVector3>(CVector3(0, 1, 0), CVector3(1, 0, 1)), CARGoSException);
#else
  CHECK(CRange<Real>(2.0, 1.0).GetMin() == 2.0);
#endif
}

TEST_CASE("range: membership with and without the bounds", "[core][math]") {
  const CRange<SInt32> range(1, 3);
  CHECK(range.WithinMinBoundIncludedMaxBoundIncluded(1));
  CHECK(range.WithinMinBoundIncludedMaxBoundIncluded(3));
  CHECK_FALSE(range.WithinMinBoundIncludedMaxBoundIncluded(4));
  CHECK_FALSE(range.WithinMinBoundIncludedMaxBoundIncluded(0));
  CHECK(range.WithinMinBoundIncludedMaxBoundExcluded(1));
  CHECK_FALSE(range.WithinMinBoundIncludedMaxBoundExcluded(3));
  CHECK_FALSE(range.WithinMinBoundExcludedMaxBoundIncluded(1));
  CHECK(range.WithinMinBoundExcludedMaxBoundIncluded(3));
  CHECK(range.WithinMinBoundExcludedMaxBoundExcluded(2));
  CHECK_FALSE(range.WithinMinBoundExcludedMaxBoundExcluded(1));
  CHECK_FALSE(range.WithinMinBoundExcludedMaxBoundExcluded(3));

  const CRange<CVector3> box(CVector3(0, 0, 0), CVector3(1, 1, 1));
  CHECK(box.WithinMinBoundIncludedMaxBoundIncluded(CVector3(0, 0.5, 1)));
  CHECK_FALSE(box.WithinMinBoundIncludedMaxBoundIncluded(CVector3(0.5, 0.5, 1.1)));
}

TEST_CASE("range: truncation clamps", "[core][math]") {
  CHECK(Truncate(CRange<Real>(-1.0, 1.0), 2.0) == 1.0);
  CHECK(Truncate(CRange<Real>(-1.0, 1.0), -2.0) == -1.0);
  CHECK(Truncate(CRange<Real>(-1.0, 1.0), 0.5) == 0.5);
  CHECK(Truncate(CRange<UInt32>(5, 9), 4u) == 5u);
  CHECK(Truncate(CRange<CDegrees>(CDegrees(0), CDegrees(90)), CDegrees(100)) == CDegrees(90));
}

TEST_CASE("range: normalisation gives the relative position in the range", "[core][math]") {
  CHECK(CRange<Real>(2.0, 4.0).NormalizeValue(2.5) == 0.25);
  CHECK(CRange<Real>(2.0, 4.0).NormalizeValue(9.0) == 1.0);
  CHECK(CRange<Real>(2.0, 4.0).NormalizeValue(-9.0) == 0.0);
  CHECK(CRange<SInt32>(0, 4).NormalizeValue(1) == 0.25);
  CHECK(CRange<CRadians>(CRadians(1), CRadians(3)).NormalizeValue(CRadians(2)) == 0.5);
  CHECK(CRange<Real>(1.0, 1.0).NormalizeValue(1.0) == 0.0);
  const SInt32 lowest = std::numeric_limits<SInt32>::min();
  const SInt32 highest = std::numeric_limits<SInt32>::max();
  // the middle of the whole range, half a unit from 0: 2^-33 of the span
  CHECK_THAT(CRange<SInt32>(lowest, highest).NormalizeValue(0), WithinAbs(0.5, 2e-10));
}

TEST_CASE("range: mapping keeps the relative position and converts to the other type",
          "[core][math]") {
  const CRange<Real> unit(0.0, 1.0);
  Real real = 0.0;
  unit.MapValueIntoRange(real, 0.25, CRange<Real>(-2.0, 2.0));
  CHECK(real == -1.0);
  UInt32 number = 0;
  unit.MapValueIntoRange(number, 0.999, CRange<UInt32>(10, 20));
  CHECK(number == 19u);
  UInt8 byte = 0;
  unit.MapValueIntoRange(byte, 2.0, CRange<UInt8>(0, 255));
  CHECK(static_cast<int>(byte) == 255);
  CRadians angle;
  unit.MapValueIntoRange(angle, 0.75, CRadians::SIGNED_RANGE);
  CHECK(angle == CRadians::PI_OVER_TWO);
  CVector3 point;
  unit.MapValueIntoRange(point, 0.5, CRange<CVector3>(CVector3(0, 0, 0), CVector3(2, 4, 6)));
  CHECK(point == CVector3(1, 2, 3));
  CRange<CRadians>(CRadians(0), CRadians(2)).MapValueIntoRange(real, CRadians(1), unit);
  CHECK(real == 0.5);
}

TEST_CASE("range: wrapping shifts by whole spans until inside", "[core][math]") {
  const CRange<Real> range(-1.0, 3.0);
  CHECK(Wrap(range, 0.5) == 0.5);
  CHECK(Wrap(range, 3.0) == 3.0);
  CHECK(Wrap(range, -1.0) == -1.0);
  CHECK(Wrap(range, 4.0) == 0.0);
  CHECK(Wrap(range, -9.5) == 2.5);
  CHECK(Wrap(range, 4e9 + 0.5) == 0.5);
  CHECK(range.WithinMinBoundIncludedMaxBoundIncluded(Wrap(range, 1e300)));
  CHECK(std::isnan(Wrap(range, std::numeric_limits<Real>::infinity())));
  CHECK(Wrap(CRange<Real>(2.0, 2.0), 5.0) == 2.0);
  CHECK(Wrap(CRadians::UNSIGNED_RANGE, -CRadians::PI_OVER_TWO) == CRadians(1.5 * ARGOS_PI));
}

TEST_CASE("range: wrapping integers equals repeated steps", "[core][math]") {
  const CRange<SInt32> interval(-2, 3);
  const SInt32 value = GENERATE(range(-30, 30));
  CAPTURE(value);
  SInt32 expected = value;
  while (expected > 3) {
    expected -= 5;
  }
  while (expected < -2) {
    expected += 5;
  }
  CHECK(Wrap(interval, value) == expected);
  const UInt8 small = static_cast<UInt8>(value + 100);
  UInt8 expectedSmall = small;
  while (expectedSmall > 12) {
    expectedSmall = static_cast<UInt8>(expectedSmall - 7);
  }
  CHECK(static_cast<int>(Wrap(CRange<UInt8>(5, 12), small)) == static_cast<int>(expectedSmall));
}

TEST_CASE("range: wrapping integers is exact at the limits of the type", "[core][math]") {
  const SInt32 lowest = std::numeric_limits<SInt32>::min();
  const SInt32 highest = std::numeric_limits<SInt32>::max();
  // 2^31 - 1 = 10 k + 7; the steps down end in (0,10]
  CHECK(Wrap(CRange<SInt32>(0, 10), highest) == 7);
  // -2^31 = -10 k - 8; the steps up end in [0,10)
  CHECK(Wrap(CRange<SInt32>(0, 10), lowest) == 2);
  CHECK(Wrap(CRange<SInt32>(lowest, highest), -1) == -1);
  CHECK(Wrap(CRange<UInt32>(3, 3), 77u) == 3u);
  CHECK(Wrap(CRange<UInt32>(10, 20), 5u) == 15u);
}

TEST_CASE("range: a vector is wrapped while all its components are out of range", "[core][math]") {
  const CRange<CVector3> box(CVector3(0, 0, 0), CVector3(1, 2, 4));
  CHECK(Wrap(box, CVector3(1.5, 3.0, 5.0)) == CVector3(0.5, 1.0, 1.0));
  CHECK(Wrap(box, CVector3(-0.5, -0.5, -0.5)) == CVector3(0.5, 1.5, 3.5));
  CHECK(Wrap(box, CVector3(1.5, 1.0, 1.0)) == CVector3(1.5, 1.0, 1.0));
  CHECK(Wrap(CRange<CVector3>(), CVector3(1, 1, 1)) == CVector3(1, 1, 1));
}

TEST_CASE("range: text form is min:max", "[core][math]") {
  std::ostringstream out;
  out << CRange<Real>(-1.5, 2.0) << " " << CRange<UInt8>(1, 255);
  CHECK(out.str() == "-1.5:2 1:255");

  CHECK(Parse<Real>("-1.5:2e1").GetMax() == 20.0);
  CHECK(Parse<Real>(" 0.5 :\t1.5 ").GetMin() == 0.5);
  CHECK(Parse<SInt32>("-3:-3").GetMin() == -3);
  CHECK(Parse<UInt8>("1:255").GetMax() == 255);
  CHECK(Parse<CDegrees>("-30:45").GetMin() == CDegrees(-30.0));
  CHECK(Parse<CVector3>("-1, -2,-3 : 4,5, 6").GetMax() == CVector3(4, 5, 6));

  std::istringstream several("0:1 2:3\n4:5");
  CRange<UInt32> range;
  several >> range >> range >> range;
  CHECK(range.GetMin() == 4u);
  CHECK(range.GetMax() == 5u);
}

TEST_CASE("range: malformed text is refused with a reason", "[core][math]") {
  CRange<Real> range(7.0, 8.0);
  const std::string text =
      GENERATE("", "1", "1,2", ":", "1:", ":2", "a:2", "1:b", "1 1:2", "1:2:3", "1:2x", "1x:2");
  CAPTURE(text);
  std::istringstream in(text);
  CHECK_THROWS_WITH(in >> range, Contains("\"" + text + "\"") && Contains("min:max"));
  CHECK(range.GetMin() == 7.0);
}

TEST_CASE("range: inverted text is refused with both values, in every build", "[core][math]") {
  CRange<Real> range;
  std::istringstream in("2.5:1.25");
  CHECK_THROWS_WITH(in >> range, Contains("2.5") && Contains("1.25"));
}

TEST_CASE("range: bounds of integers must be integers of the type", "[core][math]") {
  CRange<UInt32> range;
  const std::string text = GENERATE("0.5:2", "0:2.5", "-1:2", "0:4294967296");
  CAPTURE(text);
  std::istringstream in(text);
  CHECK_THROWS_AS(in >> range, CARGoSException);
  std::istringstream byteIn("0:256");
  CRange<UInt8> bytes;
  CHECK_THROWS_AS(byteIn >> bytes, CARGoSException);
}

TEST_CASE("range: a stream that has failed leaves it as it is", "[core][math]") {
  std::istringstream in("1:2");
  in.setstate(std::ios::failbit);
  CRange<Real> range(7.0, 8.0);
  in >> range;
  CHECK(range.GetMin() == 7.0);
  CHECK(range.GetMax() == 8.0);
}

}  // namespace range_test
