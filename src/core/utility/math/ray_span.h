#ifndef ARGOS3_CORE_UTILITY_MATH_RAY_SPAN_H
#define ARGOS3_CORE_UTILITY_MATH_RAY_SPAN_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <algorithm>
#include <cmath>

namespace argos {

/** Fraction of a ray's length that stands for "the ray hits nothing"; any number above 1 would do.
 */
constexpr Real kNoHit = 2.0;

/**
 * Part of a line, between two fractions of the length of a ray on it; empty if First > Last.
 *
 * Starts as the whole line. The part inside a convex solid is what remains after the line was
 * clipped to each pair of the solid's bounds.
 * Source: T. Kay and J. Kajiya, "Ray tracing complex scenes", SIGGRAPH 1986.
 */
struct SRaySpan {
  Real First = -HUGE_VAL;
  Real Last = HUGE_VAL;

  static constexpr SRaySpan None() { return {1.0, 0.0}; }

  bool IsEmpty() const { return First > Last; }
  /** Keeps what is between two fractions, given in any order. */
  void Clip(Real a, Real b) {
    First = std::max(First, std::min(a, b));
    Last = std::min(Last, std::max(a, b));
  }
  /**
   * Keeps the part where low <= start + t direction <= high, ends included.
   * @param start, direction  coordinates of the ray along one axis.
   */
  void ClipToSlab(Real start, Real direction, Real low, Real high) {
    if (direction != 0.0) {
      Clip((low - start) / direction, (high - start) / direction);
    } else if (!(low <= start && start <= high)) {
      *this = None();
    }
  }
  /**
   * Keeps the part where -half <= start + t direction <= half, ends included. Needs one division
   * where ClipToSlab() needs two, and rounds twice where that rounds once.
   */
  void ClipAround(Real start, Real direction, Real half) {
    if (direction != 0.0) {
      const Real inverse = 1.0 / direction;
      Clip((-half - start) * inverse, (half - start) * inverse);
    } else if (std::abs(start) > half) {
      *this = None();
    }
  }
  /**
   * @return false if the part is empty or behind the start.
   * @param t  set otherwise: the first place that is not behind the start; it may be above 1.
   */
  bool FindFirst(Real& t) const {
    if (IsEmpty() || Last < 0.0) {
      return false;
    }
    t = First > 0.0 ? First : 0.0;
    return true;
  }
  /**
   * Where a ray enters the part.
   * @return fraction in [0,1], 0 if the ray starts inside; kNoHit if the part is empty, behind the
   *         start, or beyond the end.
   */
  Real FindEntry() const {
    Real t = 0.0;
    return FindFirst(t) && t <= 1.0 ? t : kNoHit;
  }
};

/**
 * Where a t^2 + 2 b t + c <= 0: inside a disc or sphere, for a ray p + t d and a radius r with
 * a = d.d, b = p.d and c = p.p - r^2.
 *
 * Fast. The result loses digits if the start is many radii away, see ClipToDisc().
 */
inline SRaySpan FindNegative(Real a, Real b, Real c) {
  if (a == 0.0) {
    return c <= 0.0 ? SRaySpan() : SRaySpan::None();
  }
  const Real discriminant = b * b - a * c;
  if (discriminant < 0.0) {
    return SRaySpan::None();
  }
  const Real root = std::sqrt(discriminant);
  return {(-b - root) / a, (-b + root) / a};
}

/**
 * Keeps the part of a span where the distance of start + t direction from the origin is at most
 * @p radius; exact to rounding also if the start is far away.
 * Source: W. Press et al., Numerical Recipes, section 5.6.
 */
void ClipToDisc(SRaySpan& span, Real startX, Real startY, Real directionX, Real directionY,
                Real radius);

/**
 * False if a circle around (@p x, @p y) does not meet the infinite line through the origin along
 * (@p dx, @p dy).
 * @param squareRadius  of the circle.
 * @param squareLength  of (dx, dy); a little more makes the test tolerant.
 */
inline bool IsCircleOnLine(Real x, Real y, Real dx, Real dy, Real squareRadius, Real squareLength) {
  const Real cross = x * dy - y * dx;
  return !(cross * cross > squareRadius * squareLength);
}

}  // namespace argos

#endif
