#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_WORLD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_WORLD_H

#include <argos3/core/utility/prefetch.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/encounters.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/overlap_solver.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_bodies.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_ghosts.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_grips.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

#include <box2d/box2d.h>

#include <vector>

namespace argos {

struct SBodyDescription;

/** Size of a CDynamics2DModel, about. */
constexpr size_t kModelBytes = 128;

/** What a CPlanarWorld is made with. */
struct SPlanarSettings {
  Real Tick = 0.1;  // s
  UInt32 Substeps = 1;  // of a tick; more if something moves very fast
  bool RefineInCrowds = true;  // more substeps also where overlaps are left
  Real UnitsPerMetre = 10.0;  // Box2D's unit of length
  SGroundFriction BoxFriction;
  SGroundFriction CylinderFriction;
  Real GrippingRigidity = 10000.0;  // N/m; 0: nothing can be held
};

/** Thrown by CPlanarWorld::Advance() if a wheel speed is not a number; nothing has moved then. */
struct SBadWheelSpeed {
  CDynamics2DModel* Owner;
  Real Left, Right;  // m/s
};

/**
 * The bodies of one engine, and their motion, on Box2D.
 *
 * Lengths are metres outside; Box2D's units of length are inside.
 *
 * A robot that is a disc and can meet nothing during a tick needs no solver: its exact arc is
 * written in double precision, and it has no body in Box2D. Each tick finds out which robots these
 * are (CEncounters). The others are in play: they get a Box2D body with a motor of bounded force
 * that drives it along the chord of its arc, and their contacts are solved with everybody else's.
 * If at the tick's end Box2D has put one where its arc ends, to some roundings, then nothing pushed
 * it, and it takes the exact pose; else it takes Box2D's. A robot stays in play until nothing is
 * around it. Robots that are not discs are always in play.
 *
 * Everything is a function of the order of adding, removing and Advance().
 */
class CPlanarWorld {
 public:
  explicit CPlanarWorld(const SPlanarSettings& settings);
  ~CPlanarWorld();
  CPlanarWorld(const CPlanarWorld&) = delete;
  CPlanarWorld& operator=(const CPlanarWorld&) = delete;

  /** Allocates the arrays for so many bodies. */
  void Reserve(size_t immovable, size_t passive, size_t driven);
  /** Adds a body that is at rest. @param wheels speeds of a driven body's wheels; must stay valid.
   */
  void AddImmovable(const SPlanarOwner& owner, const SBodyDescription& description,
                    const SPlanarPose& pose);
  void AddPassive(const SPlanarOwner& owner, const SBodyDescription& description,
                  const SPlanarPose& pose);
  void AddDriven(const SPlanarOwner& owner, const SBodyDescription& description,
                 const SPlanarPose& pose, const Real* wheels);
  /** Takes a body out; another one may get its slot. */
  void Remove(const SPlanarHandle& handle);
  /** At the last tick's end; 0 of an immovable body. */
  SPlanarVelocity GetVelocity(const SPlanarHandle& handle) const;
  /** Gives a body another velocity; an immovable one stays where it is. */
  void SetVelocity(const SPlanarHandle& handle, const SPlanarVelocity& velocity);
  /** Was it at that pose, but for roundings, at the last tick's end? Never of an immovable body. */
  bool IsAt(const SPlanarHandle& handle, const SPlanarPose& pose) const;

  /**
   * Gives a driven body a gripper and a turret, or takes them away (null), as far as the
   * description has them; other bodies have none.
   */
  void SetManipulator(const SPlanarOwner& owner, const SBodyDescription& description,
                      CGripperEquippedEntity* gripper, CTurretEntity* turret);
  /** Does it hold something, or is it held? */
  bool IsInGrip(const SPlanarHandle& handle) const;
  /** Sets @p cluster to all bodies that are connected to a body by grips, itself included. */
  void FindCluster(const CEmbodiedEntity& body, std::vector<CEmbodiedEntity*>& cluster) const;
  /** Sets @p grips to those whose holder is in @p cluster. */
  void CopyGrips(const std::vector<CEmbodiedEntity*>& cluster,
                 std::vector<SGripTransfer>& grips) const;
  /** Restores a grip after both bodies were added. */
  void RestoreGrip(const SGripTransfer& grip, const SPlanarHandle& holder,
                   const SPlanarHandle& held);

  /** Allocates what a tick of a swarm of the present size needs. */
  void ReserveForTick();

  /** Robots of other engines that are in the way in the next Advance(); see CGhostFilter. */
  void SetGhosts(const std::vector<SGhostDisc>& ghosts);
  /** How far from the border a ghost may be that matters in the next tick, m. */
  Real ComputeGhostReach() const;

  /** Moves everything by one tick. @throws SBadWheelSpeed */
  void Advance();

  /**
   * After Advance(): takes over where driven bodies are, calling visit(const SDrivenBody&) for
   * each.
   * @param prepare  called as prepare(model, 0) and prepare(model, 1) with each owner's model, some
   *                 bodies before its visit, and some between the calls.
   */
  template <typename VISIT, typename PREPARE>
  void CommitDriven(VISIT&& visit, PREPARE&& prepare) {
    for (size_t i = 0; i < m_driven.size(); ++i) {
      if (i + 3 * kBodiesAhead < m_driven.size()) {
        Prefetch(m_driven[i + 3 * kBodiesAhead].Owner.Model, kModelBytes);
        prepare(*m_driven[i + 2 * kBodiesAhead].Owner.Model, 0);
        prepare(*m_driven[i + kBodiesAhead].Owner.Model, 1);
      }
      SDrivenBody& body = m_driven[i];
      body.Pose = body.NextPose;
      body.Velocity = body.NextVelocity;
      visit(static_cast<const SDrivenBody&>(body));
    }
  }
  /** After Advance(): calls visit(const SPassiveBody&) for each passive body; see Moved. */
  template <typename VISIT>
  void ForEachPassive(VISIT&& visit) const {
    for (const SPassiveBody& body : m_passive) {
      visit(body);
    }
  }

