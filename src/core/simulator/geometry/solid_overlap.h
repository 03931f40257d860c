#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_SOLID_OVERLAP_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_SOLID_OVERLAP_H

#include <argos3/core/simulator/geometry/body_description.h>

namespace argos {

/** One solid of a body at the pose of the body's origin anchor; world frame, m. */
struct SPlacedSolid {
  const SShapeDescription* Shape;
  CVector3 Position;
  CQuaternion Orientation;
};

/**
 * True if two solids, in any orientation, overlap by more than 2e-7 m.
 *
 * Upright ones are faster, and finer, with ShapesOverlap(). Pure function.
 * Source: E. Gilbert, D. Johnson, S. Keerthi, A fast procedure for computing the distance between
 *         complex objects in three-dimensional space, IEEE J. Robotics and Automation 4 (1988).
 */
bool SolidsOverlap(const SPlacedSolid& a, const SPlacedSolid& b);

}  // namespace argos

#endif
