#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_POSE_GRID_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_POSE_GRID_H

#include <argos3/core/simulator/geometry/body_pose.h>

#include <cmath>

namespace argos {

/**
 * The grid to which views round the poses that they draw, and to which recordings round those that
 * they keep: so a replay gives the same pictures, to the bit, and a difference of at most half a
 * micrometre, or of two microradians, from the simulated pose, which no picture shows.
 *
 * A power of two: a rounded number times or divided by it is exact, and is rounded to itself.
 */
constexpr Real kPoseGrid = 1.0 / (1 << 20);  // m; of the components of quaternions: 1

/** Numbers beyond it, in units of the grid, are not rounded: 4,000 km. */
constexpr Real kMaxOnPoseGrid = 0x1p42;

/** The nearest number of the grid; ties to the even one; 0 is not negative. NaN and large numbers
 * are unchanged. */
inline Real SnapToPoseGrid(Real value) {
  const Real units = value / kPoseGrid;
  return std::abs(units) < kMaxOnPoseGrid ? (std::nearbyint(units) + 0.0) * kPoseGrid : value;
}

inline CVector3 SnapToPoseGrid(const CVector3& v) {
  return CVector3(SnapToPoseGrid(v.GetX()), SnapToPoseGrid(v.GetY()), SnapToPoseGrid(v.GetZ()));
}

/** Its norm may then differ from 1 by 1e-6: it is not normalised, so that it stays on the grid. */
inline CQuaternion SnapToPoseGrid(const CQuaternion& q) {
  return CQuaternion(SnapToPoseGrid(q.GetW()), SnapToPoseGrid(q.GetX()), SnapToPoseGrid(q.GetY()),
                     SnapToPoseGrid(q.GetZ()));
}

inline SBodyPose SnapToPoseGrid(const SBodyPose& pose) {
  return {SnapToPoseGrid(pose.Position), SnapToPoseGrid(pose.Orientation)};
}

}  // namespace argos

#endif
