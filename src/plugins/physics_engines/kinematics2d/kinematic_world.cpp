#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_world.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

#include <algorithm>

namespace argos {

void CKinematicWorld::Reserve(size_t immovable, size_t solids, size_t discs) {
  m_immovable.reserve(immovable);
  m_generations.Reserve(immovable);
  m_solids.Reserve(solids);
  m_discs.Reserve(discs);
}

void CKinematicWorld::ReserveForGhosts(size_t discs) {
  m_discs.ReserveForGhosts(discs);
}

void CKinematicWorld::AddImmovable(const SKinematicOwner& owner,
                                   const SBodyDescription& description, const SPlanarPose& pose) {
  *owner.Handle = {EKinematicKind::Immovable, static_cast<UInt32>(m_immovable.size()),
                   m_generations.Add()};
  m_immovable.push_back({owner, DescribeFootprints(description, pose)});
  m_wallsChanged = true;
}

void CKinematicWorld::AddWall(const SBodyDescription& description, const SPlanarPose& pose) {
  AppendFootprints(description, pose, m_wallsOfRegion);
  m_wallsChanged = true;
}

void CKinematicWorld::AddMovable(const SKinematicOwner& owner, const SBodyDescription& description,
                                 const SPlanarPose& pose, const CDriveSource& drive,
                                 const SGroundFriction& friction) {
  if (drive && IsCentredDisc(description)) {
    m_discs.Add(owner, description, pose, drive);
  } else {
    m_solids.Add(owner, description, pose, drive, friction);
  }
}

void CKinematicWorld::Remove(const SKinematicHandle& handle) {
  switch (handle.Kind) {
    case EKinematicKind::Immovable:
      RemoveImmovable(handle);
      break;
    case EKinematicKind::Solid:
      m_solids.Remove(handle);
      break;
    case EKinematicKind::Disc:
      m_discs.Remove(handle);
      break;
  }
}

void CKinematicWorld::RemoveImmovable(const SKinematicHandle& handle) {
  m_generations.Check(handle);
  const UInt32 slot = handle.Slot;
  *m_immovable[slot].Owner.Handle = SKinematicHandle();
  const UInt32 generation = m_generations.Remove(slot);
  if (slot + 1 != m_immovable.size()) {
    m_immovable[slot] = std::move(m_immovable.back());
    m_immovable[slot].Owner.Handle->Slot = slot;
    m_immovable[slot].Owner.Handle->Generation = generation;
  }
  m_immovable.pop_back();
  m_wallsChanged = true;
}

bool CKinematicWorld::IsCurrent(const SKinematicHandle& handle) const {
  switch (handle.Kind) {
    case EKinematicKind::Solid:
      return m_solids.IsCurrent(handle);
    case EKinematicKind::Disc:
      return m_discs.IsCurrent(handle);
    default:
      return m_generations.IsCurrent(handle.Slot, handle.Generation);
  }
}

void CKinematicWorld::SetPose(const SKinematicHandle& handle, const SPlanarPose& pose) {
  ARGOS_ASSERT(handle.Kind != EKinematicKind::Immovable,
               "the pose of an immovable body is set, in slot " << handle.Slot);
  if (handle.Kind == EKinematicKind::Disc) {
    m_discs.SetPose(handle, pose);
  } else {
    m_solids.SetPose(handle, pose);
  }
}

// Lists walls and solids in the cells of the grid, if those or the grid have changed.
void CKinematicWorld::ListWalls() {
  const CFramedGrid& grid = m_discs.GetGrid();
  // no disc reaches farther in a tick
  const Real reach = 0.5 * grid.GetX().Edge;
  if (m_gridOfWalls != grid.GetGeneration()) {
    m_gridOfWalls = grid.GetGeneration();
    m_wallCells.List(grid, m_walls, reach);
  }
  if (m_gridOfSolids != grid.GetGeneration() || m_generationOfSolids != m_solids.GetGeneration()) {
    m_gridOfSolids = grid.GetGeneration();
    m_generationOfSolids = m_solids.GetGeneration();
    m_solidCells.List(grid, m_solids.ListFootprints(), reach);
  }
}

void CKinematicWorld::SetGhosts(std::span<const SGhostDisc> ghosts, Real tick, UInt32 substeps) {
  m_ghosts = ghosts;
  m_ghostSubsteps = substeps;
  m_solids.SetGhosts(ghosts, tick);
}

Real CKinematicWorld::ComputeGhostReach(Real tick, UInt32 substeps) const {
  const Real discs = m_discs.ComputeGhostReach(tick, substeps);
  // passive bodies move as far as discs push them
  return m_solids.GetSize() > 0 ? discs + m_solids.ComputeGhostReach(tick) : discs;
}

void CKinematicWorld::SetLastCommand(const SKinematicHandle& handle, const SDriveCommand& command) {
  if (handle.Kind == EKinematicKind::Disc) {
    m_discs.SetLastCommand(handle, command);
  } else if (handle.Kind == EKinematicKind::Solid) {
    m_solids.SetLastCommand(handle, command);
  }
}

SDriveCommand CKinematicWorld::GetLastCommand(const SKinematicHandle& handle) {
  return handle.Kind == EKinematicKind::Disc ? m_discs.GetLastCommand(handle)
                                             : m_solids.GetLastCommand(handle);
}

void CKinematicWorld::SetPeriod(const SPeriodicity& period) {
  m_period = period;
  m_discs.SetPeriod(period);
  m_solids.SetPeriod(period);
}

// Two bodies can meet on one side only, and an image of an obstacle is where a body may meet it.
void CKinematicWorld::CheckPeriod() const {
  const Real discs = m_discs.GetSize() > 0 ? m_discs.GetMaxReach() : 0.0;
  const Real widest = m_solids.ComputeWidest();
  // solids are pushed as far as discs move, or move by less than their size
  const Real solids = widest > 0.0 ? widest + std::max(discs, widest) : 0.0;
  const Real necessary = 4.0 * std::max(discs, solids);
  RequirePeriod(m_period, necessary);
}

void CKinematicWorld::Advance(CThreadPool& pool, const SSubstep& substep) {
  m_solids.Plan(substep);
  m_discs.Plan(pool, substep);
  if (m_period.IsOn()) {
    CheckPeriod();
  }
  if (m_ghostSubsteps > 0) {
    m_discs.FindGhosts(m_ghosts, m_ghostSubsteps);
    m_ghostSubsteps = 0;
  }
  if (m_wallsChanged) {
    m_wallsChanged = false;
    m_walls.clear();
    for (const SImmovable& body : m_immovable) {
      m_walls.insert(m_walls.end(), body.Footprints.begin(), body.Footprints.end());
    }
    m_walls.insert(m_walls.end(), m_wallsOfRegion.begin(), m_wallsOfRegion.end());
    AppendImages(m_period, m_walls);
    m_gridOfWalls = 0;
    m_solids.SetWalls(m_walls);
  }
  m_solids.Step(m_discs);
  if (m_discs.GetSize() > 0) {
    ListWalls();
    m_discs.Step(pool, m_wallCells, m_solidCells);
  }
}

}  // namespace argos
