#include <argos3/core/utility/math/quaternion.h>

#include <argos3/core/utility/math/eigen_bridge.h>
#include <argos3/core/utility/math/text_input.h>

#include <array>
#include <cmath>

namespace argos {

namespace {

// half the sine of y above which ARGoS 3 reports gimbal lock
constexpr Real kGimbalLockThreshold = 0.49999;

// adding zero turns a numerator of -0 into +0, so that half a turn is PI and never -PI
CRadians ComputeAngle(Real sine, Real cosine) {
  return ATan2(sine + 0.0, cosine);
}

}  // namespace

CQuaternion& CQuaternion::Normalize() {
  const Real length = Length();
  Set(m_w / length, m_x / length, m_y / length, m_z / length);
  return *this;
}

CQuaternion& CQuaternion::FromAngleAxis(const CRadians& angle, const CVector3& axis) {
  Real sine = 0.0;
  Real cosine = 1.0;
  SinCos(angle * 0.5, sine, cosine);
  Set(cosine, sine * axis.GetX(), sine * axis.GetY(), sine * axis.GetZ());
  return *this;
}

void CQuaternion::ToAngleAxis(CRadians& angle, CVector3& axis) const {
  const CVector3 vectorPart(m_x, m_y, m_z);
  const Real sine = vectorPart.Length();
  // both identities, (1,0,0,0) and (-1,0,0,0), turn by 0
  angle = sine > 0.0 ? 2.0 * ATan2(sine, m_w) : CRadians::ZERO;
  axis = sine > 0.0 ? vectorPart / sine : CVector3::Z;
}

CQuaternion& CQuaternion::FromEulerAngles(const CRadians& z, const CRadians& y, const CRadians& x) {
  Real sineZ = 0.0;
  Real cosineZ = 1.0;
  Real sineY = 0.0;
  Real cosineY = 1.0;
  Real sineX = 0.0;
  Real cosineX = 1.0;
  SinCos(z * 0.5, sineZ, cosineZ);
  SinCos(y * 0.5, sineY, cosineY);
  SinCos(x * 0.5, sineX, cosineX);

  // the product q_x q_y q_z, multiplied out
  Set(cosineX * cosineY * cosineZ - sineX * sineY * sineZ,
      sineX * cosineY * cosineZ + cosineX * sineY * sineZ,
      cosineX * sineY * cosineZ - sineX * cosineY * sineZ,
      sineX * sineY * cosineZ + cosineX * cosineY * sineZ);
  return *this;
}

void CQuaternion::ToEulerAngles(CRadians& z, CRadians& y, CRadians& x) const {
  // let R = Rx Ry Rz: sin y is the last entry of the first row
  const Real halfSineY = m_x * m_z + m_w * m_y;
  if (std::fabs(halfSineY) > kGimbalLockThreshold) {
    x = CRadians::ZERO;
    y = halfSineY > 0.0 ? CRadians::PI_OVER_TWO : -CRadians::PI_OVER_TWO;
    z = ComputeAngle(2.0 * (m_x * m_y + m_w * m_z), 1.0 - 2.0 * (m_x * m_x + m_z * m_z));
    return;
  }
  x = ComputeAngle(2.0 * (m_w * m_x - m_y * m_z), 1.0 - 2.0 * (m_x * m_x + m_y * m_y));
  y = ASin(2.0 * halfSineY);
  z = ComputeAngle(2.0 * (m_w * m_z - m_x * m_y), 1.0 - 2.0 * (m_y * m_y + m_z * m_z));
}

CQuaternion& CQuaternion::BetweenTwoVectors(const CVector3& from, const CVector3& to) {
  if (from.SquareLength() == 0.0 || to.SquareLength() == 0.0) {
    return *this = CQuaternion();
  }
  constexpr Real kOpposite = 1e-12;
  const Real lengths = std::sqrt(from.SquareLength() * to.SquareLength());
  if (from.DotProduct(to) < (kOpposite - 1.0) * lengths) {
    // half a turn; of all axes normal to both the one that is also normal to x, or to y
    CVector3 axis = from;
    axis.CrossProduct(CVector3::X);
    if (axis.SquareLength() < kOpposite * from.SquareLength()) {
      axis = CVector3(from).CrossProduct(CVector3::Y);
    }
    return FromAngleAxis(CRadians::PI, axis.Normalize());
  }
  return *this = FromEigen(Eigen::Quaternion<Real>::FromTwoVectors(ToEigen(from), ToEigen(to)));
}

std::ostream& operator<<(std::ostream& os, const CQuaternion& quaternion) {
  CRadians z;
  CRadians y;
  CRadians x;
  quaternion.ToEulerAngles(z, y, x);
  return os << ToDegrees(z).GetValue() << "," << ToDegrees(y).GetValue() << ","
            << ToDegrees(x).GetValue();
}

std::istream& operator>>(std::istream& is, CQuaternion& quaternion) {
  if (is) {
    std::array<Real, 3> degrees;
    ReadNumbers(is, degrees.data(), 3, "an orientation (z,y,x in degrees)");
    quaternion.FromEulerAngles(ToRadians(CDegrees(degrees[0])), ToRadians(CDegrees(degrees[1])),
                               ToRadians(CDegrees(degrees[2])));
  }
  return is;
}

}  // namespace argos
