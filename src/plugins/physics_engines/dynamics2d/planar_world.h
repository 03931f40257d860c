#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_WORLD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_WORLD_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/active_set.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>
#include <argos3/plugins/simulator/physics_engines/planar/proximity_filter.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/substep_policy.h>

#include <vector>

namespace argos {

/**
 * The bodies of one engine, and their motion, on Box2D.
 *
 * A robot that is a disc and cannot touch anything during a tick needs no solver: its exact arc is
 * computed in double precision, and it has no body in Box2D. Each tick determines these robots
 * (CProximityFilter); the others are active (CActiveSet).
 *
 * Everything is a function of the order of adding, removing and Advance().
 */
class CPlanarWorld {
 public:
  explicit CPlanarWorld(const SPlanarSettings& settings);
  CPlanarWorld(const CPlanarWorld&) = delete;
  CPlanarWorld& operator=(const CPlanarWorld&) = delete;

  /** Allocates the arrays for so many bodies. */
  void Reserve(size_t immovable, size_t passive, size_t driven) {
    m_store.Reserve(immovable, passive, driven);
  }
  /** Adds a body that is at rest. */
  void AddImmovable(const SPlanarOwner& owner, const SBodyDescription& description,
                    const SPlanarPose& pose) {
    m_store.AddImmovable(owner, description, pose);
  }
  void AddPassive(const SPlanarOwner& owner, const SBodyDescription& description,
                  const SPlanarPose& pose) {
    m_store.AddPassive(owner, description, pose);
  }
  void AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                 const SPlanarPose& pose, const CDriveSource& drive);
  /** Removes a body; another one may get its slot. */
  void Remove(const SPlanarHandle& handle);
  /** At the end of the last tick; 0 for an immovable body. */
  SPlanarVelocity GetVelocity(const SPlanarHandle& handle) const {
    return m_store.GetVelocity(handle);
  }
  /** Sets the velocity of a movable body. */
  void SetVelocity(const SPlanarHandle& handle, const SPlanarVelocity& velocity) {
    m_active.SetVelocity(handle, velocity);
  }
  /** What a robot was told in the last tick; at rest if the body has no drive. */
  SDriveCommand GetLastCommand(const SPlanarHandle& handle) const {
    return handle.Kind == EPlanarKind::Driven ? m_store.GetDriven(handle).Command : SDriveCommand();
  }
  void SetLastCommand(const SPlanarHandle& handle, const SDriveCommand& command) {
    if (handle.Kind == EPlanarKind::Driven) {
      m_store.GetDriven(handle).Command = command;
    }
  }
  /** See CPlanarStore::IsAt(). */
  bool IsAt(const SPlanarHandle& handle, const SPlanarPose& pose) const {
    return m_store.IsAt(handle, pose);
  }
  CPlanarGrips& GetGrips() { return m_grips; }
  const CPlanarGrips& GetGrips() const { return m_grips; }

  /** Allocates the memory that a tick of a swarm of the present size needs. */
  void ReserveForTick();

  /** Sets the robots of other engines that are obstacles in the next Advance(). */
  void SetGhosts(const std::vector<SGhostDisc>& ghosts) { m_ghosts.Set(ghosts); }
  /** Greatest distance from the border at which a ghost matters in the next tick, m. */
  Real ComputeGhostReach() const;

  /** Moves all bodies by one tick. @throws SBadDriveCommand */
  void Advance();

  /**
   * After Advance(): makes the planned state of driven bodies their state, calling
   * visit(const SDrivenBody&) for each.
   */
  template <typename VISIT>
  void CommitDriven(VISIT&& visit) {
    for (SDrivenBody& body : m_store.GetDriven()) {
      body.Pose = body.NextPose;
      body.Velocity = body.NextVelocity;
      body.Command = body.NextCommand;
      visit(static_cast<const SDrivenBody&>(body));
    }
  }
  /** After Advance(): calls visit(const SPassiveBody&) for each passive body; see Moved. */
  template <typename VISIT>
  void ForEachPassive(VISIT&& visit) const {
    for (const SPassiveBody& body : m_store.GetPassive()) {
      visit(body);
    }
  }

 private:
  // phases of Advance(), in order
  void PlanDriven();
  void Plan(SDrivenBody& body, UInt32 slot);
  void MarkDiscs();
  void ExtendLongestPath();
  bool IsAnyAwake() const;
  UInt32 ChooseSubsteps() const;
  float ComputeSubstepsOfPassive() const;
  void StepBox2D(UInt32 substeps);
  void FinishPassive();

  Real GetSlack() const;
  Real GetTick() const { return m_store.GetSettings().Tick; }

  CPlanarStore m_store;
  CActiveSet m_active;
  CPlanarGrips m_grips;
  CPlanarGhosts m_ghosts;
  CSubstepPolicy m_substepPolicy;
  CProximityFilter m_proximityFilter;
  COverlapSolver m_overlaps;
  Real m_longestPath = 0.0;  // m, of any movable body in this tick, at most
};

}  // namespace argos

#endif
