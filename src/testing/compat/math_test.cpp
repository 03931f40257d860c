// Code of users of the mathematics, in the order of the reference.

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/box.h>
#include <argos3/core/utility/math/convex_hull.h>
#include <argos3/core/utility/math/cylinder.h>
#include <argos3/core/utility/math/general.h>
#include <argos3/core/utility/math/matrix/matrix.h>
#include <argos3/core/utility/math/matrix/rotationmatrix2.h>
#include <argos3/core/utility/math/matrix/rotationmatrix3.h>
#include <argos3/core/utility/math/matrix/squarematrix.h>
#include <argos3/core/utility/math/matrix/transformationmatrix2.h>
#include <argos3/core/utility/math/matrix/transformationmatrix3.h>
#include <argos3/core/utility/math/plane.h>
#include <argos3/core/utility/math/pose2.h>
#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/ray2.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/rng.h>
#include <argos3/core/utility/math/transforms.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/math/vector3.h>

#include <catch2/catch.hpp>

#include <random>
#include <sstream>

namespace math_test {

using namespace argos;
using Catch::WithinAbs;

// tolerance of a few roundings of numbers of the order of 1
static const Real ROUNDING = 1e-14;

// user code contains such initialisers
static const Real STATIC_NUMBER = ARGOS_PI / 2.0;
static const CRange<CRadians> STATIC_RANGE = CRadians::UNSIGNED_RANGE;
static const CVector3 STATIC_VECTOR = CVector3::Z * 2.0;
static const CRadians STATIC_ANGLE = CRadians::PI_OVER_TWO;
static CRange<Real> STATIC_REALS(-1.0, 1.0);

template <typename T>
static std::string Print(const T& t_value) {
  std::ostringstream cStream;
  cStream << t_value;
  return cStream.str();
}

template <typename T>
static T Read(const std::string& str_text) {
  std::istringstream cStream(str_text);
  T tValue;
  cStream >> tValue;
  return tValue;
}

TEST_CASE("compat: constants can be used in static initialisers", "[compat]") {
  CHECK(STATIC_NUMBER == ARGOS_PI / 2.0);
  CHECK(STATIC_RANGE.GetMax() == CRadians::TWO_PI);
  CHECK(STATIC_VECTOR == CVector3(0.0, 0.0, 2.0));
  CHECK(STATIC_ANGLE.GetValue() == STATIC_NUMBER);
  CHECK(STATIC_REALS.GetSpan() == 2.0);
}

/* 3.1 angles                           */

static_assert(!std::is_convertible<Real, CRadians>::value, "explicit");
static_assert(!std::is_convertible<Real, CDegrees>::value, "explicit");

template <typename ANGLE>
static void CheckAngleAlgebra() {
  ANGLE cA(1.0), cB(0.25);
  CHECK(cA + cB == ANGLE(1.25));
  CHECK(cA - cB == ANGLE(0.75));
  CHECK(cA * 2.0 == ANGLE(2.0));
  CHECK(2.0 * cA == ANGLE(2.0));
  CHECK(cA / 2.0 == ANGLE(0.5));
  CHECK(cA / cB == 4.0);
  CHECK(-cA == ANGLE(-1.0));
  CHECK(&+cA == &cA);
  cA += cB;
  cA -= ANGLE(0.25);
  cA *= 4.0;
  cA /= 2.0;
  CHECK(cA == ANGLE(2.0));
  CHECK(cA != cB);
  CHECK(cB < cA);
  CHECK(cB <= cA);
  CHECK(cA > cB);
  CHECK(cA >= cA);
  CHECK((-cA).GetAbsoluteValue() == 2.0);
  cA.SetValue(3.0);
  CHECK(cA.GetValue() == 3.0);
  CHECK(ANGLE().GetValue() == 0.0);
  CHECK(Read<ANGLE>("1.5") == ANGLE(1.5));
}

TEST_CASE("compat: angles work as documented", "[compat]") {
  CheckAngleAlgebra<CRadians>();
  CheckAngleAlgebra<CDegrees>();
  CHECK(CRadians::PI.GetValue() == ARGOS_PI);
  CHECK(CRadians::TWO_PI == CRadians::PI * 2.0);
  CHECK(CRadians::PI_OVER_TWO == CRadians::PI / 2.0);
  CHECK_THAT((CRadians::PI_OVER_THREE * 3.0 - CRadians::PI).GetValue(), WithinAbs(0.0, ROUNDING));
  CHECK(CRadians::PI_OVER_FOUR == CRadians::PI / 4.0);
  CHECK_THAT((CRadians::PI_OVER_SIX * 6.0 - CRadians::PI).GetValue(), WithinAbs(0.0, ROUNDING));
  CHECK(CRadians::ZERO == CRadians());
  CHECK(CRadians::SIGNED_RANGE.GetMin() == -CRadians::PI);
  CHECK(CRadians::UNSIGNED_RANGE.GetMin() == CRadians::ZERO);
  CHECK_THAT(CRadians::RADIANS_TO_DEGREES, WithinAbs(180.0 / ARGOS_PI, 1e-13));
  CRadians cAngle;
  cAngle.FromValueInDegrees(180.0);
  CHECK_THAT(cAngle.GetValue(), WithinAbs(ARGOS_PI, ROUNDING));
  CDegrees cDegrees;
  cDegrees.FromValueInRadians(ARGOS_PI);
  CHECK_THAT(cDegrees.GetValue(), WithinAbs(180.0, 1e-12));
  CHECK(cAngle.Negate() == -CRadians::PI);
  CRadians cLarge(7.0);
  CHECK(&cLarge.SignedNormalize() == &cLarge);
  CHECK_THAT(cLarge.GetValue(), WithinAbs(7.0 - 2.0 * ARGOS_PI, ROUNDING));
  CHECK_THAT(CRadians(-1.0).UnsignedNormalize().GetValue(),
             WithinAbs(2.0 * ARGOS_PI - 1.0, ROUNDING));
  CHECK_THAT(CDegrees(270.0).SignedNormalize().GetValue(), WithinAbs(-90.0, 1e-12));
  CHECK_THAT(CDegrees(-90.0).UnsignedNormalize().GetValue(), WithinAbs(270.0, 1e-12));
  CHECK_THAT(CVector2(0.0, -1.0).Angle().SignedNormalize().GetValue(),
             WithinAbs(-ARGOS_PI / 2.0, ROUNDING));
  CHECK_THAT(ToDegrees(CRadians::PI).GetValue(), WithinAbs(180.0, 1e-12));
  CHECK_THAT(ToRadians(CDegrees(90.0f)).GetValue(), WithinAbs(ARGOS_PI / 2.0, ROUNDING));
  CHECK_THAT(NormalizedDifference(CRadians(0.1), CRadians(6.2)).GetValue(),
             WithinAbs(0.1 - 6.2 + 2.0 * ARGOS_PI, ROUNDING));
  CHECK_THAT(NormalizedDifference(CDegrees(10.0), CDegrees(350.0)).GetValue(),
             WithinAbs(20.0, 1e-12));
  Real fSin, fCos;
  SinCos(CRadians::PI_OVER_SIX, fSin, fCos);
  CHECK_THAT(fSin, WithinAbs(0.5, ROUNDING));
  CHECK(Sin(CRadians::PI_OVER_SIX) == fSin);
  CHECK(Cos(CRadians::PI_OVER_SIX) == fCos);
  CHECK_THAT(Tan(CRadians::PI_OVER_FOUR), WithinAbs(1.0, ROUNDING));
  CHECK_THAT(ASin(0.5).GetValue(), WithinAbs(ARGOS_PI / 6.0, ROUNDING));
  CHECK_THAT(ACos(0.5).GetValue(), WithinAbs(ARGOS_PI / 3.0, ROUNDING));
  CHECK_THAT(ATan2(1.0, -1.0).GetValue(), WithinAbs(0.75 * ARGOS_PI, ROUNDING));
  CHECK(ARGOS_SIN(0.0) == 0.0);
  CHECK(ARGOS_COS(0.0) == 1.0);
  CHECK(ARGOS_TAN(0.0) == 0.0);
  CHECK(ARGOS_ASIN(0.0) == 0.0);
  CHECK(ARGOS_ACOS(1.0) == 0.0);
  CHECK(ARGOS_ATAN2(0.0, 1.0) == 0.0);
  CHECK(Print(CRadians()) == "CRadians(0 -> 0 degrees)");
  CHECK(Print(CDegrees(1.5)) == "CDegrees(1.5)");
}

/* 3.2 ranges                           */

TEST_CASE("compat: ranges work as documented", "[compat]") {
  CRange<Real> cRange(-1.0, 3.0);
  CHECK(cRange.GetMin() == -1.0);
  CHECK(cRange.GetMax() == 3.0);
  CHECK(cRange.GetSpan() == 4.0);
  CHECK(cRange.WithinMinBoundIncludedMaxBoundIncluded(3.0));
  CHECK_FALSE(cRange.WithinMinBoundIncludedMaxBoundExcluded(3.0));
  CHECK(cRange.WithinMinBoundExcludedMaxBoundIncluded(3.0));
  CHECK_FALSE(cRange.WithinMinBoundExcludedMaxBoundExcluded(-1.0));
  Real fValue = 7.0;
  cRange.TruncValue(fValue);
  CHECK(fValue == 3.0);
  CHECK(cRange.NormalizeValue(1.0) == 0.5);
  CHECK(cRange.NormalizeValue(-9.0) == 0.0);
  cRange.MapValueIntoRange(fValue, 1.0, CRange<Real>(10.0, 20.0));
  CHECK(fValue == 15.0);
  CRadians cAngle;
  cRange.MapValueIntoRange(cAngle, 0.0, CRange<CRadians>(CRadians::ZERO, CRadians(4.0)));
  CHECK(cAngle == CRadians(1.0));
  fValue = 4.0;
  cRange.WrapValue(fValue);
  CHECK(fValue == 0.0);
  cRange.SetMin(0.0);
  cRange.SetMax(2.0);
  cRange.Set(0.5, 1.5);
  CHECK(Print(cRange) == "0.5:1.5");
  CHECK(Read<CRange<Real> >("-2:2.5").GetMax() == 2.5);
  CHECK(Read<CRange<CDegrees> >("-10:10").GetMin() == CDegrees(-10.0));
  CRange<UInt32> cUnsigned(1, 3);
  CHECK(cUnsigned.GetSpan() == 2);
  CHECK(CRange<CRadians>(CRadians(0.0), CRadians(1.0))
            .WithinMinBoundIncludedMaxBoundIncluded(CRadians(0.5)));
  CRange<CVector3> cBox(CVector3(0, 0, 0), CVector3(1, 1, 1));
  CHECK(cBox.WithinMinBoundIncludedMaxBoundIncluded(CVector3(0.5, 1.0, 0.0)));
  CHECK_FALSE(cBox.WithinMinBoundIncludedMaxBoundIncluded(CVector3(0.5, 1.5, 0.0)));
  CHECK(CRange<Real>().GetSpan() == 0.0);
}

/* 3.3, 3.4 vectors                     */

TEST_CASE("compat: two-dimensional vectors work as documented", "[compat]") {
  CHECK(CVector2::X + CVector2::Y == CVector2(1.0, 1.0));
  CHECK(CVector2() == CVector2::ZERO);
  CVector2 cV(std::array<Real, 2>{3.0, 4.0});
  CHECK(cV.Length() == 5.0);
  CHECK(cV.SquareLength() == 25.0);
  CVector2 cPolar(2.0, CRadians::PI_OVER_TWO);
  CHECK_THAT(cPolar.GetY(), WithinAbs(2.0, ROUNDING));
  cPolar.FromPolarCoordinates(1.0, CRadians::ZERO);
  CHECK(cPolar == CVector2::X);
  cV.SetX(1.0);
  cV.SetY(2.0);
  CHECK((cV.GetX() == 1.0 && cV.GetY() == 2.0));
  cV.Set(0.0, 2.0);
  cV.Set(std::array<Real, 2>{0.0, 3.0});
  CHECK(&cV.Normalize() == &cV);
  CHECK(cV == CVector2::Y);
  CHECK(CVector2::ZERO.Angle() == CRadians::ZERO);
  CHECK_THAT(cV.Angle().GetValue(), WithinAbs(ARGOS_PI / 2.0, ROUNDING));
  cV.Rotate(CRadians::PI_OVER_TWO);
  CHECK_THAT(cV.GetX(), WithinAbs(-1.0, ROUNDING));
  CHECK(CVector2(1.0, 2.0).DotProduct(CVector2(3.0, 4.0)) == 11.0);
  CHECK(CVector2(1.0, 2.0).CrossProduct(CVector2(3.0, 4.0)) == -2.0);
  CHECK(CVector2(1.0, 2.0).Scale(2.0, 3.0) == CVector2(2.0, 6.0));
  CHECK(CVector2(1.0, 2.0).Perpendicularize() == CVector2(-2.0, 1.0));
  CHECK(CVector2(-1.0, 2.0).Absolute() == CVector2(1.0, 2.0));
  CVector2 cW(1.0, 2.0);
  cW += CVector2(1.0, 1.0);
  cW -= CVector2(0.0, 1.0);
  cW *= 3.0;
  size_t unCount = 2;
  cW /= unCount;
  CHECK(cW == CVector2(3.0, 3.0));
  CHECK(cW != CVector2::ZERO);
  CHECK(cW - cW == CVector2::ZERO);
  CHECK(-cW == cW * -1.0);
  CHECK(2.0 * cW == cW / 0.5);
  CMatrix<1, 2> cRow = cW;
  CMatrix<2, 1> cColumn = cW;
  CHECK(cRow(0, 1) == cColumn(1, 0));
  CHECK(Print(CVector2(1.5, -2.0)) == "1.5,-2");
  CHECK(Read<CVector2>("1.5, -2") == CVector2(1.5, -2.0));
  CHECK(SquareDistance(CVector2(0.0, 0.0), CVector2(3.0, 4.0)) == 25.0);
  CHECK(Distance(CVector2(0.0, 0.0), CVector2(3.0, 4.0)) == 5.0);
}

TEST_CASE("compat: three-dimensional vectors work as documented", "[compat]") {
  CHECK(CVector3::X + CVector3::Y + CVector3::Z == CVector3(1.0, 1.0, 1.0));
  CHECK(CVector3() == CVector3::ZERO);
  CVector3 cV(std::array<Real, 3>{1.0, 2.0, 2.0});
  CHECK(cV.Length() == 3.0);
  CHECK(cV.SquareLength() == 9.0);
  CVector3 cS(2.0, CRadians::PI_OVER_TWO, CRadians::PI_OVER_TWO);
  CHECK_THAT(cS.GetY(), WithinAbs(2.0, ROUNDING));
  CHECK_THAT(cS.FromSphericalCoords(1.0, CRadians::ZERO, CRadians::ZERO).GetZ(),
             WithinAbs(1.0, ROUNDING));
  Real fRadius;
  CRadians cInclination, cAzimuth;
  CVector3(0.0, 2.0, 0.0).ToSphericalCoords(fRadius, cInclination, cAzimuth);
  CHECK(fRadius == 2.0);
  CHECK_THAT(cInclination.GetValue(), WithinAbs(ARGOS_PI / 2.0, ROUNDING));
  CHECK_THAT(cAzimuth.GetValue(), WithinAbs(ARGOS_PI / 2.0, ROUNDING));
  cV.SetX(1.0);
  cV.SetY(2.0);
  cV.SetZ(3.0);
  cV.Set(0.0, 0.0, 4.0);
  cV.Set(std::array<Real, 3>{0.0, 0.0, 5.0});
  CHECK(cV.Normalize() == CVector3::Z);
  CHECK_THAT(CVector3(CVector3::Y).RotateX(CRadians::PI_OVER_TWO).GetZ(), WithinAbs(1.0, ROUNDING));
  CHECK_THAT(CVector3(CVector3::Z).RotateY(CRadians::PI_OVER_TWO).GetX(), WithinAbs(1.0, ROUNDING));
  CHECK_THAT(CVector3(CVector3::X).RotateZ(CRadians::PI_OVER_TWO).GetY(), WithinAbs(1.0, ROUNDING));
  CHECK(CVector3(CVector3::X).RotateZ(CVector2(0.0, 1.0)) == CVector3::Y);
  CHECK_THAT(CVector3(CVector3::X).Rotate(CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z)).GetY(),
             WithinAbs(1.0, ROUNDING));
  CVector3 cX = CVector3::X;
  CHECK_THAT(cX.GetAngleWith(CVector3::Y).GetValue(), WithinAbs(ARGOS_PI / 2.0, ROUNDING));
  CHECK_THAT(CVector3(0.0, 1.0, 1.0).GetXAngle().GetValue(), WithinAbs(ARGOS_PI / 4.0, ROUNDING));
  CHECK_THAT(CVector3(1.0, 0.0, 1.0).GetYAngle().GetValue(), WithinAbs(ARGOS_PI / 4.0, ROUNDING));
  CHECK_THAT(CVector3(1.0, 1.0, 0.0).GetZAngle().GetValue(), WithinAbs(ARGOS_PI / 4.0, ROUNDING));
  CHECK(CVector3(1.0, 2.0, 3.0).DotProduct(CVector3(4.0, 5.0, 6.0)) == 32.0);
  CVector3 cCross = CVector3::X;
  CHECK(&cCross.CrossProduct(CVector3::Y) == &cCross);
  CHECK(cCross == CVector3::Z);
  CVector2 cFlat;
  CHECK(CVector3(1.0, 2.0, 3.0).ProjectOntoXY(cFlat) == CVector2(1.0, 2.0));
  CHECK(CVector3(1.0, 2.0, 3.0).ProjectOntoYZ(cFlat) == CVector2(2.0, 3.0));
  CHECK(CVector3(1.0, 2.0, 3.0).ProjectOntoXZ(cFlat) == CVector2(1.0, 3.0));
  CHECK(CVector3(1.0, 2.0, 3.0).Negate() == CVector3(-1.0, -2.0, -3.0));
  CVector3 cI(1.0, 2.0, 3.0);
  cI[1] = 7.0;
  const CVector3& cConst = cI;
  CHECK(cConst[1] == 7.0);
  CHECK_THROWS_AS(cI[3], CARGoSException);
  CHECK(CVector3(0, 0, 0) < CVector3(1, 1, 1));
  CHECK_FALSE(CVector3(0, 0, 1) < CVector3(1, 1, 1));
  CHECK(CVector3(0, 0, 1) <= CVector3(1, 1, 1));
  CHECK(CVector3(1, 1, 1) > CVector3(0, 0, 0));
  CHECK(CVector3(1, 1, 1) >= CVector3(0, 1, 0));
  CVector3 cW(1.0, 2.0, 3.0);
  cW += CVector3::X;
  cW -= CVector3::Z;
  cW *= 2.0;
  cW /= 4.0;
  CHECK(cW == CVector3(1.0, 1.0, 1.0));
  CHECK(cW != CVector3::ZERO);
  CHECK(-cW + cW == cW - cW);
  CHECK(2.0 * cW == cW * 2.0);
  CHECK(cW / 2.0 == cW * 0.5);
  CMatrix<1, 3> cRow = cW;
  CMatrix<3, 1> cColumn = cW;
  CHECK(cRow(0, 2) == cColumn(2, 0));
  CHECK(Print(CVector3(1.0, 2.5, -3.0)) == "1,2.5,-3");
  CHECK(Read<CVector3>(" 1, 2.5,-3") == CVector3(1.0, 2.5, -3.0));
  CHECK(SquareDistance(CVector3(), CVector3(1.0, 2.0, 2.0)) == 9.0);
  CHECK(Distance(CVector3(), CVector3(1.0, 2.0, 2.0)) == 3.0);
}

