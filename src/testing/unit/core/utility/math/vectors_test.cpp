#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/core/utility/math/matrix/matrix.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>

namespace vectors_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

// tolerance of a few roundings of numbers of about 1
constexpr Real kRounding = 1e-15;

// the constants are initialised at compile time, for static initialisers of users
static_assert(CVector2::X == CVector2(1.0, 0.0));
static_assert(CVector2::Y == CVector2(0.0, 1.0));
static_assert(CVector2::ZERO == CVector2());
static_assert(CVector3::X == CVector3(1.0, 0.0, 0.0));
static_assert(CVector3::Y == CVector3(0.0, 1.0, 0.0));
static_assert(CVector3::Z == CVector3(0.0, 0.0, 1.0));
static_assert(CVector3::ZERO == CVector3());

static_assert(std::is_trivially_copyable_v<CVector2> && sizeof(CVector2) == 2 * sizeof(Real));
static_assert(std::is_trivially_copyable_v<CVector3> && sizeof(CVector3) == 3 * sizeof(Real));
static_assert(std::is_trivially_copyable_v<CQuaternion> && sizeof(CQuaternion) == 4 * sizeof(Real));

template <typename T>
T Parse(const std::string& text) {
  std::istringstream in(text);
  T value;
  in >> value;
  REQUIRE_FALSE(in.fail());
  return value;
}

template <typename T>
std::string Print(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

}  // namespace

TEST_CASE("2D vector: coordinates can be read and set", "[core][math]") {
  CVector2 vector;
  CHECK(vector == CVector2::ZERO);
  vector.SetX(1.0);
  vector.SetY(2.0);
  CHECK(vector.GetX() == 1.0);
  CHECK(vector.GetY() == 2.0);
  vector.Set(3.0, 4.0);
  CHECK(vector == CVector2(std::array<Real, 2>{3.0, 4.0}));
  vector.Set(std::array<Real, 2>{5.0, 6.0});
  CHECK(vector != CVector2(3.0, 4.0));
}

TEST_CASE("2D vector: polar coordinates can be read and set", "[core][math]") {
  const CVector2 up(2.0, CRadians::PI_OVER_TWO);
  CHECK_THAT(Distance(up, CVector2(0.0, 2.0)), WithinAbs(0.0, kRounding));
  CVector2 other;
  other.FromPolarCoordinates(2.0, CRadians::PI_OVER_TWO);
  CHECK(other == up);

  const Real angle = GENERATE(range(-3.1, 3.1, 0.3));
  const CVector2 vector(1.5, CRadians(angle));
  CHECK_THAT(vector.Length(), WithinAbs(1.5, kRounding));
  CHECK_THAT(vector.Angle().GetValue(), WithinAbs(angle, kRounding));
}

TEST_CASE("2D vector: the direction of a zero vector is 0 for all signs of its zeros",
          "[core][math]") {
  CHECK(CVector2(0.0, 0.0).Angle() == CRadians::ZERO);
  CHECK(CVector2(-0.0, -0.0).Angle() == CRadians::ZERO);
  CHECK(CVector2(-1.0, 0.0).Angle() == CRadians::PI);
}

TEST_CASE("2D vector: lengths and distances", "[core][math]") {
  CVector2 vector(3.0, -4.0);
  CHECK(vector.SquareLength() == 25.0);
  CHECK(vector.Length() == 5.0);
  CHECK(SquareDistance(vector, CVector2(3.0, 1.0)) == 25.0);
  CHECK(Distance(vector, CVector2(3.0, 1.0)) == 5.0);
  CHECK(vector.Normalize() == CVector2(0.6, -0.8));
  CHECK(std::isnan(CVector2().Normalize().GetX()));
}

TEST_CASE("2D vector: arithmetic", "[core][math]") {
  CVector2 vector(1.0, 2.0);
  CHECK(vector + CVector2(3, 4) == CVector2(4, 6));
  CHECK(vector - CVector2(3, 4) == CVector2(-2, -2));
  CHECK(vector * 2.0 == CVector2(2, 4));
  CHECK(2.0 * vector == CVector2(2, 4));
  CHECK(vector / 2.0 == CVector2(0.5, 1));
  CHECK(-vector == CVector2(-1, -2));
  CHECK((vector += CVector2(1, 1)) == CVector2(2, 3));
  CHECK((vector -= CVector2(1, 0)) == CVector2(1, 3));
  CHECK((vector *= 4.0) == CVector2(4, 12));
  CHECK((vector /= 2.0) == CVector2(2, 6));
  CHECK(vector.Scale(2.0, -0.5) == CVector2(4, -3));
  CHECK(vector.Absolute() == CVector2(4, 3));
  CHECK(vector.Perpendicularize() == CVector2(-3, 4));
  CHECK(vector.DotProduct(CVector2(4, 3)) == 0.0);
  CHECK(CVector2::X.CrossProduct(CVector2::Y) == 1.0);
  CHECK(CVector2::Y.CrossProduct(CVector2::X) == -1.0);
}

