#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_FOOTPRINTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_FOOTPRINTS_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/core/utility/spatial/rectangle.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos {

/**
 * The projection of a solid on the ground: a disc, an oriented rectangle or a convex polygon; m,
 * world frame.
 */
struct SFootprint {
  Real X, Y;
  Real Cos, Sin;  // of the yaw of a rectangle or polygon
  Real HalfX, HalfY;  // of a rectangle, or of that around a polygon; both 0 for a disc
  Real Radius;  // of a disc; else 0
  // of a polygon, in its frame; of the description, which must stay valid; else null
  const std::vector<CVector2>* Polygon = nullptr;
};

/**
 * Distance of a point from a footprint, m; 0 inside. Of a polygon: from the rectangle around it,
 * which is no farther.
 */
inline Real ComputeDistance(const SFootprint& footprint, Real x, Real y) {
  return std::max(0.0, std::sqrt(ComputeSquareDistance(footprint, x, y)) - footprint.Radius);
}

/** @return the image of a footprint that is displaced by (@p dx, @p dy), m. */
inline SFootprint Displace(SFootprint footprint, Real dx, Real dy) {
  footprint.X += dx;
  footprint.Y += dy;
  return footprint;
}

/** @return the displacement of the image of a place that is nearest to another one, m. */
inline SPlanarVector FindNearestImage(const SPeriodicity& period, Real x, Real y, Real toX,
                                      Real toY) {
  return {period.X.RoundToPeriods(toX - x), period.Y.RoundToPeriods(toY - y)};
}

/** A footprint in the frame of a body whose origin is at that place, in the world frame. */
SFootprint PlaceFootprint(const SFootprint& footprint, Real x, Real y, Real cosine, Real sine);

/** The solids of a body at that pose, seen from above; tilted ones are bounded by rectangles. */
std::vector<SFootprint> DescribeFootprints(const SBodyDescription& description,
                                           const SPlanarPose& pose);
/** The same, appended to @p footprints. */
void AppendFootprints(const SBodyDescription& description, const SPlanarPose& pose,
                      std::vector<SFootprint>& footprints);

/** The rectangle around a tilted solid seen from above, in the frame of its body. */
SFootprint EncloseTilted(const SShapeDescription& shape);

/** @return true if the solid is upright in its body. */
bool IsUpright(const SShapeDescription& shape);

/** @return true if the solid is round, seen from above. */
bool IsDisc(const SShapeDescription& shape);

/** The yaw of an upright solid in its body, rad. */
Real ComputeYaw(const SShapeDescription& shape);

/** @return true if the body is one disc around the origin. */
bool IsCentredDisc(const SBodyDescription& description);

/** Half of the narrowest side of any solid seen from above, m. */
Real ComputeNarrowestHalf(const SBodyDescription& description);

/**
 * Appends the images of footprints that bodies near the seams may touch: those that come nearer to
 * the periodic area than a quarter of its sides.
 */
void AppendImages(const SPeriodicity& period, std::vector<SFootprint>& footprints);

}  // namespace argos

#endif
