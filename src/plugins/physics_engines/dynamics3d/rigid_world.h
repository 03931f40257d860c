#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_WORLD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_WORLD_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/contact_finder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/free_robots.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/parts_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_grips.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_stepper.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/upright_crowd.h>

#include <functional>
#include <memory>
#include <vector>

namespace argos {

class CThreadPool;

/** A horizontal plane. */
struct SGroundPlane {
  Real Height = 0.0;  // m
  Real Friction = 1.0;
};

/**
 * All bodies of an engine in one ODE world.
 *
 * The result is a function of the order of adding, placing, removing and Advance() only, not of
 * addresses, threads or other worlds.
 */
class CRigidWorld {
 public:
  /** @param beforeSubstep  called in Advance() before each substep: forces of add-ons. */
  CRigidWorld(const SRigidSettings& settings, std::function<void()> beforeSubstep);
  ~CRigidWorld();
  CRigidWorld(const CRigidWorld&) = delete;
  CRigidWorld& operator=(const CRigidWorld&) = delete;

  /** m/s^2. */
  void SetGravity(const CVector3& gravity);
  /** A plane that supports the bodies above it. */
  void AddPlane(const SGroundPlane& plane);
  /** A plane that stops the bodies below it. */
  void AddCeiling(const SGroundPlane& plane);
  /**
   * A face of a region that stops the bodies in front of it.
   * @param wall  one box, whose y axis points to the bodies; outlives the world.
   */
  void AddWall(const SBodyDescription& wall, SRigidPose pose);

  /** Adds a body at rest, and wakes all bodies; an upright robot on the floor is free. The
   * reference stays valid until Remove(). */
  SRigidBody& Add(const SRigidSource& source, const SRigidPose& pose);
  void Remove(SRigidBody& body);
  /** @return true if the body was not removed. Takes time in proportion to the bodies. */
  bool Has(const SRigidBody& body) const;
  /** Sets pose and motion of a body, releases its grips, and wakes all bodies. */
  void Place(SRigidBody& body, const SRigidPose& pose, const SRigidMotion& motion);

  /** Gives a free robot parts in ODE, for the next tick at least: it may be pushed. */
  void Activate(SRigidBody& body);

  CRigidGrips& GetGrips() { return *m_grips; }

  /** Sets the robots of other engines for the next tick. */
  void SetGhosts(const std::vector<SGhostCylinder>& ghosts) { m_ghosts.Set(ghosts); }
  /** Greatest distance from a border at which a ghost matters in the next tick, m. */
  Real ComputeGhostReach() const;

  /** Moves all bodies by a tick. @param pool  shares the work on free robots; null: no threads. */
  void Advance(CThreadPool* pool = nullptr);

  /** In order of addition, except for bodies that fill the places of removed ones. */
  const std::vector<SRigidBody*>& GetMovables() const { return m_movables; }
  /** Length of the present substep, s. */
  Real GetSubstep() const { return m_substep; }
  UInt32 GetNumSubsteps() const { return m_numSubsteps; }
  /** Steps so far in which the direct solver has failed to solve some contacts. */
  UInt64 GetNumGivenUp() const { return m_numGivenUp; }

 private:
  SRigidBody& MakeBody();
  SRigidBody& MakePlane(const SGroundPlane& plane);
  void WakeAll();
  void Reserve();
  void HardenJoints(const SRigidBody& body);
  void SetGround();
  void StartTick(CThreadPool* pool);
  void StartRobotTick(SRigidBody& body);
  void Deactivate(SRigidBody& body);
  void TakeFromActive(const SRigidBody& body);
  void SelectFree(CThreadPool* pool);
  void ActivateStruck(UInt32 substeps);
  void ActivateAt(SRigidBody& body, UInt32 substeps);
  void RollFree(CThreadPool* pool);
  void SelectUpright();
  void ListLoose();
  void StepLoose(CThreadPool* pool);
  void Doze(bool isFirstSubstep);
  void EndDozing();
  void SetPlanarMotors();
  static Real FindFastest(const std::vector<SRigidBody*>& bodies);
  Real ComputeLongestPath(Real fastest) const;
  UInt32 CountSubsteps() const;
  void SetSubstep(Real substep);
  void Step(CThreadPool* pool);
  void StepJoints();
  void StepDirectly();
  void StepByIslands();
  void StepIteratively();
  void UpdateSleep();

  SRigidSettings m_settings;
  std::function<void()> m_beforeSubstep;
  CVector3 m_gravity;  // m/s^2
  dWorldID m_world;
  // of this world only: worlds without one share one that is not thread-safe
  dThreadingImplementationID m_threading;
  std::unique_ptr<CContactFinder> m_contacts;
  CRigidStepper m_stepper;
  std::unique_ptr<CRigidGrips> m_grips;
  CRigidGhosts m_ghosts;
  CFreeRobots m_free;
  CUprightCrowd m_upright;
  CPartsPool m_spares;
  std::vector<std::unique_ptr<SRigidBody>> m_owned;
  std::vector<SRigidBody*> m_planes;
  std::vector<SRigidBody*> m_fixed;  // by number
  std::vector<SRigidBody*> m_movables;  // by number
  std::vector<SRigidBody*> m_active;  // by PartsNumber: movable bodies with parts in ODE
  std::vector<SRigidBody*> m_loose;  // by ActiveNumber: those of them that are not upright
  std::vector<SRigidBody*> m_listed;  // scratch
  std::vector<UInt32> m_struck;  // numbers of movable bodies
  std::vector<SRigidBody*> m_flying;
  std::vector<SRigidBody*> m_articulated;
  std::vector<SRigidBody*> m_large;  // in islands that ODE solves iteratively
  Real m_widest = 0.0;  // m; greatest bounding radius of all movable bodies that ever were here
  Real m_substep = 0.0;  // s
  UInt32 m_numSubsteps = 0;  // of this tick
  Real m_heaviestLink = 0.0;  // kg; of all that ever were here
  UInt32 m_numIterativeSteps = 0;  // so far
  UInt32 m_mostDirectRows = 0;  // of an island that is solved directly, in this tick
  UInt64 m_numGivenUp = 0;
  UInt64 m_numMade = 0;  // bodies so far
};

}  // namespace argos

#endif
