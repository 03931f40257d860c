#ifndef ARGOS3_CORE_UTILITY_MATH_ANGLES_H
#define ARGOS3_CORE_UTILITY_MATH_ANGLES_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/general.h>
#include <argos3/core/utility/math/range.h>

#include <cmath>
#include <istream>
#include <ostream>

// The small maths types (angles, ranges, vectors, quaternions) are plain structures of Real without
// Eigen, for two reasons: their constants must exist before static initialisers in user code run,
// which requires constexpr constructors; and much of the code base includes them, so they must
// compile fast. Linear algebra (matrices, rotations between vectors) uses Eigen in the matrix
// headers and in sources; see eigen_bridge.h.

/** The ratio of a circle's circumference to its diameter. */
#define ARGOS_PI 3.14159265358979323846

/** The C functions for Real. */
#define ARGOS_SIN ::sin
#define ARGOS_COS ::cos
#define ARGOS_TAN ::tan
#define ARGOS_ASIN ::asin
#define ARGOS_ACOS ::acos
#define ARGOS_ATAN2 ::atan2
#ifdef __GLIBC__
#define ARGOS_SINCOS ::sincos
#else
#define ARGOS_SINCOS ::argos::ComputeSinCos
#endif

namespace argos {

/** Sets *sine and *cosine of an angle in radians: sincos() for C libraries without it. */
inline void ComputeSinCos(Real radians, Real* sine, Real* cosine) {
  *sine = ::sin(radians);
  *cosine = ::cos(radians);
}

/**
 * Base of both angle types: arithmetic, comparison and normalisation of one number.
 *
 * @tparam ANGLE  CRadians or CDegrees. Only ToDegrees() and ToRadians() convert between them.
 */
template <typename ANGLE>
class CAngleBase {
 public:
  constexpr CAngleBase() : m_value(0.0) {}

  constexpr explicit CAngleBase(Real value) : m_value(value) {}

  constexpr Real GetValue() const { return m_value; }

  constexpr Real GetAbsoluteValue() const { return m_value < 0.0 ? -m_value : m_value; }

  constexpr void SetValue(Real value) { m_value = value; }

  /**
   * Wraps the angle into [-half a turn, half a turn] by adding or subtracting whole turns; both
   * bounds stay unchanged. Takes bounded time for any value; an infinite one becomes NaN.
   */
  ANGLE& SignedNormalize() {
    m_value =
        math_detail::WrapReal(m_value, -ANGLE::kHalfTurn, ANGLE::kHalfTurn, 2.0 * ANGLE::kHalfTurn);
    return Self();
  }

  /** Wraps the angle into [0, one turn] like SignedNormalize(). */
  ANGLE& UnsignedNormalize() {
    m_value = math_detail::WrapReal(m_value, 0.0, 2.0 * ANGLE::kHalfTurn, 2.0 * ANGLE::kHalfTurn);
    return Self();
  }

  constexpr ANGLE& operator+() { return Self(); }
  constexpr ANGLE operator-() const { return ANGLE(-m_value); }

  constexpr ANGLE& operator+=(const ANGLE& other) {
    m_value += other.GetValue();
    return Self();
  }

  constexpr ANGLE& operator-=(const ANGLE& other) {
    m_value -= other.GetValue();
    return Self();
  }

  constexpr ANGLE& operator*=(Real factor) {
    m_value *= factor;
    return Self();
  }

  constexpr ANGLE& operator/=(Real divisor) {
    m_value /= divisor;
    return Self();
  }

  constexpr ANGLE operator+(const ANGLE& other) const { return ANGLE(m_value + other.GetValue()); }
  constexpr ANGLE operator-(const ANGLE& other) const { return ANGLE(m_value - other.GetValue()); }
  constexpr ANGLE operator*(Real factor) const { return ANGLE(m_value * factor); }
  constexpr ANGLE operator/(Real divisor) const { return ANGLE(m_value / divisor); }

  /** Returns the ratio of two angles. */
  constexpr Real operator/(const ANGLE& other) const { return m_value / other.GetValue(); }

  constexpr bool operator<(const ANGLE& other) const { return m_value < other.GetValue(); }
  constexpr bool operator<=(const ANGLE& other) const { return m_value <= other.GetValue(); }
  constexpr bool operator>(const ANGLE& other) const { return m_value > other.GetValue(); }
  constexpr bool operator>=(const ANGLE& other) const { return m_value >= other.GetValue(); }

  // friends, because in C++20 a member of the base would be ambiguous with its own reversed form
  friend constexpr bool operator==(const ANGLE& a, const ANGLE& b) {
    return a.GetValue() == b.GetValue();
  }
  friend constexpr bool operator!=(const ANGLE& a, const ANGLE& b) {
    return a.GetValue() != b.GetValue();
  }

 protected:
  Real m_value;

 private:
  constexpr ANGLE& Self() { return static_cast<ANGLE&>(*this); }
};

/** An angle in radians. */
class CRadians : public CAngleBase<CRadians> {
 public:
  static const CRadians PI;
  static const CRadians TWO_PI;
  static const CRadians PI_OVER_TWO;
  static const CRadians PI_OVER_THREE;
  static const CRadians PI_OVER_FOUR;
  static const CRadians PI_OVER_SIX;
  static const CRadians ZERO;

