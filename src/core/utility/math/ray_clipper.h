#ifndef ARGOS3_CORE_UTILITY_MATH_RAY_CLIPPER_H
#define ARGOS3_CORE_UTILITY_MATH_RAY_CLIPPER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

/**
 * Clips the line start + t direction to a convex solid, one pair of bounds after the other.
 *
 * Touching counts as inside. Method: T. Kay and J. Kajiya, "Ray tracing complex scenes", SIGGRAPH
 * 1986.
 */
class CRayClipper {
 public:
  /** Keeps the part with min <= start + t direction <= max, all coordinates along one axis. */
  void ClipToSlab(Real start, Real direction, Real min, Real max);

  /** Keeps the part with a distance of (x,y) from the origin of at most radius. */
  void ClipToDisc(Real startX, Real startY, Real directionX, Real directionY, Real radius);

  /**
   * @return true if a part with t >= 0 is left.
   *
   * @param t  set on success to the smallest such t; 0 if the start is inside. May exceed 1.
   */
  bool GetFirst(Real& t) const;

 private:
  void Keep(Real first, Real last);
  void KeepNothing() { m_last = -std::numeric_limits<Real>::infinity(); }

  Real m_first = -std::numeric_limits<Real>::infinity();
  Real m_last = std::numeric_limits<Real>::infinity();
};

}  // namespace argos

#endif
