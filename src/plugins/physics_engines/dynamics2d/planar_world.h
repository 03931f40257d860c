#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_WORLD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_WORLD_H

#include <argos3/core/utility/non_copyable.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/grip_ties.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_store.h>
#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <vector>

namespace argos {

class CThreadPool;

/**
 * The bodies of one engine, and their motion.
 *
 * A robot that cannot touch anything during a tick needs no solver: its exact arc is computed in
 * double precision. Each tick finds what discs (CDiscPairs) and other bodies (CCrowdSolids) can
 * meet. What can meet, or is connected by grips (CPlanarGrips), is solved together (CCrowd).
 *
 * Everything is a function of the order of adding, removing and Advance(), and of no thread.
 */
class CPlanarWorld : private CNonCopyable {
 public:
  explicit CPlanarWorld(const SPlanarSettings& settings);

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
    m_crowd.ForgetSolids();
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
    m_store.SetVelocity(handle, velocity);
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
  bool IsAt(const SPlanarHandle& handle, const SPlanarPose& pose, const CVector3& origin) const {
    return m_store.IsAt(handle, pose, origin);
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
  void Advance(CThreadPool& pool);

  /**
   * After Advance(): makes the planned state of driven bodies [begin, end) their state, calling
   * visit(const SDrivenBody&, size_t slot) for each; safe on several threads for different bodies.
   */
  template <typename VISIT>
  void CommitDriven(size_t begin, size_t end, VISIT&& visit) {
    const bool isPeriodic = m_store.GetSettings().Period.IsOn();
    for (size_t slot = begin; slot < end; ++slot) {
      SDrivenBody& body = m_store.GetDriven()[slot];
      body.Pose = body.NextPose;
      body.Velocity = body.NextVelocity;
      body.Command = body.NextCommand;
      if (isPeriodic) {
        Wrap(body.Pose);
      }
      visit(static_cast<const SDrivenBody&>(body), slot);
    }
  }
  const SDrivenBody& GetDriven(UInt32 slot) { return m_store.GetDriven(slot); }
  size_t GetNumDriven() const { return m_store.GetDriven().size(); }
  /** After Advance(): calls visit(const SPassiveBody&) for each passive body; see Moved. */
  template <typename VISIT>
  void ForEachPassive(VISIT&& visit) const {
    for (const SPassiveBody& body : m_store.GetPassive()) {
      visit(body);
    }
  }

 private:
  // phases of Advance(), in order
  void PlanDriven(CThreadPool& pool);
  Real PlanChunk(size_t begin, size_t end);
  Real Plan(SDrivenBody& body, UInt32 slot);
  void FindMeetings(CThreadPool& pool);
  void ExtendLongestPath();
  void FinishPassive();
  void CheckPeriod() const;

  // puts a pose that has left a periodic arena inside
  void Wrap(SPlanarPose& pose) const {
    const SPeriodicity& period = m_store.GetSettings().Period;
    pose.X = period.X.Wrap(pose.X);
    pose.Y = period.Y.Wrap(pose.Y);
  }
  /** How far a disc may move in the tick, m. */
  Real GetReach() const { return m_longestPath + m_crowd.GetAllowance() + GetSlack(); }
  Real GetSlack() const;
  Real GetTick() const { return m_store.GetSettings().Tick; }

  CPlanarStore m_store;
  CPlanarGrips m_grips;
  CGripTies m_ties;
  CPlanarGhosts m_ghosts;
  CDiscPairs m_discPairs;
  CCrowd m_crowd;
  std::vector<Real> m_longestOfChunk;  // m; scratch of PlanDriven()
  Real m_longestPath = 0.0;  // m, of any movable body in this tick, at most
};

}  // namespace argos

#endif
