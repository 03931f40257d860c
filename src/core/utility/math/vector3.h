#ifndef ARGOS3_CORE_UTILITY_MATH_VECTOR3_H
#define ARGOS3_CORE_UTILITY_MATH_VECTOR3_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/general.h>
#include <argos3/core/utility/math/vector2.h>

#include <array>
#include <cmath>
#include <istream>
#include <ostream>

namespace argos {

class CQuaternion;

/** A vector or a point in space; three numbers, trivially copyable. */
class CVector3 {
 public:
  static const CVector3 X;
  static const CVector3 Y;
  static const CVector3 Z;
  static const CVector3 ZERO;

  constexpr CVector3() : m_x(0.0), m_y(0.0), m_z(0.0) {}
  constexpr CVector3(Real x, Real y, Real z) : m_x(x), m_y(y), m_z(z) {}
  constexpr CVector3(const std::array<Real, 3>& coordinates)
      : CVector3(coordinates[0], coordinates[1], coordinates[2]) {}

  /** See FromSphericalCoords(). */
  CVector3(Real length, const CRadians& inclination, const CRadians& azimuth) : CVector3() {
    FromSphericalCoords(length, inclination, azimuth);
  }

  constexpr Real GetX() const { return m_x; }
  constexpr void SetX(const Real x) { m_x = x; }
  constexpr Real GetY() const { return m_y; }
  constexpr void SetY(const Real y) { m_y = y; }
  constexpr Real GetZ() const { return m_z; }
  constexpr void SetZ(const Real z) { m_z = z; }

  constexpr void Set(const Real x, const Real y, const Real z) {
    m_x = x;
    m_y = y;
    m_z = z;
  }

  constexpr void Set(const std::array<Real, 3>& coordinates) {
    Set(coordinates[0], coordinates[1], coordinates[2]);
  }

  /** @param inclination from the z axis; @param azimuth from the x axis, counter-clockwise about z.
   */
  CVector3& FromSphericalCoords(Real length, const CRadians& inclination, const CRadians& azimuth) {
    const Real radius = length * Sin(inclination);
    Set(radius * Cos(azimuth), radius * Sin(azimuth), length * Cos(inclination));
    return *this;
  }

  /**
   * Computes a radius >= 0, an inclination in [0,PI] and an azimuth in [-PI,PI]; undetermined
   * angles are 0.
   */
  void ToSphericalCoords(Real& radius, CRadians& inclination, CRadians& azimuth) const;

  constexpr Real SquareLength() const { return m_x * m_x + m_y * m_y + m_z * m_z; }
  Real Length() const { return std::sqrt(SquareLength()); }

  /** Scales to length 1; the zero vector becomes NaN. */
  CVector3& Normalize() { return *this /= Length(); }

  /** Rotations about one axis, in place; positive angles are counter-clockwise when looking against
   * the axis. */
  CVector3& RotateX(const CRadians& angle) {
    Real sine = 0.0;
    Real cosine = 1.0;
    SinCos(angle, sine, cosine);
    Set(m_x, m_y * cosine - m_z * sine, m_y * sine + m_z * cosine);
    return *this;
  }

  CVector3& RotateY(const CRadians& angle) {
    Real sine = 0.0;
    Real cosine = 1.0;
    SinCos(angle, sine, cosine);
    Set(m_x * cosine + m_z * sine, m_y, m_z * cosine - m_x * sine);
    return *this;
  }

  CVector3& RotateZ(const CRadians& angle) {
    Real sine = 0.0;
    Real cosine = 1.0;
    SinCos(angle, sine, cosine);
    return RotateZ(CVector2(cosine, sine));
  }

  /** Rotates about z by the angle with the given (cosine,sine). */
  constexpr CVector3& RotateZ(const CVector2& cosineSine) {
    Set(m_x * cosineSine.GetX() - m_y * cosineSine.GetY(),
        m_x * cosineSine.GetY() + m_y * cosineSine.GetX(), m_z);
    return *this;
  }

  /**
   * Rotates by q v q*, in place; q must have length 1, see CQuaternion. Defined in quaternion.h.
   */
  inline CVector3& Rotate(const CQuaternion& rotation);

  /** Returns the angle between the two vectors, in [0,PI]; 0 if one of them is zero. */
  CRadians GetAngleWith(const CVector3& other) const;

  /** Returns atan2(z,y), the direction of the projection onto the yz plane. */
  CRadians GetXAngle() const { return ATan2(m_z, m_y); }

  /** Returns atan2(x,z), the direction of the projection onto the zx plane. */
  CRadians GetYAngle() const { return ATan2(m_x, m_z); }

  /** Returns atan2(y,x), the direction of the projection onto the xy plane. */
  CRadians GetZAngle() const { return ATan2(m_y, m_x); }

  constexpr Real DotProduct(const CVector3& other) const {
    return m_x * other.m_x + m_y * other.m_y + m_z * other.m_z;
  }