/* 3.5 quaternions                      */

TEST_CASE("compat: quaternions work as documented", "[compat]") {
  CQuaternion cQ;
  CHECK((cQ.GetW() == 1.0 && cQ.GetX() == 0.0 && cQ.GetY() == 0.0 && cQ.GetZ() == 0.0));
  CQuaternion cCopy(cQ);
  CHECK(cCopy == cQ);
  cQ = CQuaternion(1.0, 2.0, 3.0, 4.0);
  CHECK(cQ.SquareLength() == 30.0);
  CHECK_THAT(cQ.Length() * cQ.Length(), WithinAbs(30.0, 1e-13));
  cQ.SetW(0.0);
  cQ.SetX(0.0);
  cQ.SetY(3.0);
  cQ.SetZ(4.0);
  CHECK(cQ.Normalize().GetZ() == 0.8);
  cQ.Set(1.0, 0.0, 0.0, 0.0);
  CHECK(cQ.Conjugate() == cQ);
  CHECK(cQ.Inverse() == cQ);
  CQuaternion cTurn(CRadians::PI_OVER_TWO, CVector3::Z);
  CQuaternion cBetween(CVector3::X, CVector3::Y);
  CHECK_THAT(cTurn.GetZ(), WithinAbs(cBetween.GetZ(), ROUNDING));
  CRadians cAngle;
  CVector3 cAxis;
  cTurn.ToAngleAxis(cAngle, cAxis);
  CHECK_THAT(cAngle.GetValue(), WithinAbs(ARGOS_PI / 2.0, ROUNDING));
  CHECK_THAT(cAxis.GetZ(), WithinAbs(1.0, ROUNDING));
  CQuaternion().ToAngleAxis(cAngle, cAxis);
  CHECK(cAngle == CRadians::ZERO);
  CHECK(cAxis == CVector3::Z);
  CHECK_THAT(cQ.FromAngleAxis(CRadians::PI, CVector3::X).GetX(), WithinAbs(1.0, ROUNDING));
  CRadians cZ, cY, cX;
  cQ.FromEulerAngles(CRadians(0.3), CRadians(0.2), CRadians(0.1)).ToEulerAngles(cZ, cY, cX);
  CHECK_THAT(cZ.GetValue(), WithinAbs(0.3, ROUNDING));
  CHECK_THAT(cY.GetValue(), WithinAbs(0.2, ROUNDING));
  CHECK_THAT(cX.GetValue(), WithinAbs(0.1, ROUNDING));
  // rotations about z first, then y, then x
  CQuaternion cSteps = CQuaternion(CRadians(0.1), CVector3::X) *
                       CQuaternion(CRadians(0.2), CVector3::Y) *
                       CQuaternion(CRadians(0.3), CVector3::Z);
  CHECK_THAT(cSteps.GetW(), WithinAbs(cQ.GetW(), ROUNDING));
  CHECK_THAT(cSteps.GetY(), WithinAbs(cQ.GetY(), ROUNDING));
  cQ.BetweenTwoVectors(CVector3::X, CVector3::Z);
  CHECK_THAT(CVector3(CVector3::X).Rotate(cQ).GetZ(), WithinAbs(1.0, ROUNDING));
  CQuaternion cSum(1.0, 1.0, 1.0, 1.0);
  cSum += CQuaternion(1.0, 0.0, 0.0, 0.0);
  cSum -= CQuaternion(0.0, 1.0, 0.0, 0.0);
  CHECK(cSum == CQuaternion(2.0, 0.0, 1.0, 1.0));
  CHECK(cSum + cSum == CQuaternion(4.0, 0.0, 2.0, 2.0));
  CHECK(cSum - cSum == CQuaternion(0.0, 0.0, 0.0, 0.0));
  cSum *= CQuaternion();
  CHECK(cSum == CQuaternion(2.0, 0.0, 1.0, 1.0));
  CRotationMatrix3 cMatrix = cTurn;
  CHECK_THAT((cMatrix * CVector3::X).GetY(), WithinAbs(1.0, ROUNDING));
  CHECK_THAT(CVector3(CVector3::X).Rotate(Read<CQuaternion>("90,0,0")).GetY(),
             WithinAbs(1.0, ROUNDING));
  CHECK(Print(CQuaternion()) == "0,0,0");
}

