// Robots of other engines near the border as obstacles of bodies that are not discs.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>

#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// the path that a drive commands in a time (s), m
Real ComputePath(const SSolid& solid, Real duration) {
  return solid.IsPassive() ? 0.0 : solid.Drive.Read().ComputeSpeed() * duration;
}

}  // namespace

Real CSolids::ComputeGhostReach(Real tick) const {
  Real reach = 0.0;
  for (const SSolid& solid : m_solids) {
    // Plan() reports speeds that are not numbers
    reach = std::fmax(reach, solid.BoundingRadius + 2.0 * ComputePath(solid, tick));
  }
  return reach;
}

void CSolids::SetGhosts(std::span<const SGhostDisc> ghosts, Real tick) {
  m_ghosts.clear();
  m_faces.clear();
  for (const SGhostDisc& ghost : ghosts) {
    m_ghosts.push_back({ghost.X, ghost.Y, 1.0, 0.0, 0.0, 0.0, ghost.Radius});
    if (m_numDriven > 0) {
      AddFaces(ghost, tick);
    }
  }
}

// Adds a face half-way between a ghost and each robot that may reach it, across the line between
// their centres: between the circles around them.
void CSolids::AddFaces(const SGhostDisc& ghost, Real tick) {
  for (UInt32 slot = 0; slot < m_solids.size(); ++slot) {
    const SSolid& solid = m_solids[slot];
    const Real dx = solid.Pose.X - ghost.X;
    const Real dy = solid.Pose.Y - ghost.Y;
    const Real distance = std::hypot(dx, dy);
    const Real gap = distance - ghost.Radius - solid.BoundingRadius;
    const Real path = ComputePath(solid, tick);
    if (solid.IsPassive() || !(gap <= 2.0 * path) || !(distance > 0.0)) {
      continue;
    }
    // so large that no path of the robot leads around it or through it
    const Real half = ghost.Radius + 2.0 * solid.BoundingRadius + 2.0 * path;
    const Real toCentre = (ghost.Radius + 0.5 * gap - half) / distance;
    m_faces.push_back({*solid.Owner.Handle,
                       {ghost.X + dx * toCentre, ghost.Y + dy * toCentre, dx / distance,
                        dy / distance, half, half, 0.0}});
  }
}

// Finds ghosts that overlap a passive object, which then has to give way to them.
void CSolids::FindGhostOverlaps(UInt32 slot) {
  const SSolid& solid = m_solids[slot];
  m_ghostCells.Find(m_grid, solid.Pose.X, solid.Pose.Y, solid.BoundingRadius, m_found);
  for (const UInt32 ghost : m_found) {
    for (const SFootprint& mine : FootprintsOf(solid)) {
      const Real depth = -ComputeGap(mine, m_ghostCells.GetFootprint(ghost));
      if (depth > kSolidTolerance * solid.NarrowestHalf) {
        AddToSolver(slot);
        m_farthest = std::max(m_farthest, depth);
      }
    }
  }
}

}  // namespace argos
