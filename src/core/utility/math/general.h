#ifndef ARGOS3_CORE_UTILITY_MATH_GENERAL_H
#define ARGOS3_CORE_UTILITY_MATH_GENERAL_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace argos {

/**
 * Returns the magnitude of a value.
 *
 * Works for every T with T(0), <, > and unary minus, including CRadians and CDegrees.
 */
template <typename T>
constexpr T Abs(const T& value) {
  if (value > T(0)) {
    return value;
  }
  return value < T(0) ? -value : T(0);
}

constexpr SInt32 Abs(SInt32 value) {
  return value < 0 ? -value : value;
}

inline Real Abs(Real value) {
  return std::fabs(value);
}

/** Returns the smaller of two values, the first one when they are equal. */
template <typename T>
constexpr T Min(const T& a, const T& b) {
  return b < a ? b : a;
}

/** Returns a reference to the smaller of two variables, to the first one when they are equal. */
template <typename T>
constexpr T& Min(T& a, T& b) {
  return b < a ? b : a;
}

/** Returns the larger of two values, the first one when they are equal. */
template <typename T>
constexpr T Max(const T& a, const T& b) {
  return a < b ? b : a;
}

/** Returns a reference to the larger of two variables, to the first one when they are equal. */
template <typename T>
constexpr T& Max(T& a, T& b) {
  return a < b ? b : a;
}

/** Returns -1, 0 or 1. */
template <typename T>
constexpr SInt32 Sign(const T& value) {
  if (value > T(0)) {
    return 1;
  }
  return value < T(0) ? -1 : 0;
}

template <typename T>
constexpr T Square(const T& value) {
  return value * value;
}

namespace math_detail {

/** Drops the fractional part. Values outside SInt32 give its nearest bound, NaN gives 0. */
constexpr SInt32 Truncate(Real value) {
  constexpr SInt32 kLowest = std::numeric_limits<SInt32>::min();
  constexpr SInt32 kHighest = std::numeric_limits<SInt32>::max();
  if (value >= static_cast<Real>(kHighest)) {
    return kHighest;
  }
  if (value <= static_cast<Real>(kLowest)) {
    return kLowest;
  }
  return value == value ? static_cast<SInt32>(value) : 0;
}

}  // namespace math_detail

/**
 * Truncates, and subtracts one from negative values. A negative whole number is therefore
 * decremented too: Floor(-2.0) is -3. User code relies on this; use std::floor() for the
 * mathematical function. Values outside the range of SInt32 give its bounds.
 */
constexpr SInt32 Floor(Real value) {
  const SInt32 truncated = math_detail::Truncate(value);
  return value < 0.0 && truncated > std::numeric_limits<SInt32>::min() ? truncated - 1 : truncated;
}

/** Returns the smallest integer that is not less than the value, bounded by the range of SInt32. */
constexpr SInt32 Ceil(Real value) {
  const SInt32 truncated = math_detail::Truncate(value);
  const bool hasNext = truncated < std::numeric_limits<SInt32>::max();
  return static_cast<Real>(truncated) < value && hasNext ? truncated + 1 : truncated;
}

/** Returns the nearest integer, halves away from zero, bounded by the range of SInt32. */
inline SInt32 Round(Real value) {
  return math_detail::Truncate(std::round(value));
}

/** Drops the fractional part: the floor of positive values and the ceiling of the others. */
constexpr SInt32 RoundClosestToZero(Real value) {
  return math_detail::Truncate(value);
}

/** @return |a - b| <= epsilon * max(1, |a|, |b|); epsilon must be >= 0. */
inline bool DoubleEqAbsolute(Real a, Real b, Real epsilon) {
  const Real scale = std::fmax(1.0, std::fmax(std::fabs(a), std::fabs(b)));
  return std::fabs(a - b) <= epsilon * scale;
}

/** DoubleEqAbsolute() with an epsilon of 1e-4. */
inline bool DoubleEq(Real a, Real b) {
  return DoubleEqAbsolute(a, b, 1e-4);
}

/**
 * Evaluates the piecewise linear function through the given points.
 *
 * @param x       argument; outside the points, the first or last segment is extended.
 * @param points  at least two pairs (x, y), sorted by increasing x. Two inner points with equal x
 * make a step, which belongs to its right side.
 * @throws CARGoSException if there are fewer than two points, or if the segment needed has no
 * width.
 */
Real Interpolate(Real x, const std::vector<std::pair<Real, Real> >& points);

/** Natural logarithm. */
inline Real Log(Real value) {
  return std::log(value);
}

/** Square root. */
inline Real Sqrt(Real value) {
  return std::sqrt(value);
}

/** Exponential function. */
inline Real Exp(Real value) {
  return std::exp(value);
}

/** Remainder of value / divisor, with the sign of value. */
inline Real Mod(Real value, Real divisor) {
  return std::fmod(value, divisor);
}

}  // namespace argos

// user code calls these functions unqualified
using argos::Exp;
using argos::Log;
using argos::Mod;
using argos::Sqrt;

#endif
