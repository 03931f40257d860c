#ifndef ARGOS3_TESTING_SUPPORT_POLYGONS_H
#define ARGOS3_TESTING_SUPPORT_POLYGONS_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector2.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos {

/** A regular polygon around the origin with a corner on the x axis. @param radius  to corners, m */
inline std::vector<CVector2> RegularPolygon(size_t corners, Real radius) {
  std::vector<CVector2> polygon;
  for (size_t i = 0; i < corners; ++i) {
    const Real angle = 2.0 * ARGOS_PI * static_cast<Real>(i) / static_cast<Real>(corners);
    polygon.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return polygon;
}

/** A rectangle around the origin, sides in m. */
inline std::vector<CVector2> RectanglePolygon(Real x, Real y) {
  return {CVector2(0.5 * x, 0.5 * y), CVector2(-0.5 * x, 0.5 * y), CVector2(-0.5 * x, -0.5 * y),
          CVector2(0.5 * x, -0.5 * y)};
}

/**
 * A convex polygon of 3 to 9 corners, on an ellipse with half axes of 0.2 to 1 times @p size.
 * @param uniform  Real(Real min, Real max): draws a number.
 */
template <typename UNIFORM>
std::vector<CVector2> RandomPolygon(Real size, UNIFORM&& uniform) {
  const auto corners = static_cast<size_t>(uniform(3.0, 9.999));
  const Real halfX = size * uniform(0.2, 1.0);
  const Real halfY = size * uniform(0.2, 1.0);
  const Real start = uniform(0.0, 2.0 * ARGOS_PI);
  std::vector<CVector2> polygon;
  for (size_t i = 0; i < corners; ++i) {
    // one corner in each sector
    const Real angle = start + 2.0 * ARGOS_PI * (static_cast<Real>(i) + uniform(0.1, 0.9)) /
                                   static_cast<Real>(corners);
    polygon.emplace_back(halfX * std::cos(angle), halfY * std::sin(angle));
  }
  return polygon;
}

}  // namespace argos

#endif