/* 3.6 rays, planes, solids, poses      */

TEST_CASE("compat: rays work as documented", "[compat]") {
  CRay2 cRay2(CVector2(0.0, 0.0), CVector2(2.0, 0.0));
  CRay2 cDirected(CVector2(1.0, -1.0), CVector2(0.0, 1.0), 2.0);
  CHECK(cDirected.GetEnd() == CVector2(1.0, 1.0));
  CHECK(cRay2.Intersects(cDirected));
  CRay2 cOther;
  cOther.SetStart(CVector2(0.0, 1.0));
  cOther.SetEnd(CVector2(2.0, 1.0));
  CHECK_FALSE(cRay2.Intersects(cOther));
  cOther.Set(CVector2(0.0, 0.0), CVector2(0.0, 4.0));
  cOther.Set(CVector2(0.0, 0.0), CVector2(0.0, 1.0), 4.0);
  CVector2 cBuffer;
  cOther.GetDirection(cBuffer);
  CHECK(cBuffer == CVector2::Y);
  cOther.GetInverseDirection(cBuffer);
  CHECK(cBuffer == -CVector2::Y);
  CHECK(cOther.GetLength() == 4.0);
  cOther.ToVector(cBuffer);
  CHECK(cBuffer == CVector2(0.0, 4.0));
  cOther.GetPoint(cBuffer, 0.25);
  CHECK(cBuffer == CVector2::Y);
  CHECK(cOther.GetDistance(0.5) == 2.0);
  CHECK(cRay2.GetStart() == CVector2::ZERO);
  CHECK(Print(cRay2) == "0,0 -> 2,0");

  CRay3 cRay(CVector3(0.0, 0.0, 2.0), CVector3(0.0, 0.0, 0.0));
  CRay3 cDirected3(CVector3(), CVector3::X, 3.0);
  CHECK(cDirected3.GetEnd() == CVector3(3.0, 0.0, 0.0));
  CRay3 cDefault;
  cDefault.SetStart(CVector3::Y);
  cDefault.SetEnd(CVector3::Z);
  cDefault.Set(CVector3(), CVector3::X);
  cDefault.Set(CVector3(), CVector3::X, 2.0);
  cDefault.SetLength(5.0);
  CHECK(cDefault.GetEnd() == CVector3(5.0, 0.0, 0.0));
  cDefault.GetStart().SetX(1.0);
  cDefault.GetEnd().SetX(2.0);
  const CRay3& cConst = cDefault;
  CHECK((cConst.GetStart() == CVector3::X && cConst.GetEnd() == CVector3(2.0, 0.0, 0.0)));
  CVector3 cBuffer3;
  cDefault.GetDirection(cBuffer3);
  CHECK(cBuffer3 == CVector3::X);
  cDefault.GetInverseDirection(cBuffer3);
  CHECK(cBuffer3 == -CVector3::X);
  CHECK(cDefault.GetLength() == 1.0);
  CHECK(cDefault.ToVector(cBuffer3) == CVector3::X);
  cDefault.GetPoint(cBuffer3, 0.5);
  CHECK(cBuffer3 == CVector3(1.5, 0.0, 0.0));
  CHECK(cRay.GetDistance(0.5) == 1.0);
  CVector3 cPoint;
  CHECK(cRay.Intersects(CPlane(CVector3(0.0, 0.0, 0.5), CVector3::Z), cPoint));
  CHECK(cPoint == CVector3(0.0, 0.0, 0.5));
  CHECK_FALSE(cRay.Intersects(CPlane(CVector3(0.0, 0.0, -0.5), CVector3::Z), cPoint));
  CHECK(Print(cRay) == "0,0,2 -> 0,0,0");
}

