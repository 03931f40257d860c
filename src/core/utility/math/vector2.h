#ifndef ARGOS3_CORE_UTILITY_MATH_VECTOR2_H
#define ARGOS3_CORE_UTILITY_MATH_VECTOR2_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/general.h>

#include <array>
#include <cmath>
#include <istream>
#include <ostream>

namespace argos {

template <UInt32 ROWS, UInt32 COLS>
class CMatrix;

/** A vector or a point in the plane; two numbers, trivially copyable. */
class CVector2 {
 public:
  static const CVector2 X;
  static const CVector2 Y;
  static const CVector2 ZERO;

  constexpr CVector2() : m_x(0.0), m_y(0.0) {}
  constexpr CVector2(Real x, Real y) : m_x(x), m_y(y) {}
  constexpr CVector2(const std::array<Real, 2>& coordinates)
      : CVector2(coordinates[0], coordinates[1]) {}

  /** Polar coordinates: the angle counts counter-clockwise from the x axis. */
  CVector2(Real length, const CRadians& angle)
      : CVector2(length * Cos(angle), length * Sin(angle)) {}

  constexpr Real GetX() const { return m_x; }
  constexpr void SetX(Real x) { m_x = x; }
  constexpr Real GetY() const { return m_y; }
  constexpr void SetY(Real y) { m_y = y; }

  constexpr void Set(Real x, Real y) {
    m_x = x;
    m_y = y;
  }

  constexpr void Set(const std::array<Real, 2>& coordinates) {
    Set(coordinates[0], coordinates[1]);
  }

  void FromPolarCoordinates(Real length, const CRadians& angle) { *this = CVector2(length, angle); }

  constexpr Real SquareLength() const { return m_x * m_x + m_y * m_y; }
  Real Length() const { return std::sqrt(SquareLength()); }

  /** Scales to length 1; the zero vector becomes NaN. */
  CVector2& Normalize() { return *this /= Length(); }

  /** Returns the direction in [-PI,PI], counter-clockwise from the x axis; 0 for the zero vector.
   */
  CRadians Angle() const { return *this == CVector2() ? CRadians() : ATan2(m_y, m_x); }

  /** Rotates counter-clockwise, in place. */
  CVector2& Rotate(const CRadians& angle) {
    Real sine = 0.0;
    Real cosine = 1.0;
    SinCos(angle, sine, cosine);
    Set(m_x * cosine - m_y * sine, m_x * sine + m_y * cosine);
    return *this;
  }

  constexpr Real DotProduct(const CVector2& other) const {
    return m_x * other.m_x + m_y * other.m_y;
  }

  /** Returns the z component of the cross product this x other. */
  constexpr Real CrossProduct(const CVector2& other) const {
    return m_x * other.m_y - m_y * other.m_x;
  }

  constexpr CVector2& Scale(Real scaleX, Real scaleY) {
    Set(m_x * scaleX, m_y * scaleY);
    return *this;
  }

  /** Turns by a quarter counter-clockwise, in place: (x,y) becomes (-y,x). */
  constexpr CVector2& Perpendicularize() {
    Set(-m_y, m_x);
    return *this;
  }

  /** Replaces the coordinates by their magnitudes. */
  CVector2& Absolute() {
    Set(std::fabs(m_x), std::fabs(m_y));
    return *this;
  }

  /** Exact comparison. */
  constexpr bool operator==(const CVector2& other) const {
    return m_x == other.m_x && m_y == other.m_y;
  }
  constexpr bool operator!=(const CVector2& other) const { return !(*this == other); }

  constexpr CVector2& operator+=(const CVector2& other) {
    Set(m_x + other.m_x, m_y + other.m_y);
    return *this;
  }

  constexpr CVector2& operator-=(const CVector2& other) {
    Set(m_x - other.m_x, m_y - other.m_y);
    return *this;
  }

  constexpr CVector2& operator*=(Real factor) {
    Set(m_x * factor, m_y * factor);
    return *this;
  }

  constexpr CVector2& operator/=(Real divisor) {
    Set(m_x / divisor, m_y / divisor);
    return *this;
  }

  constexpr CVector2 operator+(const CVector2& other) const {
    return CVector2(m_x + other.m_x, m_y + other.m_y);
  }
  constexpr CVector2 operator-(const CVector2& other) const {
    return CVector2(m_x - other.m_x, m_y - other.m_y);
  }
  constexpr CVector2 operator*(Real factor) const { return CVector2(m_x * factor, m_y * factor); }
  constexpr CVector2 operator/(Real divisor) const {
    return CVector2(m_x / divisor, m_y / divisor);
  }
  constexpr CVector2 operator-() const { return CVector2(-m_x, -m_y); }

  /** Conversions to a row and a column; defined in matrix/matrix.h. */
  operator CMatrix<1, 2>() const;
  operator CMatrix<2, 1>() const;

 private:
  Real m_x;
  Real m_y;
};

inline constexpr CVector2 CVector2::X(1.0, 0.0);
inline constexpr CVector2 CVector2::Y(0.0, 1.0);
inline constexpr CVector2 CVector2::ZERO(0.0, 0.0);

constexpr CVector2 operator*(Real factor, const CVector2& vector) {
  return vector * factor;
}

constexpr Real SquareDistance(const CVector2& a, const CVector2& b) {
  return (a - b).SquareLength();
}

inline Real Distance(const CVector2& a, const CVector2& b) {
  return (a - b).Length();
}

/** Writes "x,y". */
std::ostream& operator<<(std::ostream& os, const CVector2& vector);

/**
 * Reads "x,y"; blanks around the numbers are allowed.
 *
 * @throws CARGoSException unless there are exactly two fields and both are numbers.
 */
std::istream& operator>>(std::istream& is, CVector2& vector);

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/utility/math/matrix/matrix.h>
#endif

#endif