TEST_CASE("2D vector: rotation is counter-clockwise and keeps lengths", "[core][math]") {
  CHECK_THAT(Distance(CVector2(1, 0).Rotate(CRadians::PI_OVER_TWO), CVector2::Y),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(CVector2(0, 1).Rotate(CRadians::PI_OVER_TWO), -CVector2::X),
             WithinAbs(0.0, kRounding));
  const Real angle = GENERATE(-2.0, 0.1, 1.0, 3.0);
  CVector2 vector(0.3, -0.7);
  vector.Rotate(CRadians(angle));
  CHECK_THAT(vector.Length(), WithinAbs(CVector2(0.3, -0.7).Length(), kRounding));
  vector.Rotate(CRadians(-angle));
  CHECK_THAT(Distance(vector, CVector2(0.3, -0.7)), WithinAbs(0.0, kRounding));
}

TEST_CASE("3D vector: coordinates can be read and set", "[core][math]") {
  CVector3 vector(1.0, 2.0, 3.0);
  vector.SetX(4.0);
  vector.SetY(5.0);
  vector.SetZ(6.0);
  CHECK(vector == CVector3(std::array<Real, 3>{4.0, 5.0, 6.0}));
  CHECK(vector.GetX() == 4.0);
  CHECK(vector.GetY() == 5.0);
  CHECK(vector.GetZ() == 6.0);
  vector.Set(1.0, 2.0, 3.0);
  vector[1] = 7.0;
  const CVector3& constant = vector;
  CHECK(constant[0] == 1.0);
  CHECK(constant[1] == 7.0);
  CHECK(constant[2] == 3.0);
  CHECK_THROWS_WITH(constant[3], Contains("3"));
  CHECK_THROWS_AS(vector[4] = 1.0, CARGoSException);
  vector.Set(std::array<Real, 3>{0.0, 0.0, 1.0});
  CHECK(vector == CVector3::Z);

  CVector2 projection;
  CHECK(CVector3(1, 2, 3).ProjectOntoXY(projection) == CVector2(1, 2));
  CHECK(CVector3(1, 2, 3).ProjectOntoYZ(projection) == CVector2(2, 3));
  CHECK(CVector3(1, 2, 3).ProjectOntoXZ(projection) == CVector2(1, 3));
  CHECK(&CVector3(1, 2, 3).ProjectOntoXZ(projection) == &projection);
}