  /** [-PI, PI] */
  static const CRange<CRadians> SIGNED_RANGE;

  /** [0, 2 PI] */
  static const CRange<CRadians> UNSIGNED_RANGE;

  static const Real RADIANS_TO_DEGREES;

  constexpr CRadians() = default;

  constexpr explicit CRadians(Real value) : CAngleBase<CRadians>(value) {}

  constexpr void FromValueInDegrees(Real degrees) { m_value = degrees * (ARGOS_PI / 180.0); }

  constexpr CRadians& Negate() {
    m_value = -m_value;
    return *this;
  }

 private:
  friend class CAngleBase<CRadians>;

  static constexpr Real kHalfTurn = ARGOS_PI;
};

// constant-initialised: part of the program's image, without initialisation at run time
inline constexpr CRadians CRadians::PI(ARGOS_PI);
inline constexpr CRadians CRadians::TWO_PI(2.0 * ARGOS_PI);
inline constexpr CRadians CRadians::PI_OVER_TWO(ARGOS_PI / 2.0);
inline constexpr CRadians CRadians::PI_OVER_THREE(ARGOS_PI / 3.0);
inline constexpr CRadians CRadians::PI_OVER_FOUR(ARGOS_PI / 4.0);
inline constexpr CRadians CRadians::PI_OVER_SIX(ARGOS_PI / 6.0);
inline constexpr CRadians CRadians::ZERO(0.0);
inline constexpr CRange<CRadians> CRadians::SIGNED_RANGE(CRadians(-ARGOS_PI), CRadians(ARGOS_PI));
inline constexpr CRange<CRadians> CRadians::UNSIGNED_RANGE(CRadians(0.0), CRadians(2.0 * ARGOS_PI));
inline constexpr Real CRadians::RADIANS_TO_DEGREES = 180.0 / ARGOS_PI;

/** An angle in degrees. */
class CDegrees : public CAngleBase<CDegrees> {
 public:
  constexpr CDegrees() = default;

  constexpr explicit CDegrees(Real value) : CAngleBase<CDegrees>(value) {}

  constexpr void FromValueInRadians(Real radians) {
    m_value = radians * CRadians::RADIANS_TO_DEGREES;
  }

 private:
  friend class CAngleBase<CDegrees>;

  static constexpr Real kHalfTurn = 180.0;
};

constexpr CRadians operator*(Real factor, const CRadians& angle) {
  return angle * factor;
}
constexpr CDegrees operator*(Real factor, const CDegrees& angle) {
  return angle * factor;
}

constexpr CDegrees ToDegrees(const CRadians& angle) {
  return CDegrees(angle.GetValue() * CRadians::RADIANS_TO_DEGREES);
}

constexpr CRadians ToRadians(const CDegrees& angle) {
  return CRadians(angle.GetValue() * (ARGOS_PI / 180.0));
}

/** Returns a - b wrapped into [-PI, PI). */
inline CRadians NormalizedDifference(const CRadians& a, const CRadians& b) {
  const CRadians difference = (a - b).SignedNormalize();
  return difference == CRadians::PI ? -CRadians::PI : difference;
}

/** Returns a - b wrapped into [-180, 180). */
inline CDegrees NormalizedDifference(const CDegrees& a, const CDegrees& b) {
  const CDegrees difference = (a - b).SignedNormalize();
  return difference == CDegrees(180.0) ? CDegrees(-180.0) : difference;
}

inline void SinCos(const CRadians& angle, Real& sine, Real& cosine) {
  ARGOS_SINCOS(angle.GetValue(), &sine, &cosine);
}

inline Real Sin(const CRadians& angle) {
  return ARGOS_SIN(angle.GetValue());
}
inline Real Cos(const CRadians& angle) {
  return ARGOS_COS(angle.GetValue());
}
inline Real Tan(const CRadians& angle) {
  return ARGOS_TAN(angle.GetValue());
}

/** Returns the angle in [-PI/2, PI/2] with the given sine; NaN outside [-1,1]. */
inline CRadians ASin(Real sine) {
  return CRadians(ARGOS_ASIN(sine));
}

/** Returns the angle in [0, PI] with the given cosine; NaN outside [-1,1]. */
inline CRadians ACos(Real cosine) {
  return CRadians(ARGOS_ACOS(cosine));
}

/** Returns the direction of the vector (x,y), in [-PI, PI], counter-clockwise from the x axis. */
inline CRadians ATan2(const Real y, const Real x) {
  return CRadians(ARGOS_ATAN2(y, x));
}

/** Writes "CRadians(<radians> -> <degrees> degrees)". */
std::ostream& operator<<(std::ostream& os, const CRadians& angle);

/** Reads a bare number, in radians. */
std::istream& operator>>(std::istream& is, CRadians& angle);

/** Writes "CDegrees(<degrees>)". */
std::ostream& operator<<(std::ostream& os, const CDegrees& angle);

/** Reads a bare number, in degrees. */
std::istream& operator>>(std::istream& is, CDegrees& angle);

}  // namespace argos

#endif
