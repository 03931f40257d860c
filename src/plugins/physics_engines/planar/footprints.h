#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_FOOTPRINTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_FOOTPRINTS_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/core/utility/spatial/rectangle.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos {

/** The projection of a solid on the ground: a disc or an oriented rectangle; m, world frame. */
struct SFootprint {
  Real X, Y;
  Real Cos, Sin;  // of the yaw of a rectangle
  Real HalfX, HalfY;  // of a rectangle; both 0 for a disc
  Real Radius;  // of a disc; 0 for a rectangle
};

/** Distance of a point from a footprint, m; 0 inside. */
inline Real ComputeDistance(const SFootprint& footprint, Real x, Real y) {
  return std::max(0.0, std::sqrt(ComputeSquareDistance(footprint, x, y)) - footprint.Radius);
}

/** The solids of a body at that pose, seen from above; tilted ones are bounded by discs. */
std::vector<SFootprint> DescribeFootprints(const SBodyDescription& description,
                                           const SPlanarPose& pose);
/** The same, appended to @p footprints. */
void AppendFootprints(const SBodyDescription& description, const SPlanarPose& pose,
                      std::vector<SFootprint>& footprints);

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

}  // namespace argos

#endif
