#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_FREE_ROBOTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_FREE_ROBOTS_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rolling.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/planar/proximity_filter.h>

#include <optional>
#include <vector>

namespace argos {

class CRigidGrips;
struct SGhostCylinder;
struct SRigidSettings;

/**
 * Finds the robots that can touch nothing but the floor in a tick. These may be free: they follow
 * the arcs of their drives (rolling.h) and have no parts in ODE.
 *
 * A robot reaches as far in a tick as it may drive; a body that something may push, as far as the
 * fastest one moves. If a body leaves that reach within the tick, because something struck it, the
 * free robots near it become active at once.
 */
class CFreeRobots {
 public:
  /** All bodies of a world, at the start of a tick. */
  struct SBodies {
    const std::vector<SRigidBody*>& Movables;  // by SRigidBody::Number
    const std::vector<SRigidBody*>& Active;
    const std::vector<SRigidBody*>& Fixed;
    const CRigidGrips& Grips;
    const std::vector<SGhostCylinder>& Ghosts;
  };

  explicit CFreeRobots(const SRigidSettings& settings);

  /** Allocates for a number of movable bodies. */
  void Reserve(size_t movables);
  /** @param ground  on which robots may be free; unset: none may. */
  void SetGround(const std::optional<SRollGround>& ground);
  const std::optional<SRollGround>& GetGround() const { return m_ground; }
  /** A body with a drive was added: obstacles up to its height matter. */
  void NoteRobot(const SRigidBody& robot);
  /** To be called after fixed bodies were added, removed or placed. */
  void MarkFixedChanged() { m_haveFixedChanged = true; }
  /** @return true if a robot that is at rest at a pose may be free. */
  bool MayStartFree(const SRigidSource& source, const SRigidPose& pose) const;

  /**
   * Reads the commands of all drives, and finds the robots that can touch nothing in the tick.
   * @param fastest  speed of the fastest active body, m/s. @param tick s.
   * @param pool     null: in this thread.
   * @throws SBadDriveCommand
   */
  void StartTick(const SBodies& bodies, Real fastest, Real tick, CThreadPool* pool);
  /** After StartTick(): how far an active body is expected to move in the tick, m. */
  Real GetReach() const { return m_reach; }
  /** @return true if a free robot must become active in this tick. */
  bool MustActivate(const SRigidBody& robot) const;
  /** @return true if an active robot may become free; sets its state as a free one. */
  bool MayFree(SRigidBody& robot) const;
  /** The area that an active body does not leave in the tick unless something strikes it. */
  void Claim(SRigidBody& body) const;
  /**
   * After a substep, if a body may leave the area that it claims in the next one: it claims
   * another. @param rest  of the tick, s. @param met  receives the robots that may be there.
   * @return true if it did.
   */
  bool ExtendClaim(SRigidBody& body, Real substep, Real rest, std::vector<UInt32>& met);

 private:
  struct SPlan {
    Real Path = 0.0;  // m, greatest in the tick by its own drive
    bool MayRoll = false;
    SRollState State;  // if it may
  };

  SPlan MakePlan(const SRigidBody& robot, Real tick) const;
  bool IsSeeking(const SRigidBody& body) const;
  void MarkOthers(const SBodies& bodies);
  void ListObstacles(const std::vector<SRigidBody*>& fixed);
  bool IsAtHeight(Real low, Real high) const;

  const SRigidSettings& m_settings;
  std::optional<SRollGround> m_ground;
  Real m_height = 0.0;  // m, of the highest robot
  bool m_haveFixedChanged = true;
  CThreadPool m_alone;  // where the engine has no pool
  CProximityFilter m_filter;  // discs by SRigidBody::Number
  std::vector<SPlan> m_plans;  // by SRigidBody::Number
  Real m_reach = 0.0;  // m: how far an active body is expected to move in this tick
};

}  // namespace argos

#endif
