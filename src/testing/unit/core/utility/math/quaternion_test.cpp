#include <argos3/core/utility/math/matrix/rotationmatrix3.h>
#include <argos3/core/utility/math/quaternion.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

namespace quaternion_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using namespace argos;

namespace {

// tolerance of a few roundings of numbers of about 1
constexpr Real kRounding = 2e-15;

// 0 if both are the same rotation: q and -q are equal rotations
Real RotationDistance(const CQuaternion& a, const CQuaternion& b) {
  return std::min((a - b).Length(), (a + b).Length());
}

CVector3 Rotated(const CVector3& vector, const CQuaternion& rotation) {
  return CVector3(vector).Rotate(rotation);
}

const CQuaternion& GetSample(int index) {
  static const CQuaternion kSamples[] = {
      CQuaternion(), CQuaternion(CRadians(0.4), CVector3(1, 2, -2) / 3.0),
      CQuaternion(CRadians(-2.5), CVector3(2, 3, 6) / 7.0), CQuaternion(0.5, -0.5, 0.5, 0.5),
      CQuaternion(0.0, 0.6, 0.0, -0.8)};
  return kSamples[index];
}

}  // namespace

TEST_CASE("quaternion: the default is the identity", "[core][math]") {
  constexpr CQuaternion kIdentity;
  STATIC_REQUIRE(kIdentity.GetW() == 1.0);
  CHECK(kIdentity == CQuaternion(1, 0, 0, 0));
  CHECK(Rotated(CVector3(1, 2, 3), kIdentity) == CVector3(1, 2, 3));
  CRadians angle(1.0);
  CVector3 axis;
  kIdentity.ToAngleAxis(angle, axis);
  CHECK(angle == CRadians::ZERO);
  CHECK(axis == CVector3::Z);
}

TEST_CASE("quaternion: components can be read and set", "[core][math]") {
  CQuaternion quaternion;
  quaternion.SetW(1);
  quaternion.SetX(2);
  quaternion.SetY(3);
  quaternion.SetZ(4);
  CHECK(quaternion.GetW() == 1.0);
  CHECK(quaternion.GetX() == 2.0);
  CHECK(quaternion.GetY() == 3.0);
  CHECK(quaternion.GetZ() == 4.0);
  CQuaternion copy(quaternion);
  CHECK(copy == quaternion);
  copy.Set(2, 3, 4, 5);
  CHECK_FALSE(copy == quaternion);
  quaternion = copy;
  CHECK(quaternion == copy);
  CHECK_FALSE(copy == CQuaternion(-2, -3, -4, -5));

  CHECK(quaternion.SquareLength() == 54.0);
  CHECK_THAT(quaternion.Length(), WithinAbs(std::sqrt(54.0), kRounding));
  CHECK_THAT(quaternion.Normalize().Length(), WithinAbs(1.0, kRounding));
  CHECK(CQuaternion(1, 2, 3, 4).Conjugate() == CQuaternion(1, -2, -3, -4));
  CHECK(CQuaternion(1, 2, 3, 4).Inverse() == CQuaternion(1, -2, -3, -4));
}

TEST_CASE("quaternion: sums are componentwise, products follow Hamilton's rules", "[core][math]") {
  const CQuaternion i(0, 1, 0, 0);
  const CQuaternion j(0, 0, 1, 0);
  const CQuaternion k(0, 0, 0, 1);
  const CQuaternion minusOne(-1, 0, 0, 0);
  CHECK(i * j == k);
  CHECK(j * k == i);
  CHECK(k * i == j);
  CHECK(j * i == CQuaternion(0, 0, 0, -1));
  CHECK(i * i == minusOne);
  CHECK(j * j == minusOne);
  CHECK(k * k == minusOne);
  CHECK(i * j * k == minusOne);

  CQuaternion quaternion(1, 2, 3, 4);
  CHECK(quaternion + i == CQuaternion(1, 3, 3, 4));
  CHECK(quaternion - k == CQuaternion(1, 2, 3, 3));
  CHECK((quaternion += j) == CQuaternion(1, 2, 4, 4));
  CHECK((quaternion -= j) == CQuaternion(1, 2, 3, 4));
  CHECK((quaternion *= i) == CQuaternion(-2, 1, 4, -3));
}

TEST_CASE("quaternion: rotation is q v q*, and a product applies its right factor first",
          "[core][math]") {
  const CQuaternion a = GetSample(GENERATE(range(0, 5)));
  const CQuaternion b = GetSample(GENERATE(range(0, 5)));
  const CVector3 vector(0.3, -1.2, 0.7);
  const CQuaternion sandwich =
      a * CQuaternion(0, vector.GetX(), vector.GetY(), vector.GetZ()) * a.Conjugate();
  const CVector3 expected(sandwich.GetX(), sandwich.GetY(), sandwich.GetZ());
  CHECK_THAT(Distance(Rotated(vector, a), expected), WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(Rotated(vector, a * b), Rotated(Rotated(vector, b), a)),
             WithinAbs(0.0, kRounding));
  CHECK_THAT(Distance(Rotated(Rotated(vector, a), a.Inverse()), vector), WithinAbs(0.0, kRounding));
  CHECK_THAT(RotationDistance(a * a.Inverse(), CQuaternion()), WithinAbs(0.0, kRounding));
}

