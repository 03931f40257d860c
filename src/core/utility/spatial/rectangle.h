#ifndef ARGOS3_CORE_UTILITY_SPATIAL_RECTANGLE_H
#define ARGOS3_CORE_UTILITY_SPATIAL_RECTANGLE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/planar_vector.h>

#include <algorithm>
#include <cmath>

/**
 * @file
 * Distances and extents of oriented rectangles in the plane.
 *
 * A RECTANGLE is any type with the members X, Y (centre, m), Cos, Sin (of its yaw) and HalfX, HalfY
 * (half its sides, m).
 */

namespace argos {

/** A vector of the world frame, in the frame of a rectangle. */
template <typename RECTANGLE>
SPlanarVector RotateIntoFrame(const RECTANGLE& rectangle, Real x, Real y) {
  return {rectangle.Cos * x + rectangle.Sin * y, rectangle.Cos * y - rectangle.Sin * x};
}

/** A vector of the frame of a rectangle, in the world frame. */
template <typename RECTANGLE>
SPlanarVector RotateOutOfFrame(const RECTANGLE& rectangle, Real x, Real y) {
  return {rectangle.Cos * x - rectangle.Sin * y, rectangle.Sin * x + rectangle.Cos * y};
}

/** Square of the distance of a point from a rectangle, m^2; 0 inside. */
template <typename RECTANGLE>
Real ComputeSquareDistance(const RECTANGLE& rectangle, Real x, Real y) {
  const SPlanarVector point = RotateIntoFrame(rectangle, x - rectangle.X, y - rectangle.Y);
  const Real outX = std::max(std::abs(point.X) - rectangle.HalfX, 0.0);
  const Real outY = std::max(std::abs(point.Y) - rectangle.HalfY, 0.0);
  return outX * outX + outY * outY;
}

/** Half the width of a rectangle along a direction of length 1, m. */
template <typename RECTANGLE>
Real ComputeHalfWidth(const RECTANGLE& rectangle, Real directionX, Real directionY) {
  const SPlanarVector direction = RotateIntoFrame(rectangle, directionX, directionY);
  return std::abs(direction.X) * rectangle.HalfX + std::abs(direction.Y) * rectangle.HalfY;
}

/** Half the sides of the axis-aligned rectangle around an oriented one, m. */
template <typename RECTANGLE>
SPlanarVector ComputeHalfBounds(const RECTANGLE& rectangle) {
  const Real cosine = std::abs(rectangle.Cos);
  const Real sine = std::abs(rectangle.Sin);
  return {cosine * rectangle.HalfX + sine * rectangle.HalfY,
          sine * rectangle.HalfX + cosine * rectangle.HalfY};
}

}  // namespace argos

#endif