 private:
  b2Body& CreateBody(const SPlanarPose& pose, EPlanarKind kind, const SPlanarOwner& owner,
                     bool grippable);
  void DestroyBody(b2Body& body);
  void AddGroundFriction(b2Body& body, const SBodyDescription& description);
  void EnterPlay(UInt32 slot, const SBodyDescription* description);
  void LeavePlay(UInt32 slot);
  template <typename BODY>
  void FillSlot(std::vector<BODY>& bodies, UInt32 slot);

  // phases of Advance(), in order; see planar_world_tick.cpp
  void PlanDriven();
  void Plan(SDrivenBody& body, UInt32 slot);
  void FindEncounters();
  void UpdateObstacles();
  void ChooseWhoPlays();
  void StartTickInPlay(SInPlay& play);
  bool IsAnythingAwake() const;
  UInt32 ChooseSubsteps() const;
  UInt32 ComputeSubstepsForCrowds() const;
  int ChooseIterations(UInt32 substeps) const;
  void StepBox2D(UInt32 substeps);
  void Refine(float deepestOverlap);
  void SetMotors(UInt32 substep, UInt32 substeps);
  void AccountMotors();
  void FinishInPlay(SInPlay& play, UInt32 substeps);
  void FinishPassive();

  // ghosts; see planar_world_ghosts.cpp
  void MeetGhosts();
  void PlaceGhosts();
  void PlaceGhostFace(const SGhostDisc& ghost, const SDrivenBody& body);
  void PlaceGhostDisc(const SGhostDisc& ghost);
  b2Body& CreateGhostBody(const SPlanarPose& pose, UInt32 partner);
  void RemoveGhosts();

  // grippers and turrets; see planar_world_grips.cpp
  SManipulator* FindManipulator(const SPlanarHandle& handle);
  void RemoveManipulator(const SPlanarHandle& handle);
  void ReserveGrips(std::vector<b2Body*>& extras);
  void ReleaseAllOf(const SPlanarHandle& handle);
  UInt8& NumGrips(const SPlanarHandle& handle);
  b2Body& GetBox2DBody(const SPlanarHandle& handle);
  void StartTickOfManipulators();
  bool IsAnythingHeld() const;
  bool IsSeeking(const SManipulator& manipulator) const;
  Real ComputeSeekReach(const SManipulator& manipulator) const;
  void ExtendSeekers();
  void Grip();
  void Attach(SManipulator& manipulator, const SPlanarOwner& held, const SGripPoints& points);
  void MakeTurretBody(SManipulator& manipulator);
  static void ChangeMass(b2Body& body, float change);
  void Release(SManipulator& manipulator);
  Real ComputeSwing(const SManipulator& manipulator) const;
  float ComputeSubstepsForSwings() const;
  void SetTurretMotors(UInt32 substep, UInt32 substeps);
  void PutTurretsOnRobots();
  float ComputeGreatestGripImpulse() const;
  void FinishManipulators(float substepDuration);

  float ToUnits(Real metres) const { return static_cast<float>(metres * m_settings.UnitsPerMetre); }
  Real ToMetres(float units) const { return static_cast<Real>(units) * m_metresPerUnit; }

  SPlanarSettings m_settings;
  Real m_metresPerUnit;
  CGhostFilter m_ghostFilter;
  b2World m_world;
  b2Body* m_ground;  // what motors and ground frictions push against
  CEncounters m_encounters;
  COverlapSolver m_overlaps;
  bool m_obstaclesChanged = false;
  UInt32 m_extraSubsteps = 0;  // see planar_limits.h
  UInt32 m_calmTicks = 0;
  float m_greatestForce = 0.0F;  // kg units / s^2, in a contact or grip, in the last tick
  Real m_longestPath = 0.0;  // m, that any movable body may go in this tick

  std::vector<SImmovableBody> m_immovable;
  std::vector<SPassiveBody> m_passive;
  std::vector<SDrivenBody> m_driven;
  std::vector<SInPlay> m_inPlay;
  std::vector<SManipulator> m_manipulators;  // in the order in which they came
  Real m_seekReach = 0.0;  // m, of the sensing disc that reaches farthest out of its robot
  std::vector<SPlanarOwner> m_grippable;  // by number of body; nobody: it cannot be gripped
  // numbers of Box2D bodies, for COverlapSolver: all below m_numNumbers that are not free are in
  // use
  UInt32 m_numNumbers = 0;
  std::vector<UInt32> m_freeNumbers;

  Real m_widestMovable = 0.0;  // m: greatest bounding radius of all that ever were here
  std::vector<SGhostDisc> m_ghosts;  // of this tick
  std::vector<SGhostMeeting> m_meetings;  // of this tick
  std::vector<b2Body*> m_ghostBodies;  // while Advance() solves contacts
  std::vector<UInt32> m_nearGhost;  // slots; scratch of MeetGhosts()
};

}  // namespace argos

#endif
