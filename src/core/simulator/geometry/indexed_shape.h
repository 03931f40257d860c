#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_INDEXED_SHAPE_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_INDEXED_SHAPE_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/ray_span.h>
#include <argos3/core/utility/spatial/rectangle.h>

namespace argos {

/**
 * One solid of one body, as a sensor tests it: an upright prism over a disc or a rectangle.
 *
 * Solids of other shapes, and those that do not stand upright, have Kind Bounds: their numbers are
 * those of an upright cylinder that contains them, and the exact test needs their body
 * (CBodyIndex::Intersect()).
 */
struct SIndexedShape {
  enum class EKind : UInt16 { Disc, Box, Bounds };

  Real X, Y; /**< centre of the footprint, m, world frame */
  Real Cos, Sin; /**< cosine and sine of the yaw of a box */
  Real HalfX, HalfY; /**< half extents of a box, m; of a disc: its radius */
  Real Radius; /**< radius of the circle around the footprint, m */
  Real ZMin, ZMax; /**< height span, m, world frame */
  UInt32 Body; /**< number of the body in the index */
  UInt16 Shape; /**< index of the solid in the body's description */
  EKind Kind;
};

/** @return the image of a solid that is displaced by (@p dx, @p dy), m. */
inline SIndexedShape Displace(SIndexedShape shape, Real dx, Real dy) {
  shape.X += dx;
  shape.Y += dy;
  return shape;
}

/**
 * A solid as the index stores it: all data of a disc, in less memory than an SIndexedShape; boxes
 * have their sides elsewhere.
 */
struct SPackedShape {
  Real X, Y, Radius, ZMin, ZMax; /**< members of SIndexedShape */
  UInt32 Body;
  UInt16 Shape;
  SIndexedShape::EKind Kind;
};
static_assert(sizeof(SPackedShape) == 48, "four of them are three cache lines");

/** The rest of a solid of Kind Box, as of SIndexedShape. */
struct SBoxSides {
  Real Cos = 1.0, Sin = 0.0;
  Real HalfX = 0.0, HalfY = 0.0;
};

/**
 * The part of the line (ox, oy) + t (dx, dy) over the footprint of an upright solid.
 * @param ox, oy  start of the ray, m, world frame.
 * @param dx, dy  from start to end, m.
 */
inline SRaySpan IntersectFootprint(const SIndexedShape& shape, Real ox, Real oy, Real dx, Real dy) {
  const Real px = ox - shape.X;
  const Real py = oy - shape.Y;
  if (shape.Kind == SIndexedShape::EKind::Disc) {
    return FindNegative(dx * dx + dy * dy, px * dx + py * dy,
                        px * px + py * py - shape.HalfX * shape.HalfX);
  }
  const SPlanarVector start = RotateIntoFrame(shape, px, py);
  const SPlanarVector direction = RotateIntoFrame(shape, dx, dy);
  SRaySpan span;
  span.ClipAround(start.X, direction.X, shape.HalfX);
  span.ClipAround(start.Y, direction.Y, shape.HalfY);
  return span;
}

/**
 * Where a horizontal ray enters an upright solid.
 * @param oz  height of the ray, m.
 * @return fraction of the ray's length in [0,1], 0 if it starts inside; kNoHit if it misses.
 */
inline Real IntersectHorizontalRay(const SIndexedShape& shape, Real ox, Real oy, Real oz, Real dx,
                                   Real dy) {
  if (oz < shape.ZMin || oz > shape.ZMax) {
    return kNoHit;
  }
  return IntersectFootprint(shape, ox, oy, dx, dy).FindEntry();
}

/** The same for any ray: through the sides, the top or the bottom. */
inline Real IntersectRay(const SIndexedShape& shape, const CRay3& ray) {
  const CVector3& start = ray.GetStart();
  const CVector3 d = ray.GetEnd() - start;
  SRaySpan span = IntersectFootprint(shape, start.GetX(), start.GetY(), d.GetX(), d.GetY());
  span.ClipToSlab(start.GetZ(), d.GetZ(), shape.ZMin, shape.ZMax);
  return span.FindEntry();
}

}  // namespace argos

#endif
