// Bodies that are not discs in a periodic arena.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>

#include <algorithm>

namespace argos {

void CSolids::Wrap() {
  for (SSolid& solid : m_solids) {
    SPlanarPose pose = solid.Pose;
    pose.X = m_period.X.Wrap(pose.X);
    pose.Y = m_period.Y.Wrap(pose.Y);
    if (pose.X != solid.Pose.X || pose.Y != solid.Pose.Y) {
      Place(solid, pose);
      solid.HasMoved = true;
    }
  }
}

std::span<const SFootprint> CSolids::ListFootprints() {
  if (!m_period.IsOn()) {
    return m_footprints;
  }
  m_withImages = m_footprints;
  AppendImages(m_period, m_withImages);
  return m_withImages;
}

Real CSolids::ComputeWidest() const {
  Real widest = 0.0;
  for (const SSolid& solid : m_solids) {
    widest = std::max(widest, solid.BoundingRadius);
  }
  return widest;
}

// Lists the footprints that any image of a body may have in a circle.
void CSolids::FindSolidsNear(Real x, Real y, Real reach) {
  m_solidCells.FindImages(m_grid, m_period, x, y, reach, reach, m_found);
}

}  // namespace argos
