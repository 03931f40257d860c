#ifndef ARGOS3_CORE_SIMULATOR_SPACE_INDEXED_SHAPE_H
#define ARGOS3_CORE_SIMULATOR_SPACE_INDEXED_SHAPE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/ray3.h>

#include <algorithm>
#include <cmath>

namespace argos {

/**
 * One solid of one body, as a sensor tests it: an upright prism over a disc or a rectangle.
 *
 * Solids that do not stand upright have Kind Tilted: their numbers bound them, and the exact test
 * goes through their body (CBodyIndex::IntersectTilted()).
 */
struct SIndexedShape {
  enum class EKind : UInt16 { Disc, Box, Tilted };

  Real X, Y; /**< centre of the footprint, m, world frame */
  Real Cos, Sin; /**< of the yaw of a box */
  Real HalfX, HalfY; /**< half extents of a box, m; of a disc: its radius */
  Real Radius; /**< of the circle around the footprint, m */
  Real ZMin, ZMax; /**< height span, m, world frame */
  UInt32 Body; /**< number of the body in the index */
  UInt16 Shape; /**< which solid of the body's description */
  EKind Kind;
};

/** Part of a ray, in fractions of its length; empty if First > Last. */
struct SRaySpan {
  Real First, Last;
};

/**
 * The part of the line (ox, oy) + t (dx, dy) over the footprint of an upright solid.
 * @param ox, oy  start of the ray, m, world frame.
 * @param dx, dy  from start to end, m.
 */
inline SRaySpan IntersectFootprint(const SIndexedShape& shape, Real ox, Real oy, Real dx, Real dy) {
  constexpr SRaySpan kNone = {1.0, 0.0};
  constexpr SRaySpan kAll = {-HUGE_VAL, HUGE_VAL};
  const Real px = ox - shape.X;
  const Real py = oy - shape.Y;
  if (shape.Kind == SIndexedShape::EKind::Disc) {
    // |p + t d|^2 = r^2, with the half-b form of the quadratic
    const Real a = dx * dx + dy * dy;
    const Real c = px * px + py * py - shape.HalfX * shape.HalfX;
    if (a == 0.0) {
      return c <= 0.0 ? kAll : kNone;
    }
    const Real b = px * dx + py * dy;
    const Real discriminant = b * b - a * c;
    if (discriminant < 0.0) {
      return kNone;
    }
    const Real root = std::sqrt(discriminant);
    return {(-b - root) / a, (-b + root) / a};
  }
  // slabs, in the frame of the box
  const Real localP[2] = {shape.Cos * px + shape.Sin * py, shape.Cos * py - shape.Sin * px};
  const Real localD[2] = {shape.Cos * dx + shape.Sin * dy, shape.Cos * dy - shape.Sin * dx};
  const Real half[2] = {shape.HalfX, shape.HalfY};
  SRaySpan span = kAll;
  for (int axis = 0; axis < 2; ++axis) {
    if (localD[axis] == 0.0) {
      if (std::abs(localP[axis]) > half[axis]) {
        return kNone;
      }
      continue;
    }
    const Real inverse = 1.0 / localD[axis];
    const Real t1 = (-half[axis] - localP[axis]) * inverse;
    const Real t2 = (half[axis] - localP[axis]) * inverse;
    span.First = std::max(span.First, std::min(t1, t2));
    span.Last = std::min(span.Last, std::max(t1, t2));
  }
  return span;
}

/**
 * Where a horizontal ray enters an upright solid.
 * @param oz  height of the ray, m.
 * @return fraction of the ray's length in [0,1], 0 if it starts inside; more than 1 if it misses.
 */
inline Real IntersectHorizontalRay(const SIndexedShape& shape, Real ox, Real oy, Real oz, Real dx,
                                   Real dy) {
  constexpr Real kMiss = 2.0;
  if (oz < shape.ZMin || oz > shape.ZMax) {
    return kMiss;
  }
  const SRaySpan span = IntersectFootprint(shape, ox, oy, dx, dy);
  if (span.First > span.Last || span.Last < 0.0 || span.First > 1.0) {
    return kMiss;
  }
  return span.First > 0.0 ? span.First : 0.0;
}

/** The same for any ray: through the sides, the top or the bottom. */
inline Real IntersectRay(const SIndexedShape& shape, const CRay3& ray) {
  constexpr Real kMiss = 2.0;
  const CVector3& start = ray.GetStart();
  const CVector3 d = ray.GetEnd() - start;
  SRaySpan span = IntersectFootprint(shape, start.GetX(), start.GetY(), d.GetX(), d.GetY());
  if (d.GetZ() == 0.0) {
    if (start.GetZ() < shape.ZMin || start.GetZ() > shape.ZMax) {
      return kMiss;
    }
  } else {
    const Real t1 = (shape.ZMin - start.GetZ()) / d.GetZ();
    const Real t2 = (shape.ZMax - start.GetZ()) / d.GetZ();
    span.First = std::max(span.First, std::min(t1, t2));
    span.Last = std::min(span.Last, std::max(t1, t2));
  }
  if (span.First > span.Last || span.Last < 0.0 || span.First > 1.0) {
    return kMiss;
  }
  return span.First > 0.0 ? span.First : 0.0;
}

}  // namespace argos

#endif
