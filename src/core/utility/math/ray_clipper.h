#ifndef ARGOS3_CORE_UTILITY_MATH_RAY_CLIPPER_H
#define ARGOS3_CORE_UTILITY_MATH_RAY_CLIPPER_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <limits>

namespace argos {

/**
 * Cuts the line start + t direction down to the part that lies in a convex solid, one pair of
 * bounds after the other.
 *
 * Touching counts as being inside. Method: T. Kay and J. Kajiya, "Ray tracing complex scenes",
 * SIGGRAPH 1986.
 */
class CRayClipper {
 public:
  /** Keeps the part where min <= start + t direction <= max, all being coordinates along one axis.
   */
  void ClipToSlab(Real start, Real direction, Real min, Real max);

  /** Keeps the part where the distance of (x,y) from the origin is at most radius. */
  void ClipToDisc(Real startX, Real startY, Real directionX, Real directionY, Real radius);

  /**
   * Says whether something is left that is not behind the start.
   *
   * @param t  set, if so, to the first such place; 0 if the start itself is inside. It may be
   * greater than 1.
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