TEST_CASE("quaternion: converts to and from angle and axis", "[core][math]") {
  CHECK_THAT(
      Distance(Rotated(CVector3::X, CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z)), CVector3::Y),
      WithinAbs(0.0, kRounding));
  const Real angle = GENERATE(1e-9, 0.5, 3.0, 3.2, 6.0);
  const CVector3 axis = CVector3(2, -3, 6) / 7.0;
  CQuaternion quaternion;
  quaternion.FromAngleAxis(CRadians(angle), axis);
  CHECK(quaternion == CQuaternion(CRadians(angle), axis));
  CRadians angleAgain;
  CVector3 axisAgain;
  quaternion.ToAngleAxis(angleAgain, axisAgain);
  CHECK_THAT(angleAgain.GetValue(), WithinAbs(angle, kRounding));
  CHECK_THAT(Distance(axisAgain, axis), WithinAbs(0.0, kRounding));
}

TEST_CASE("quaternion: Euler angles z, y, x mean Rx Ry Rz", "[core][math]") {
  const CRadians z(GENERATE(-3.0, -0.4, 0.0, 2.2));
  const CRadians y(GENERATE(-1.5, -0.3, 0.0, 1.2));
  const CRadians x(GENERATE(-2.9, 0.0, 0.6));
  CAPTURE(z.GetValue(), y.GetValue(), x.GetValue());
  CQuaternion quaternion;
  quaternion.FromEulerAngles(z, y, x);
  const CQuaternion product =
      CQuaternion(x, CVector3::X) * CQuaternion(y, CVector3::Y) * CQuaternion(z, CVector3::Z);
  CHECK_THAT(RotationDistance(quaternion, product), WithinAbs(0.0, kRounding));
  // on fixed axes: z first, then y, then x
  const CVector3 vector(0.2, 0.5, -0.9);
  CHECK_THAT(
      Distance(Rotated(vector, quaternion), CVector3(vector).RotateZ(z).RotateY(y).RotateX(x)),
      WithinAbs(0.0, kRounding));

  CRadians zAgain;
  CRadians yAgain;
  CRadians xAgain;
  quaternion.ToEulerAngles(zAgain, yAgain, xAgain);
  // near y = PI/2 the arc sine loses digits: 1e-16 / cos(1.5)
  CHECK_THAT(zAgain.GetValue(), WithinAbs(z.GetValue(), 2e-14));
  CHECK_THAT(yAgain.GetValue(), WithinAbs(y.GetValue(), 2e-14));
  CHECK_THAT(xAgain.GetValue(), WithinAbs(x.GetValue(), 2e-14));
}

TEST_CASE("quaternion: Euler angles of half turns are positive", "[core][math]") {
  CRadians z;
  CRadians y;
  CRadians x;
  CQuaternion(0, 0, 0, 1).ToEulerAngles(z, y, x);
  CHECK(z == CRadians::PI);
  CQuaternion(0, 0, 0, -1).ToEulerAngles(z, y, x);
  CHECK(z == CRadians::PI);
  CQuaternion(0, -1, 0, 0).ToEulerAngles(z, y, x);
  CHECK(x == CRadians::PI);
}

TEST_CASE("quaternion: in gimbal lock x is 0 and z holds the whole rotation", "[core][math]") {
  const Real sign = GENERATE(1.0, -1.0);
  CQuaternion quaternion;
  quaternion.FromEulerAngles(CRadians(0.5), sign * CRadians::PI_OVER_TWO, CRadians(0.2));
  CRadians z;
  CRadians y;
  CRadians x;
  quaternion.ToEulerAngles(z, y, x);
  CHECK(x == CRadians::ZERO);
  CHECK(y == sign * CRadians::PI_OVER_TWO);
  // R = Rx(x) Ry(+-90) Rz(z) depends on z +- x only
  CHECK_THAT(z.GetValue(), WithinAbs(0.5 + sign * 0.2, kRounding));
  CQuaternion again;
  again.FromEulerAngles(z, y, x);
  CHECK_THAT(RotationDistance(again, quaternion), WithinAbs(0.0, kRounding));
}

TEST_CASE("quaternion: gimbal lock begins at 0.49999", "[core][math]") {
  CRadians z;
  CRadians y;
  CRadians x;
  CQuaternion quaternion;
  quaternion.FromEulerAngles(CRadians::ZERO, ASin(2.0 * 0.499985), CRadians(0.3));
  quaternion.ToEulerAngles(z, y, x);
  // dividing by a cosine of 0.0077 magnifies a rounding of 1e-16
  CHECK_THAT(x.GetValue(), WithinAbs(0.3, 1e-12));
  quaternion.FromEulerAngles(CRadians::ZERO, ASin(2.0 * 0.499995), CRadians(0.3));
  quaternion.ToEulerAngles(z, y, x);
  CHECK(x == CRadians::ZERO);
  CHECK(y == CRadians::PI_OVER_TWO);
}