TEST_CASE("compat: planes, solids, hulls and poses work as documented", "[compat]") {
  CPlane cPlane;
  cPlane.SetPosition(CVector3(0.0, 0.0, 1.0));
  cPlane.SetNormal(CVector3::Z);
  Real fT;
  CRay3 cDown(CVector3(0.0, 0.0, 2.0), CVector3(0.0, 0.0, -2.0));
  CHECK(cPlane.Intersects(fT, cDown));
  CHECK(fT == 0.25);
  CHECK(cPlane.GetPosition() == CVector3::Z);
  CPlane cThree(CVector3(1, 0, 0), CVector3(0, 0, 0), CVector3(0, 1, 0));
  CVector3 cNormal = cThree.GetNormal();
  // (p3 - p2) x (p1 - p2)
  CHECK(cNormal.Normalize() == -CVector3::Z);
  cPlane.SetFromThreePoints(CVector3(1, 0, 0), CVector3(0, 0, 0), CVector3(0, 1, 0));
  CHECK(cPlane.GetPosition() == CVector3());

  CCylinder cCylinder(0.5, 1.0);
  CHECK(cCylinder.Intersects(fT, cDown));
  CHECK_THAT(fT, WithinAbs(0.25, ROUNDING));
  cCylinder.SetRadius(0.25);
  cCylinder.SetHeight(1.5);
  cCylinder.SetBasePosition(CVector3(1.0, 0.0, 0.0));
  cCylinder.SetAxis(CVector3::X);
  CHECK((cCylinder.GetRadius() == 0.25 && cCylinder.GetHeight() == 1.5));
  CHECK((cCylinder.GetBasePosition() == CVector3::X && cCylinder.GetAxis() == CVector3::X));

  CBox cBox(CVector3(1.0, 1.0, 1.0));
  CHECK(cBox.Intersects(fT, cDown));
  CHECK_THAT(fT, WithinAbs(0.25, ROUNDING));
  cBox.SetSize(CVector3(2.0, 2.0, 2.0));
  cBox.SetBasePosition(CVector3(5.0, 0.0, 0.0));
  cBox.SetOrientation(CQuaternion(CRadians::PI, CVector3::Z));
  CHECK(cBox.GetSize() == CVector3(2.0, 2.0, 2.0));
  CHECK(cBox.GetBasePosition() == CVector3(5.0, 0.0, 0.0));
  CHECK(cBox.GetOrientation().GetW() < 1e-15);
  CHECK_FALSE(cBox.Intersects(fT, cDown));

  std::vector<CVector3> vecPoints = {CVector3(0, 0, 0), CVector3(1, 0, 0), CVector3(0, 1, 0),
                                     CVector3(0, 0, 1)};
  CConvexHull cHull(vecPoints);
  const std::vector<CConvexHull::SFace>& vecFaces = cHull.GetFaces();
  REQUIRE(vecFaces.size() == 4);
  const std::array<UInt32, 3>& cIndices = vecFaces[0].VertexIndices;
  CHECK(cIndices[0] < 4);
  CHECK_THAT(vecFaces[0].Normal.Length(), WithinAbs(1.0, ROUNDING));
  Real fDirection = vecFaces[0].Direction;
  CHECK(std::isfinite(fDirection));

  CPose2 cPose(CVector2(1.0, 0.0), CRadians::PI_OVER_TWO);
  CPose2 cSame(1.0, 0.0, CRadians::PI_OVER_TWO.GetValue());
  CPose2 cFrom3(CVector3(1.0, 0.0, 5.0), CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  CPose2 cCopy(cPose), cDefault;
  CHECK(cCopy == cSame);
  CHECK(cCopy != cDefault);
  CHECK_THAT(cFrom3.GetOrientation().GetValue(), WithinAbs(ARGOS_PI / 2.0, ROUNDING));
  CHECK_THAT((cPose * CVector2(1.0, 0.0)).GetY(), WithinAbs(1.0, ROUNDING));
  CHECK_THAT((cPose * cPose.Inverse()).GetPosition().Length(), WithinAbs(0.0, ROUNDING));
  cPose *= CPose2();
  cPose.Translate(CVector2(1.0, 0.0));
  CHECK_THAT(cPose.GetPosition().GetY(), WithinAbs(1.0, ROUNDING));
  cPose.Rotate(-CRadians::PI_OVER_TWO);
  CHECK_THAT(cPose.GetOrientation().GetValue(), WithinAbs(0.0, ROUNDING));

  CVector3 cGlobal = LocalToGlobal(CVector3::X, CVector3(1.0, 0.0, 0.0),
                                   CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  CHECK_THAT(cGlobal.GetY(), WithinAbs(1.0, ROUNDING));
  CVector3 cLocal = GlobalToLocal(cGlobal, CVector3(1.0, 0.0, 0.0),
                                  CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z));
  CHECK_THAT(cLocal.GetX(), WithinAbs(1.0, ROUNDING));
}

/* 3.7 random numbers                   */

TEST_CASE("compat: random numbers work as documented", "[compat]") {
  CHECK(CRandom::CreateCategory("compat", 17));
  CHECK_FALSE(CRandom::CreateCategory("compat", 18));
  CHECK(CRandom::ExistsCategory("compat"));
  CHECK(CRandom::GetSeedOf("compat") == 17);
  CHECK_THROWS_AS(CRandom::GetSeedOf("nothing"), CARGoSException);
  CRandom::CRNG* pcRNG = CRandom::CreateRNG("compat");
  // the seeder of the category gives the seed, uniform in [1, 2^32-1]
  std::mt19937 cSeeder(17);
  UInt32 unSeed = static_cast<UInt32>(1.0 + (cSeeder() / 4294967295.0) * 4294967294.0);
  CHECK(pcRNG->GetSeed() == unSeed);
  std::mt19937 cStandard(unSeed);
  CHECK(pcRNG->Uniform(CRange<Real>(2.0, 5.0)) == 2.0 + (cStandard() / 4294967295.0) * 3.0);
  CHECK(pcRNG->Uniform(CRange<UInt32>(0, 100)) ==
        static_cast<UInt32>((cStandard() / 4294967295.0) * 100.0));
  CHECK(pcRNG->Bernoulli(0.3) == (cStandard() < 0.3 * 4294967295.0));
  CRandom::CRNG cCopy(*pcRNG);
  CHECK(cCopy.Uniform(CRange<SInt32>(-50, 50)) == pcRNG->Uniform(CRange<SInt32>(-50, 50)));
  CRadians cAngle = pcRNG->Uniform(CRadians::UNSIGNED_RANGE);
  CHECK(CRadians::UNSIGNED_RANGE.WithinMinBoundIncludedMaxBoundIncluded(cAngle));
  CHECK(pcRNG->Exponential(2.0) >= 0.0);
  CHECK(pcRNG->Poisson(3.0) < 1000);
  CHECK(pcRNG->Gaussian(0.0, 4.0) == 4.0);
  CHECK(std::isfinite(pcRNG->Gaussian(1.0)));
  CHECK(pcRNG->Rayleigh(1.0) > 0.0);
  CHECK(pcRNG->Lognormal(0.1, 0.0) > 0.0);
  CHECK((pcRNG->Bernoulli() || true));
  std::vector<UInt32> vecNumbers = {1, 2, 3, 4, 5};
  pcRNG->Shuffle(vecNumbers);
  std::sort(vecNumbers.begin(), vecNumbers.end());
  CHECK(vecNumbers == std::vector<UInt32>{1, 2, 3, 4, 5});
  pcRNG->SetSeed(5);
  pcRNG->Reset();
  CHECK(CRandom::CRNG(5).Uniform(STATIC_REALS) == pcRNG->Uniform(STATIC_REALS));
  CRandom::CCategory& cCategory = CRandom::GetCategory("compat");
  CHECK(cCategory.GetId() == "compat");
  cCategory.SetSeed(99);
  CHECK(cCategory.GetSeed() == 99);
  CRandom::SetSeedOf("compat", 17);
  cCategory.ReseedRNGs();
  cCategory.ResetRNGs();
  CHECK(pcRNG->GetSeed() == unSeed);
  CRandom::CRNG* pcSecond = cCategory.CreateRNG();
  CHECK(pcSecond != pcRNG);
  cCategory.SetId("renamed");
  Real fFirst = pcRNG->Uniform(STATIC_REALS);
  CRandom::Reset();
  CHECK(pcRNG->Uniform(STATIC_REALS) == fFirst);
  CRandom::RemoveCategory("compat");
  CHECK_FALSE(CRandom::ExistsCategory("compat"));
  CRandom::CCategory cOwn("own", 3);
  CHECK(cOwn.CreateRNG()->GetSeed() >= 1);
}

/* 3.9 matrices                         */

class COpenMatrix : public CMatrix<2, 2> {
 public:
  Real First() const { return m_pfValues[0]; }
};

TEST_CASE("compat: matrices work as documented", "[compat]") {
  const Real pfValues[6] = {1, 2, 3, 4, 5, 6};
  CMatrix<2, 3> cM(pfValues);
  CMatrix<2, 3> cCopy(cM), cZero;
  CHECK(cM(1, 0) == 4.0);
  CHECK(cM(5) == 6.0);
  const CMatrix<2, 3>& cConst = cM;
  CHECK((cConst(0, 2) == 3.0 && cConst(2) == 3.0));
  cM(0, 0) = 7.0;
  cM(1) = 8.0;
  cM = cCopy;
  CHECK(cM == cCopy);
  cCopy.Set(pfValues);
  cCopy.SetZero();
  CHECK(cCopy == cZero);
  CMatrix<3, 2> cT = cM.GetTransposed();
  CHECK(cT(2, 1) == 6.0);
  CMatrix<1, 2> cSub;
  cM.GetSubMatrix(cSub, 1, 1);
  CHECK((cSub(0, 0) == 5.0 && cSub(0, 1) == 6.0));
  cCopy += cM;
  cCopy -= cZero;
  cCopy *= 2.0;
  CHECK(cCopy == cM + cM);
  CHECK(cM - cM == cZero);
  CHECK(-cM + cM == cZero);
  CMatrix<2, 2> cProduct = cM * cT;
  CHECK(cProduct(0, 0) == 14.0);
  CSquareMatrix<3> cIdentity;
  cIdentity.SetIdentityMatrix();
  cM *= cIdentity;
  CHECK(cM(1, 2) == 6.0);
  CHECK(cIdentity.IsIdentityMatrix());
  CSquareMatrix<2> cS(cProduct);
  CHECK_THAT(cS.GetDeterminant(), WithinAbs(14.0 * 77.0 - 32.0 * 32.0, 1e-10));
  CHECK_THAT((cS.GetInverse() * cS)(0, 0), WithinAbs(1.0, 1e-12));
  CHECK(cS.GetCofactorMatrix()(0, 0) == 77.0);
  CHECK(cS.GetTransposed()(0, 1) == cS(1, 0));
  CHECK(COpenMatrix().First() == 0.0);
  CHECK(Print(CMatrix<1, 2>()).find("0.00") != std::string::npos);

  CRotationMatrix2 cR2(CRadians::PI_OVER_TWO);
  CHECK_THAT((cR2 * CVector2::X).GetY(), WithinAbs(1.0, ROUNDING));
  CRotationMatrix2 cR2b(0.0, -1.0, 1.0, 0.0), cR2c(static_cast<const CMatrix<2, 2>&>(cR2b)), cR2d;
  cR2d.SetFromMatrix(cR2b);
  cR2d.SetFromAngle(CRadians::ZERO);
  cR2d.SetFromValues(0.0, -1.0, 1.0, 0.0);
  CHECK(cR2d * CVector2::X == CVector2::Y);
  CHECK(cR2c == cR2d);

  CRotationMatrix3 cR3(CRadians(0.3), CRadians(0.2), CRadians(0.1));
  CQuaternion cOther = CQuaternion(CRadians(0.3), CVector3::Z) *
                       CQuaternion(CRadians(0.2), CVector3::Y) *
                       CQuaternion(CRadians(0.1), CVector3::X);
  CQuaternion cBack = cR3;
  CHECK_THAT(cBack.GetX(), WithinAbs(cOther.GetX(), ROUNDING));
  CHECK_THAT(cBack.GetZ(), WithinAbs(cOther.GetZ(), ROUNDING));
  CRotationMatrix3 cR3b(1, 0, 0, 0, 1, 0, 0, 0, 1), cR3c(static_cast<const CMatrix<3, 3>&>(cR3b)),
      cR3d;
  cR3d.SetFromMatrix(cR3);
  cR3d.SetFromAngles(CRadians::ZERO, CRadians::ZERO, CRadians::ZERO);
  cR3d.SetFromValues(1, 0, 0, 0, 1, 0, 0, 0, 1);
  CHECK(cR3d * CVector3(1, 2, 3) == CVector3(1, 2, 3));
  CHECK(cR3c == cR3d);

  CTransformationMatrix2 cT2(cR2, CVector2(1.0, 2.0)), cT2b(static_cast<const CMatrix<3, 3>&>(cT2)),
      cT2c;
  CTransformationMatrix2 cT2d(1, 0, 5, 0, 1, 6, 0, 0, 1);
  CHECK(cT2d.GetTranslationVector() == CVector2(5.0, 6.0));
  cT2c.SetFromMatrix(cT2b);
  cT2c.SetFromComponents(cR2, CVector2(3.0, 4.0));
  CHECK(cT2c.GetTranslationVector() == CVector2(3.0, 4.0));
  cT2c.SetFromValues(1, 0, 0, 0, 1, 0, 0, 0, 1);
  cT2c.SetRotationMatrix(cR2);
  cT2c.SetTranslationVector(CVector2(7.0, 8.0));
  CHECK_THAT((cT2c.GetRotationMatrix() * CVector2::X).GetY(), WithinAbs(1.0, ROUNDING));

  CTransformationMatrix3 cT3(CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z),
                             CVector3(1.0, 0.0, 0.0));
  CHECK_THAT((cT3 * CVector3::X).GetY(), WithinAbs(1.0, ROUNDING));
  CHECK_THAT(((cT3 * cT3) * CVector3()).GetY(), WithinAbs(1.0, ROUNDING));
  CTransformationMatrix3 cT3b(static_cast<const CMatrix<4, 4>&>(cT3)),
      cT3c(1, 0, 0, 2, 0, 1, 0, 3, 0, 0, 1, 4, 0, 0, 0, 1), cT3d;
  CHECK(cT3c.GetTranslationVector() == CVector3(2, 3, 4));
  cT3d.SetFromMatrix(cT3b);
  cT3d.SetFromComponents(cR3b, CVector3(1, 1, 1));
  cT3d.SetFromValues(1, 0, 0, 2, 0, 1, 0, 3, 0, 0, 1, 4, 0, 0, 0, 1);
  cT3d.SetRotationMatrix(cR3b);
  cT3d.SetTranslationVector(CVector3(9, 9, 9));
  CHECK((cT3d.GetRotationMatrix() * CVector3::X) == CVector3::X);
}

}  // namespace math_test