  /** Replaces this vector, in place, by the cross product this x other. */
  constexpr CVector3& CrossProduct(const CVector3& other) {
    Set(m_y * other.m_z - m_z * other.m_y, m_z * other.m_x - m_x * other.m_z,
        m_x * other.m_y - m_y * other.m_x);
    return *this;
  }

  /** Each sets and returns its argument. */
  constexpr CVector2& ProjectOntoXY(CVector2& projection) const {
    projection.Set(m_x, m_y);
    return projection;
  }

  constexpr CVector2& ProjectOntoYZ(CVector2& projection) const {
    projection.Set(m_y, m_z);
    return projection;
  }

  constexpr CVector2& ProjectOntoXZ(CVector2& projection) const {
    projection.Set(m_x, m_z);
    return projection;
  }

  constexpr CVector3& Negate() {
    Set(-m_x, -m_y, -m_z);
    return *this;
  }

  /** @throws CARGoSException if the index is not 0, 1 or 2. */
  constexpr Real operator[](UInt32 index) const {
    return index == 0 ? m_x : index == 1 ? m_y : index == 2 ? m_z : RejectIndex(index);
  }

  constexpr Real& operator[](UInt32 index) {
    return index == 0 ? m_x : index == 1 ? m_y : index == 2 ? m_z : RejectIndex(index);
  }

  /** Exact comparison. */
  constexpr bool operator==(const CVector3& other) const {
    return m_x == other.m_x && m_y == other.m_y && m_z == other.m_z;
  }

  constexpr bool operator!=(const CVector3& other) const { return !(*this == other); }

  /** True if it holds in every component: two vectors may be unordered. */
  constexpr bool operator<(const CVector3& other) const {
    return m_x < other.m_x && m_y < other.m_y && m_z < other.m_z;
  }

  constexpr bool operator<=(const CVector3& other) const {
    return m_x <= other.m_x && m_y <= other.m_y && m_z <= other.m_z;
  }

  constexpr bool operator>(const CVector3& other) const { return other < *this; }
  constexpr bool operator>=(const CVector3& other) const { return other <= *this; }

  constexpr CVector3 operator-() const { return CVector3(-m_x, -m_y, -m_z); }

  constexpr CVector3& operator+=(const CVector3& other) {
    Set(m_x + other.m_x, m_y + other.m_y, m_z + other.m_z);
    return *this;
  }

  constexpr CVector3& operator-=(const CVector3& other) {
    Set(m_x - other.m_x, m_y - other.m_y, m_z - other.m_z);
    return *this;
  }

  constexpr CVector3& operator*=(Real factor) {
    Set(m_x * factor, m_y * factor, m_z * factor);
    return *this;
  }

  constexpr CVector3& operator/=(Real divisor) {
    Set(m_x / divisor, m_y / divisor, m_z / divisor);
    return *this;
  }

  constexpr CVector3 operator+(const CVector3& other) const {
    return CVector3(m_x + other.m_x, m_y + other.m_y, m_z + other.m_z);
  }

  constexpr CVector3 operator-(const CVector3& other) const {
    return CVector3(m_x - other.m_x, m_y - other.m_y, m_z - other.m_z);
  }

  constexpr CVector3 operator*(Real factor) const {
    return CVector3(m_x * factor, m_y * factor, m_z * factor);
  }

  constexpr CVector3 operator/(const Real divisor) const {
    return CVector3(m_x / divisor, m_y / divisor, m_z / divisor);
  }

  /** Conversions to a row and a column; defined in matrix/matrix.h. */
  operator CMatrix<1, 3>() const;
  operator CMatrix<3, 1>() const;

 private:
  [[noreturn]] static Real& RejectIndex(UInt32 index);

  Real m_x;
  Real m_y;
  Real m_z;
};

inline constexpr CVector3 CVector3::X(1.0, 0.0, 0.0);
inline constexpr CVector3 CVector3::Y(0.0, 1.0, 0.0);
inline constexpr CVector3 CVector3::Z(0.0, 0.0, 1.0);
inline constexpr CVector3 CVector3::ZERO(0.0, 0.0, 0.0);

constexpr CVector3 operator*(Real factor, const CVector3& vector) {
  return vector * factor;
}

constexpr Real SquareDistance(const CVector3& a, const CVector3& b) {
  return (a - b).SquareLength();
}

inline Real Distance(const CVector3& a, const CVector3& b) {
  return (a - b).Length();
}

/** Writes "x,y,z". */
std::ostream& operator<<(std::ostream& os, const CVector3& vector);

/**
 * Reads "x,y,z"; blanks around the numbers are allowed.
 *
 * @throws CARGoSException unless there are exactly three fields and all are numbers.
 */
std::istream& operator>>(std::istream& is, CVector3& vector);

}  // namespace argos

#endif