TEST_CASE("quaternion: the rotation between two vectors is the shortest", "[core][math]") {
  const CVector3 from(0.3, -2.0, 0.5);
  const CVector3 to =
      GENERATE(CVector3(1, 1, 1), CVector3(0.3, -2.0, 0.5), CVector3(0, 0, -3), CVector3(-1, 0, 0));
  const CQuaternion rotation(from, to);
  CQuaternion same;
  same.BetweenTwoVectors(from, to);
  CHECK(rotation == same);
  CHECK_THAT(rotation.Length(), WithinAbs(1.0, kRounding));
  CHECK_THAT(Distance(Rotated(CVector3(from).Normalize(), rotation), CVector3(to).Normalize()),
             WithinAbs(0.0, kRounding));
  CRadians angle;
  CVector3 axis;
  rotation.ToAngleAxis(angle, axis);
  // half the angle comes from a square root of 1 - cos: half of the digits when it is close to 0
  CHECK_THAT(angle.GetValue(), WithinAbs(CVector3(from).GetAngleWith(to).GetValue(), 3e-8));
}

TEST_CASE("quaternion: the angle of both identities is 0", "[core][math]") {
  for (const Real w : {1.0, -1.0}) {
    CRadians angle(1.0);
    CVector3 axis;
    CQuaternion(w, 0.0, 0.0, 0.0).ToAngleAxis(angle, axis);
    CHECK(angle == CRadians::ZERO);
    CHECK(axis == CVector3::Z);
  }
}

TEST_CASE("quaternion: half a turn is about the axis that is normal to x", "[core][math]") {
  const CQuaternion turn(CVector3::Z, -CVector3::Z);
  CHECK_THAT(turn.GetY(), WithinAbs(1.0, 1e-15));
  CHECK_THAT(CQuaternion(CVector3::X, -CVector3::X).GetZ(), WithinAbs(1.0, 1e-15));
}

TEST_CASE("quaternion: opposite and zero vectors have a rotation between them", "[core][math]") {
  const CVector3 from = GENERATE(CVector3(1, 0, 0), CVector3(0, 0, 2), CVector3(1, -2, 3));
  const CQuaternion rotation(from, -2.0 * from);
  CHECK_THAT(rotation.Length(), WithinAbs(1.0, kRounding));
  // the axis of half a turn comes from an iterative decomposition: a few more roundings
  CHECK_THAT(Distance(Rotated(from, rotation), -from), WithinAbs(0.0, 1e-14));
  CHECK(CQuaternion(CVector3::ZERO, from) == CQuaternion());
  CHECK(CQuaternion(from, CVector3::ZERO) == CQuaternion());
}

TEST_CASE("quaternion: conversion to a rotation matrix and back", "[core][math]") {
  const CQuaternion quaternion = GetSample(GENERATE(range(0, 5)));
  const CRotationMatrix3 matrix = quaternion;
  const CVector3 vector(0.3, -1.2, 0.7);
  CHECK_THAT(Distance(matrix * vector, Rotated(vector, quaternion)), WithinAbs(0.0, kRounding));
  CHECK_THAT(matrix.GetDeterminant(), WithinAbs(1.0, kRounding));
  const CQuaternion again = matrix;
  CHECK_THAT(RotationDistance(again, quaternion), WithinAbs(0.0, kRounding));
}

TEST_CASE("quaternion: text form is z,y,x in degrees", "[core][math]") {
  std::ostringstream out;
  out << CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z);
  CHECK(out.str() == "90,0,0");

  std::istringstream in(" 90, 0,45 ");
  CQuaternion quaternion;
  in >> quaternion;
  CHECK_FALSE(in.fail());
  CQuaternion expected;
  expected.FromEulerAngles(CRadians::PI_OVER_TWO, CRadians::ZERO, CRadians::PI_OVER_FOUR);
  CHECK_THAT(RotationDistance(quaternion, expected), WithinAbs(0.0, kRounding));

  const std::string text = GENERATE("90", "90,0", "90,0,0,0", "north,0,0");
  CAPTURE(text);
  std::istringstream bad(text);
  CHECK_THROWS_WITH(bad >> quaternion, Contains("\"" + text + "\"") && Contains("orientation"));
}

TEST_CASE("quaternion: a stream that has failed leaves it as it is", "[core][math]") {
  std::istringstream in("90,0,0");
  in.setstate(std::ios::failbit);
  CQuaternion quaternion(0.5, 0.5, 0.5, 0.5);
  in >> quaternion;
  CHECK(quaternion == CQuaternion(0.5, 0.5, 0.5, 0.5));
  CHECK(in.fail());
}

}  // namespace quaternion_test