TEST_CASE("3D vector: spherical coordinates can be read and set", "[core][math]") {
  CHECK_THAT(Distance(CVector3(2.0, CRadians::ZERO, CRadians(1.0)), CVector3(0, 0, 2)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(
      Distance(CVector3(2.0, CRadians::PI_OVER_TWO, CRadians::PI_OVER_TWO), CVector3(0, 2, 0)),
      WithinAbs(0.0, kRounding));

  const Real inclination = GENERATE(0.001, 0.5, 2.0, 3.14);
  const Real azimuth = GENERATE(-3.0, -0.5, 0.0, 2.5);
  CAPTURE(inclination, azimuth);
  CVector3 vector;
  vector.FromSphericalCoords(1.5, CRadians(inclination), CRadians(azimuth));
  Real radius = 0.0;
  CRadians inclinationAgain;
  CRadians azimuthAgain;
  vector.ToSphericalCoords(radius, inclinationAgain, azimuthAgain);
  CHECK_THAT(radius, WithinAbs(1.5, kRounding));
  CHECK_THAT(inclinationAgain.GetValue(), WithinAbs(inclination, kRounding));
  CHECK_THAT(azimuthAgain.GetValue(), WithinAbs(azimuth, kRounding));

  CVector3().ToSphericalCoords(radius, inclinationAgain, azimuthAgain);
  CHECK(radius == 0.0);
  CHECK(inclinationAgain == CRadians::ZERO);
  CHECK(azimuthAgain == CRadians::ZERO);
}

TEST_CASE("3D vector: lengths, distances and arithmetic", "[core][math]") {
  CVector3 vector(2.0, 3.0, 6.0);
  CHECK(vector.SquareLength() == 49.0);
  CHECK(vector.Length() == 7.0);
  CHECK(SquareDistance(vector, CVector3(2, 0, 2)) == 25.0);
  CHECK(Distance(vector, CVector3(2, 0, 2)) == 5.0);
  CHECK(CVector3(0, -3, 4).Normalize() == CVector3(0, -0.6, 0.8));
  CHECK(vector + CVector3(1, 1, 1) == CVector3(3, 4, 7));
  CHECK(vector - CVector3(1, 1, 1) == CVector3(1, 2, 5));
  CHECK(vector * 2.0 == CVector3(4, 6, 12));
  CHECK(2.0 * vector == CVector3(4, 6, 12));
  CHECK(vector / 2.0 == CVector3(1, 1.5, 3));
  CHECK(-vector == CVector3(-2, -3, -6));
  CHECK((vector += CVector3(1, 0, 0)) == CVector3(3, 3, 6));
  CHECK((vector -= CVector3(0, 0, 3)) == CVector3(3, 3, 3));
  CHECK((vector *= 2.0) == CVector3(6, 6, 6));
  CHECK((vector /= 3.0) == CVector3(2, 2, 2));
  CHECK(vector.Negate() == CVector3(-2, -2, -2));
  CHECK(vector.DotProduct(CVector3(1, 2, 3)) == -12.0);
  CHECK(vector != CVector3::ZERO);
}

TEST_CASE("3D vector: the cross product works in place and is right-handed", "[core][math]") {
  CVector3 vector = CVector3::X;
  CHECK(&vector.CrossProduct(CVector3::Y) == &vector);
  CHECK(vector == CVector3::Z);
  CHECK(CVector3(CVector3::Y).CrossProduct(CVector3::Z) == CVector3::X);
  CHECK(CVector3(CVector3::Z).CrossProduct(CVector3::X) == CVector3::Y);

  // Lagrange's identity: |a x b|^2 + (a.b)^2 = |a|^2 |b|^2, in integers
  const CVector3 a(1, -2, 3);
  const CVector3 b(4, 5, -6);
  const CVector3 cross = CVector3(a).CrossProduct(b);
  CHECK(cross.DotProduct(a) == 0.0);
  CHECK(cross.DotProduct(b) == 0.0);
  CHECK(cross.SquareLength() + Square(a.DotProduct(b)) == a.SquareLength() * b.SquareLength());
  CHECK(CVector3(b).CrossProduct(a) == -cross);
}

TEST_CASE("3D vector: it is less than another only if all its components are", "[core][math]") {
  const CVector3 low(0, 0, 0);
  const CVector3 high(1, 1, 1);
  const CVector3 mixed(1, 0, 2);
  CHECK(low < high);
  CHECK(high > low);
  CHECK_FALSE(low < mixed);
  CHECK(low <= mixed);
  CHECK(mixed >= low);
  CHECK_FALSE(mixed > low);
  CHECK_FALSE(mixed <= high);
  CHECK_FALSE(mixed >= high);
}

TEST_CASE("3D vector: rotations about the axes are right-handed", "[core][math]") {
  const CRadians quarter = CRadians::PI_OVER_TWO;
  CHECK_THAT(Distance(CVector3(0, 1, 0).RotateX(quarter), CVector3::Z), WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(CVector3(0, 0, 1).RotateY(quarter), CVector3::X), WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(CVector3(1, 0, 0).RotateZ(quarter), CVector3::Y), WithinAbs(0.0, kRounding));
  CHECK(CVector3(1, 2, 3).RotateZ(CVector2(0.0, 1.0)) == CVector3(-2, 1, 3));

  // the same rotations as quaternions
  const CRadians angle(0.7);
  const CVector3 vector(0.3, -0.5, 0.2);
  CHECK_THAT(Distance(CVector3(vector).RotateX(angle),
                      CVector3(vector).Rotate(CQuaternion(angle, CVector3::X))),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(CVector3(vector).RotateY(angle),
                      CVector3(vector).Rotate(CQuaternion(angle, CVector3::Y))),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(CVector3(vector).RotateZ(angle),
                      CVector3(vector).Rotate(CQuaternion(angle, CVector3::Z))),
             WithinAbs(0.0, kRounding));
}

TEST_CASE("3D vector: angles with another vector and about the axes", "[core][math]") {
  CVector3 x = CVector3::X;
  CHECK(x.GetAngleWith(CVector3(0, 5, 0)) == CRadians::PI_OVER_TWO);
  CHECK(x.GetAngleWith(CVector3(-2, 0, 0)) == CRadians::PI);
  CHECK(x.GetAngleWith(CVector3(3, 0, 0)) == CRadians::ZERO);
  CHECK(x.GetAngleWith(CVector3::ZERO) == CRadians::ZERO);
  // angles far below the resolution of the arc cosine
  CHECK_THAT(x.GetAngleWith(CVector3(1.0, 1e-12, 0)).GetValue(), WithinAbs(1e-12, 1e-27));

  const CVector3 vector(1, 2, 3);
  CHECK(vector.GetXAngle() == ATan2(3, 2));
  CHECK(vector.GetYAngle() == ATan2(1, 3));
  CHECK(vector.GetZAngle() == ATan2(2, 1));
}

TEST_CASE("vectors: conversion to matrices and to Eigen keeps the numbers", "[core][math]") {
  const CMatrix<1, 2> row2 = CVector2(1, 2);
  const CMatrix<2, 1> col2 = CVector2(1, 2);
  const CMatrix<1, 3> row3 = CVector3(1, 2, 3);
  const CMatrix<3, 1> col3 = CVector3(1, 2, 3);
  CHECK(row2(0, 1) == 2.0);
  CHECK(col2(1, 0) == 2.0);
  CHECK(row3(0, 2) == 3.0);
  CHECK(col3(2, 0) == 3.0);
  CHECK((row3 * col3)(0) == 14.0);

  CHECK(FromEigen(ToEigen(CVector2(1, 2))) == CVector2(1, 2));
  CHECK(FromEigen(ToEigen(CVector3(1, 2, 3))) == CVector3(1, 2, 3));
  CHECK(FromEigen(ToEigen(CQuaternion(0.5, -0.5, 0.5, 0.5))) == CQuaternion(0.5, -0.5, 0.5, 0.5));
}

TEST_CASE("vectors: text form", "[core][math]") {
  CHECK(Print(CVector2(1.5, -2)) == "1.5,-2");
  CHECK(Print(CVector3(1.0 / 3.0, 0, 1e6)) == "0.333333,0,1e+06");
  std::ostringstream precise;
  precise.precision(17);
  precise << CVector3(1.0 / 3.0, 0.1, 2.0);
  CHECK(Parse<CVector3>(precise.str()) == CVector3(1.0 / 3.0, 0.1, 2.0));

  CHECK(Parse<CVector2>("1,2") == CVector2(1, 2));
  CHECK(Parse<CVector2>(" -1.5 ,\t2e-1 ") == CVector2(-1.5, 0.2));
  CHECK(Parse<CVector3>("1, 2, 3") == CVector3(1, 2, 3));
  CHECK(Parse<CVector3>("\n+1,\n2,\n3\n") == CVector3(1, 2, 3));

  std::istringstream several("1,2,3 4,5,6\n7,8,9");
  CVector3 first;
  CVector3 second;
  CVector3 third;
  several >> first >> second >> third;
  CHECK(second == CVector3(4, 5, 6));
  CHECK(third == CVector3(7, 8, 9));
}

TEST_CASE("vectors: malformed text is refused with a quotation and a reason", "[core][math]") {
  SECTION("three numbers") {
    const std::string text =
        GENERATE("", "  ", "1", "1,2", "1,2,", "1,2,3,4", "1,2,3 ,4", "a,2,3", "1,b,3", "1,2,c",
                 "1,2,3d", "1;2;3", "1 2 3", "1,,3", "1,2 2,3", "1,2,1e999", "nan,0,0", "1,2,3:4");
    CAPTURE(text);
    std::istringstream in(text);
    CVector3 vector(7, 8, 9);
    CHECK_THROWS_WITH(in >> vector, Contains("\"" + text + "\"") && Contains("3 numbers"));
    CHECK(vector == CVector3(7, 8, 9));
  }
  SECTION("two numbers") {
    const std::string text = GENERATE("1", "1,2,3", "x,1", "1,y");
    CAPTURE(text);
    std::istringstream in(text);
    CVector2 vector(7, 8);
    CHECK_THROWS_WITH(in >> vector, Contains("\"" + text + "\"") && Contains("2 numbers"));
    CHECK(vector == CVector2(7, 8));
  }
  SECTION("errors name the field") {
    std::istringstream in("1,two,3");
    CVector3 vector;
    CHECK_THROWS_WITH(in >> vector, Contains("field 2"));
  }
  SECTION("a stream that has failed before is left unchanged") {
    std::istringstream in("1,2,3");
    in.setstate(std::ios_base::failbit);
    CVector3 vector(7, 8, 9);
    CHECK_NOTHROW(in >> vector);
    CHECK(vector == CVector3(7, 8, 9));
  }
}

TEST_CASE("vectors: a stream that has failed leaves them as they are", "[core][math]") {
  std::istringstream in("5,6,7");
  in.setstate(std::ios::failbit);
  CVector2 plane(1, 2);
  CVector3 space(1, 2, 3);
  in >> plane >> space;
  CHECK(plane == CVector2(1, 2));
  CHECK(space == CVector3(1, 2, 3));
  CHECK(in.fail());
}

}  // namespace vectors_test
