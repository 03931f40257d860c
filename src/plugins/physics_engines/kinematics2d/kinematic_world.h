#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_WORLD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_WORLD_H

#include <argos3/plugins/simulator/physics_engines/kinematics2d/cell_grid.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/disc_swarm.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_handle.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>

#include <span>
#include <vector>

namespace argos {

class CThreadPool;
struct SBodyDescription;

/**
 * The bodies of one engine, and their motion: walls that stay, solids that are pushed, and discs
 * that drive.
 *
 * Everything is a function of the order of adding, removing and Advance(), and of no thread.
 */
class CKinematicWorld {
 public:
  /** Allocates the arrays for so many bodies. */
  void Reserve(size_t immovable, size_t solids, size_t discs);
  /** The same for what ghosts need. */
  void ReserveForGhosts(size_t discs);
  void AddImmovable(const SKinematicOwner& owner, const SBodyDescription& description,
                    const SPlanarPose& pose);
  /** Adds something that stays, and is nobody's: a wall of the region. */
  void AddWall(const SBodyDescription& description, const SPlanarPose& pose);
  /** @param wheels  speeds of a robot's wheels, which must stay valid; null: it has no drive. */
  void AddMovable(const SKinematicOwner& owner, const SBodyDescription& description,
                  const SPlanarPose& pose, const Real* wheels, const SGroundFriction& friction);
  /** Takes a body out; another one may get its slot. */
  void Remove(const SKinematicHandle& handle);
  /** Puts a movable body somewhere. */
  void SetPose(const SKinematicHandle& handle, const SPlanarPose& pose);

  /**
   * Tells of the robots of other engines before the first Advance() of a tick; they must stay valid
   * for all of it.
   * @param tick      s.
   * @param substeps  calls of Advance() in it.
   */
  void SetGhosts(std::span<const SGhostDisc> ghosts, Real tick, UInt32 substeps);
  /**
   * How far from a body here a ghost may be, m, from the border to its solid, that is met in a tick
   * of so many substeps; to be asked between ticks.
   */
  Real ComputeGhostReach(Real tick, UInt32 substeps) const;
  /**
   * Moves everything by a time, s. Where discs are now is taken over by GetDiscs().Commit() of
   * each.
   * @throws SBadKinematicWheels
   */
  void Advance(CThreadPool& pool, Real duration);
  CDiscSwarm& GetDiscs() { return m_discs; }
  CSolids& GetSolids() { return m_solids; }

 private:
  struct SImmovable {
    SKinematicOwner Owner;
    std::vector<SFootprint> Footprints;
  };

  void ListWalls();

  CDiscSwarm m_discs;
  CSolids m_solids;
  std::vector<SImmovable> m_immovable;
  std::vector<SFootprint> m_wallsOfRegion;
  std::vector<SFootprint> m_walls;  // footprints of all immovable bodies, and those of the region
  bool m_wallsChanged = true;
  // who may be met from each cell of the discs' grid, and when that was found out
  CCellLists m_wallCells, m_solidCells;
  UInt32 m_gridOfWalls = 0, m_gridOfSolids = 0;
  UInt32 m_generationOfSolids = 0;
  std::span<const SGhostDisc> m_ghosts;
  UInt32 m_substepsToCome = 0;  // of the tick, if ghosts have been told of since the last Advance()
};

}  // namespace argos

#endif
