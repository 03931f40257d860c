#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_WORLD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_WORLD_H

#include <argos3/plugins/simulator/physics_engines/kinematics2d/disc_swarm.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_handle.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/solids.h>
#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>
#include <argos3/plugins/simulator/physics_engines/planar/ghost_discs.h>
#include <argos3/plugins/simulator/physics_engines/robot_bodies/slot_generations.h>

#include <span>
#include <vector>

namespace argos {

class CThreadPool;
struct SBodyDescription;

/**
 * The bodies of one engine, and their motion: fixed walls, solids that are pushed, and discs that
 * drive.
 *
 * Everything is a function of the order of adding, removing and Advance(), and of no thread.
 */
class CKinematicWorld {
 public:
  /** Joins sides of the area; before bodies are added. */
  void SetPeriod(const SPeriodicity& period);
  /** After Advance(): puts the bodies that have left a periodic area inside; discs by CDiscSwarm.
   */
  void WrapSolids() { m_solids.Wrap(); }
  /** Allocates the arrays for so many bodies. */
  void Reserve(size_t immovable, size_t solids, size_t discs);
  /** Allocates what ghosts need. */
  void ReserveForGhosts(size_t discs);
  void AddImmovable(const SKinematicOwner& owner, const SBodyDescription& description,
                    const SPlanarPose& pose);
  /** Adds a wall of the region, which has no owner. */
  void AddWall(const SBodyDescription& description, const SPlanarPose& pose);
  void AddMovable(const SKinematicOwner& owner, const SBodyDescription& description,
                  const SPlanarPose& pose, const CDriveSource& drive,
                  const SGroundFriction& friction);
  /** Removes a body; another one may get its slot. */
  void Remove(const SKinematicHandle& handle);
  /** Sets the pose of a movable body. */
  void SetPose(const SKinematicHandle& handle, const SPlanarPose& pose);

  /**
   * Sets the robots of other engines before the first Advance() of a tick; they must stay valid
   * during the tick.
   * @param tick      s.
   * @param substeps  calls of Advance() in it.
   */
  void SetGhosts(std::span<const SGhostDisc> ghosts, Real tick, UInt32 substeps);
  /**
   * Greatest distance from the border at which a ghost matters in a tick (s) of so many substeps,
   * m; to be called between ticks.
   */
  Real ComputeGhostReach(Real tick, UInt32 substeps) const;
  /** Sets what a robot was told in the last tick. */
  void SetLastCommand(const SKinematicHandle& handle, const SDriveCommand& command);
  SDriveCommand GetLastCommand(const SKinematicHandle& handle);
  /**
   * Moves all bodies. GetDiscs().Commit() of each disc then updates its pose.
   * @throws SBadDriveCommand
   */
  void Advance(CThreadPool& pool, const SSubstep& substep);
  /** @return true if the body of the handle is still in its slot. */
  bool IsCurrent(const SKinematicHandle& handle) const;
  CDiscSwarm& GetDiscs() { return m_discs; }
  CSolids& GetSolids() { return m_solids; }

 private:
  struct SImmovable {
    SKinematicOwner Owner;
    std::vector<SFootprint> Footprints;
  };

  void RemoveImmovable(const SKinematicHandle& handle);
  void ListWalls();
  void CheckPeriod() const;

  CDiscSwarm m_discs;
  CSolids m_solids;
  std::vector<SImmovable> m_immovable;
  CSlotGenerations m_generations;  // of the immovable bodies
  std::vector<SFootprint> m_wallsOfRegion;
  SPeriodicity m_period;
  // footprints of all immovable bodies, and those of the region; with their images near seams
  std::vector<SFootprint> m_walls;
  bool m_wallsChanged = true;
  // what each cell of the discs' grid can reach, and the generations for which it was computed
  CCellLists m_wallCells, m_solidCells;
  UInt32 m_gridOfWalls = 0, m_gridOfSolids = 0;
  UInt32 m_generationOfSolids = 0;
  std::span<const SGhostDisc> m_ghosts;
  UInt32 m_ghostSubsteps = 0;  // of the tick, if ghosts were set since the last Advance(); else 0
};

}  // namespace argos

#endif
