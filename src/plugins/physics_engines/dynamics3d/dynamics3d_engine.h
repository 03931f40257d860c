#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_ENGINE_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_plugin.h>

#include <memory>
#include <vector>

namespace argos {

class CDynamics3DModel;
class CEmbodiedEntity;
class CRigidWorld;
struct SGhostCylinder;
struct SRigidGripToMove;
struct SGroundPlane;
struct SRigidBody;
struct SRigidMotion;
struct SRigidSettings;

/**
 * Rigid bodies in three dimensions, on the Open Dynamics Engine: robots roll on their wheels,
 * climb, push, stack and topple, or fly.
 *
 * The README beside this file gives model, integrator, limits and measured accuracy; `argos3 -q
 * dynamics3d` every XML parameter. Bodies are built from SBodyDescription. Gravity and a floor are
 * add-ons; an engine whose element has no add-on at all has both.
 */
class CDynamics3DEngine : public CPhysicsEngine {
 public:
  CDynamics3DEngine();
  ~CDynamics3DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  void Update() override;
  /**
   * Warns of robots on wheels that no gravity presses on the ground, and tells of gravity and floor
   * that no add-on has asked for.
   */
  void PostSpaceInit() override;

  bool IsPointContained(const CVector3& point) override;
  size_t GetNumPhysicsModels() override { return m_models.size(); }
  /**
   * Adds the body of a root entity, if it has a description.
   * @throws CARGoSException if the description is of no possible body, or a component is missing
   * that it needs.
   */
  bool AddEntity(CEntity& entity) override;
  std::string ExplainRefusal(CEntity& entity) const override;
  bool RemoveEntity(CEntity& entity) override;
  /**
   * A body that changes from one engine of this type to another keeps how it moves. What hangs
   * together in grips changes together, when the one with the lowest index of entity leaves. What
   * goes to an engine that is a plane is set down on it if it stands nearly upright and nearly at
   * its height, and otherwise stays here until it does.
   */
  void TransferEntity(CEmbodiedEntity& body) override;
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  /** Wheels then turn as fast as the ground passes below them. */
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  /** Nothing: all bodies are in the space's index. */
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData&, const CRay3&) const override {}
  bool HasBodiesOutsideIndex() const override { return false; }
  bool StopsAtWalls() const override { return true; }
  bool CanFeelGhosts() const override { return true; }
  Real GetGhostReach() const override;

  /** For add-ons: the acceleration of what nothing holds, m/s^2; at first 0. */
  void SetGravity(const CVector3& gravity);
  const CVector3& GetGravity() const { return m_gravity; }
  /** For add-ons: a plane at a height (m) that holds up what is above it. @param friction >= 0. */
  void AddGroundPlane(Real height, Real friction);
  /** Friction coefficient of bodies and, unless an add-on says otherwise, of the floor. */
  Real GetDefaultFriction() const;
  /** For add-ons: length of the substep that is under way, s. */
  Real GetSubstep() const;
  /** Substeps of the last tick: GetIterations(), or more where something was fast. */
  UInt32 GetNumSubsteps() const;

  /** For models: puts a body, at rest, where its origin anchor is. */
  void Replace(CDynamics3DModel& model);
  /** For models: the same at the start of the next tick, if the anchor is elsewhere by then. */
  void MarkDisplaced(CDynamics3DModel& model);
  /** For models: their robot has got, or lost, a gripper or turret. */
  void UpdateManipulator(CDynamics3DModel& model);

 private:
  void InitPlugins(TConfigurationNode& tree);
  void TakeDefaults();
  void TellOfDefaults() const;
  void Build();
  void BuildWalls();
  void AddToWorld(CDynamics3DModel& model);
  void PlaceAtAnchor(CDynamics3DModel& model, const SRigidMotion& motion);
  void WriteBack(CDynamics3DModel& model);
  void ReplaceDisplaced();
  void ForgetDisplaced(CDynamics3DModel& model);
  void UpdatePlugins();
  void TakeGhosts();
  bool HasLeft(const CVector3& point);
  void ReportFailures();
  CDynamics3DEngine* FindNext(const CEmbodiedEntity& body) const;
  bool PrepareExit(CDynamics3DModel& model);
  void TellOfStranded(const CDynamics3DModel& model, const CPhysicsEngine& plane);
  bool LeadsItsCluster(const CDynamics3DModel& model);
  void TransferCluster(const CDynamics3DModel& model, CDynamics3DEngine& next);

  std::unique_ptr<SRigidSettings> m_settings;
  CVector3 m_gravity;  // m/s^2
  std::vector<SGroundPlane> m_planes;
  std::vector<std::unique_ptr<CDynamics3DPlugin>> m_plugins;  // in document order
  std::vector<std::unique_ptr<CDynamics3DModel>> m_models;
  std::vector<CDynamics3DModel*> m_displaced;
  std::unique_ptr<CRigidWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<SWallSlab> m_walls;  // what fixed bodies of the world are made of
  std::vector<SGhostCylinder> m_ghostCylinders;
  bool m_hasDefaults = false;  // gravity and floor, because there is no add-on
  bool m_hasReported = false;
  bool m_hasToldOfStranded = false;
  // while bodies in grips change engines
  std::vector<SRigidBody*> m_cluster;
  std::vector<SRigidGripToMove> m_grips;
};

}  // namespace argos

#endif
