#ifndef ARGOS3_CORE_UTILITY_MATH_QUATERNION_H
#define ARGOS3_CORE_UTILITY_MATH_QUATERNION_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

#include <cmath>
#include <istream>
#include <ostream>

namespace argos {

class CRotationMatrix3;

/**
 * A rotation in space as w + x i + y j + z k; four numbers, trivially copyable.
 *
 * Rotations have length 1: Inverse(), CVector3::Rotate() and the conversions assume it without a
 * check. q and -q are the same rotation but compare unequal.
 *
 * Euler angles have the order z, y, x everywhere (arguments and text) and mean q = q_x(x) q_y(y)
 * q_z(z): about fixed axes, rotate about z first, then y, then x.
 */
class CQuaternion {
 public:
  /** The identity. */
  constexpr CQuaternion() : CQuaternion(1.0, 0.0, 0.0, 0.0) {}

  constexpr CQuaternion(const CQuaternion& other) = default;

  constexpr CQuaternion(Real w, Real x, Real y, Real z) : m_w(w), m_x(x), m_y(y), m_z(z) {}

  /** See FromAngleAxis(). */
  CQuaternion(const CRadians& angle, const CVector3& axis) : CQuaternion() {
    FromAngleAxis(angle, axis);
  }

  /** See BetweenTwoVectors(). */
  CQuaternion(const CVector3& from, const CVector3& to) : CQuaternion() {
    BetweenTwoVectors(from, to);
  }

  constexpr Real GetW() const { return m_w; }
  constexpr Real GetX() const { return m_x; }
  constexpr Real GetY() const { return m_y; }
  constexpr Real GetZ() const { return m_z; }
  constexpr void SetW(Real w) { m_w = w; }
  constexpr void SetX(Real x) { m_x = x; }
  constexpr void SetY(Real y) { m_y = y; }
  constexpr void SetZ(Real z) { m_z = z; }

  constexpr void Set(Real w, Real x, Real y, Real z) {
    m_w = w;
    m_x = x;
    m_y = y;
    m_z = z;
  }

  constexpr CQuaternion Conjugate() const { return CQuaternion(m_w, -m_x, -m_y, -m_z); }

  /** Returns the conjugate, which is the inverse of a quaternion of length 1. */
  constexpr CQuaternion Inverse() const { return Conjugate(); }

  Real Length() const { return std::sqrt(SquareLength()); }
  constexpr Real SquareLength() const { return m_w * m_w + m_x * m_x + m_y * m_y + m_z * m_z; }

  /** Scales to length 1; the zero quaternion becomes NaN. */
  CQuaternion& Normalize();

  /** @param axis must have length 1. */
  CQuaternion& FromAngleAxis(const CRadians& angle, const CVector3& axis);

  /** Gives an angle in [0, 2 PI] and an axis of length 1; the identity gives 0 and Z. */
  void ToAngleAxis(CRadians& angle, CVector3& axis) const;

  CQuaternion& FromEulerAngles(const CRadians& z, const CRadians& y, const CRadians& x);

  /**
   * Gives z and x in (-PI,PI] and y in [-PI/2,PI/2].
   *
   * Within 0.36 degrees of y = +-PI/2 (gimbal lock: |sin y| > 0.99998) x is set to 0, y to +-PI/2,
   * and z to the remaining rotation.
   */
  void ToEulerAngles(CRadians& z, CRadians& y, CRadians& x) const;

  /**
   * Sets the shortest rotation from the direction of one vector to that of another; lengths are
   * ignored.
   *
   * Opposite vectors give half a turn about an axis normal to them; a zero vector gives the
   * identity.
   */
  CQuaternion& BetweenTwoVectors(const CVector3& from, const CVector3& to);

  /** Exact comparison. */
  constexpr bool operator==(const CQuaternion& other) const {
    return m_w == other.m_w && m_x == other.m_x && m_y == other.m_y && m_z == other.m_z;
  }

  constexpr CQuaternion& operator=(const CQuaternion& other) = default;

  constexpr CQuaternion& operator+=(const CQuaternion& other) { return *this = *this + other; }
  constexpr CQuaternion& operator-=(const CQuaternion& other) { return *this = *this - other; }

  /** this = this * other. */
  constexpr CQuaternion& operator*=(const CQuaternion& other) { return *this = *this * other; }

  constexpr CQuaternion operator+(const CQuaternion& other) const {
    return CQuaternion(m_w + other.m_w, m_x + other.m_x, m_y + other.m_y, m_z + other.m_z);
  }

  constexpr CQuaternion operator-(const CQuaternion& other) const {
    return CQuaternion(m_w - other.m_w, m_x - other.m_x, m_y - other.m_y, m_z - other.m_z);
  }

  /** The Hamilton product: a * b rotates by b first, then by a. */
  constexpr CQuaternion operator*(const CQuaternion& other) const {
    return CQuaternion(m_w * other.m_w - m_x * other.m_x - m_y * other.m_y - m_z * other.m_z,
                       m_w * other.m_x + m_x * other.m_w + m_y * other.m_z - m_z * other.m_y,
                       m_w * other.m_y - m_x * other.m_z + m_y * other.m_w + m_z * other.m_x,
                       m_w * other.m_z + m_x * other.m_y - m_y * other.m_x + m_z * other.m_w);
  }

  /** Defined in matrix/rotationmatrix3.h. */
  operator CRotationMatrix3() const;

 private:
  Real m_w;
  Real m_x;
  Real m_y;
  Real m_z;
};

CVector3& CVector3::Rotate(const CQuaternion& rotation) {
  // q v q* = (w^2 - u.u) v + 2 (u.v) u + 2 w (u x v), with u the vector part of q
  const CVector3 axis(rotation.GetX(), rotation.GetY(), rotation.GetZ());
  CVector3 cross = axis;
  cross.CrossProduct(*this);
  const Real w = rotation.GetW();
  const Real alongAxis = 2.0 * axis.DotProduct(*this);
  const Real keep = w * w - axis.SquareLength();
  Set(keep * m_x + alongAxis * axis.m_x + 2.0 * w * cross.m_x,
      keep * m_y + alongAxis * axis.m_y + 2.0 * w * cross.m_y,
      keep * m_z + alongAxis * axis.m_z + 2.0 * w * cross.m_z);
  return *this;
}

/** Writes the Euler angles in degrees, "z,y,x". */
std::ostream& operator<<(std::ostream& os, const CQuaternion& quaternion);

/**
 * Reads Euler angles in degrees, "z,y,x"; blanks around the numbers are allowed.
 *
 * @throws CARGoSException unless there are exactly three fields and all are numbers.
 */
std::istream& operator>>(std::istream& is, CQuaternion& quaternion);

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/matrix/rotationmatrix3.h>
#endif

#endif
