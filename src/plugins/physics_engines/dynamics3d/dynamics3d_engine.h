#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_DYNAMICS3D_ENGINE_H

#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_plugin.h>

#include <memory>
#include <vector>

namespace argos {

class CDynamics3DModel;
class CEmbodiedEntity;
class CRigidWorld;
struct SGhostCylinder;
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
 * add-ons; an engine without any add-on has both.
 */
class CDynamics3DEngine : public CDescribedBodyEngine {
 public:
  CDynamics3DEngine();
  ~CDynamics3DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  /**
   * Warns of robots on wheels without gravity, and logs that gravity and a floor were added by
   * default.
   */
  void PostSpaceInit() override;

  bool IsPointContained(const CVector3& point) override;
  std::string ExplainRefusal(CEntity& entity) const override;
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  /** The wheels get the speed at which they roll. */
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  bool StopsAtWalls() const override { return true; }
  bool CanFeelGhosts() const override { return true; }
  Real GetGhostReach() const override;
  /** The only engine of a simulation spreads its free robots over the pool. */
  bool UsesThreadPool() const override;

  /** For add-ons: the acceleration of free bodies, m/s^2; initially 0. */
  void SetGravity(const CVector3& gravity);
  const CVector3& GetGravity() const { return m_gravity; }
  /** For add-ons: a plane at a height (m) that supports the bodies above it. @param friction >= 0.
   */
  void AddGroundPlane(Real height, Real friction);
  /** Friction coefficient of bodies and, unless an add-on sets another, of the floor. */
  Real GetDefaultFriction() const;
  /** For add-ons: length of the present substep, s. */
  Real GetSubstep() const;
  /** Substeps of the last tick: GetIterations(), or more where something was fast. */
  UInt32 GetNumSubsteps() const;

  /** For models: the gripper or the turret of their robot was added or removed. */
  void UpdateManipulator(CDynamics3DModel& model);
  /** For models that are pushed between ticks. */
  void ActivateBody(SRigidBody& body);

 private:
  void UpdateWorld() override;
  void DropWorld() override;
  void InitPlugins(TConfigurationNode& tree);
  bool HasWorld() const override { return m_world != nullptr; }
  bool Accepts(const CEmbodiedEntity&) const override { return true; }
  void CheckBody(CEmbodiedEntity& body) const override;
  std::unique_ptr<CDescribedBodyModel> CreateModel(CEmbodiedEntity& body,
                                                   const CRecordedBody* recorded) override;
  void Enter(CDescribedBodyModel& model) override;
  void Leave(CDescribedBodyModel& model) override;
  void Reposition(CDescribedBodyModel& model) override;
  bool DefersMoves() const override { return true; }
  bool IsAtLastPose(const CDescribedBodyModel& model) const override;
  /**
   * Sets a body down on the plane of a 2D engine if it is nearly upright and nearly at its height;
   * otherwise the body stays here until it is.
   */
  bool PrepareTransfer(CDescribedBodyModel& model) override;
  bool MayMoveTo(const CPhysicsEngine& next, const CDescribedBodyModel& model) const override;
  void PrepareFor(const CPhysicsEngine& next, CDescribedBodyModel& model) override;
  void Adopt(CDescribedBodyModel& model) override;
  void FindCluster(CEmbodiedEntity& body, TBodies& cluster) const override;
  void CopyGrips(const TBodies& cluster, std::vector<SGripTransfer>& grips) const override;
  void RestoreGrip(const SGripTransfer& grip) override;

  void SetDefaults();
  void LogDefaults() const;
  void Build();
  void BuildWalls();
  void AddToWorld(CDynamics3DModel& model);
  void PlaceAtAnchor(CDynamics3DModel& model, const SRigidMotion& motion);
  void WriteBack();
  void WriteBack(CDynamics3DModel& model);
  void UpdatePlugins();
  void UpdateGhosts();
  bool HasLeft(const CVector3& point);
  void ReportFailures();
  void WarnStranded(const CDynamics3DModel& model, const CPhysicsEngine& plane);
  CDynamics3DModel& GetModel(const CEmbodiedEntity& body) const;

  std::unique_ptr<SRigidSettings> m_settings;
  CVector3 m_gravity;  // m/s^2
  std::vector<SGroundPlane> m_planes;
  std::vector<std::unique_ptr<CDynamics3DPlugin>> m_plugins;  // in document order
  std::unique_ptr<CRigidWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<SWallSlab> m_walls;  // descriptions of fixed bodies of the world
  std::vector<SGhostCylinder> m_ghostCylinders;
  std::vector<UInt8> m_haveLeft;  // bodies outside of the region, by SRigidBody::Number
  bool m_hasDefaults = false;  // gravity and floor, because there is no add-on
  bool m_hasReported = false;
  bool m_hasWarnedStranded = false;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/controllable_entity.h>
#endif

#endif
