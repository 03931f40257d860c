#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>

#include <memory>
#include <vector>

namespace argos {

class CDynamics2DModel;
class CEmbodiedEntity;
class CPlanarWorld;
struct SGhostDisc;
struct SGripToMove;
struct SPlanarOwner;
struct SPlanarPose;
struct SPlanarSettings;

/**
 * Rigid bodies on a horizontal plane, on Box2D: robots push, slide along walls, stall and slip.
 *
 * The README beside this file gives model, integrator, limits and measured accuracy; `argos3 -q
 * dynamics2d` every XML parameter. Third-party models that drive a physics library directly have no
 * place here: bodies are built from SBodyDescription.
 */
class CDynamics2DEngine : public CPhysicsEngine {
 public:
  CDynamics2DEngine();
  ~CDynamics2DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  void Update() override;

  size_t GetNumPhysicsModels() override { return m_models.size(); }
  /**
   * Adds the body of a root entity, if it has a description.
   * @return false if it has none, or is not at the height of this plane: another engine may take
   * it.
   * @throws CARGoSException if the description is of no possible body; if a robot has a drive but
   * no wheels.
   */
  bool AddEntity(CEntity& entity) override;
  std::string ExplainRefusal(CEntity& entity) const override;
  bool RemoveEntity(CEntity& entity) override;
  /**
   * A body that changes from one engine of this type to another keeps its velocity. What hangs
   * together in grips changes together, when the one with the lowest index of entity leaves.
   */
  void TransferEntity(CEmbodiedEntity& body) override;
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  bool StopsAtWalls() const override { return true; }
  /** Those that drive on this plane are in the way of what is here. */
  bool CanFeelGhosts() const override { return true; }
  Real GetGhostReach() const override;
  /** The plane. */
  std::pair<Real, Real> GetHeightSpan() const override { return {m_elevation, m_elevation}; }
  /** Nothing: all bodies are in the space's index. */
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData&, const CRay3&) const override {}
  bool HasBodiesOutsideIndex() const override { return false; }

  /** Height of the plane, m. */
  Real GetElevation() const { return m_elevation; }
  /** Stiffness of grippers, N/m. */
  Real GetGrippingRigidity() const { return m_grippingRigidity; }

  /** For models: puts a body, at rest, where its origin anchor is; contacts and grips are lost. */
  void Replace(CDynamics2DModel& model);
  /** For models: the same at the start of the next tick, if the anchor is elsewhere by then. */
  void MarkDisplaced(CDynamics2DModel& model);
  /** For models: their robot has got, or lost, a gripper or turret. */
  void UpdateManipulator(CDynamics2DModel& model);

 private:
  bool IsAtHeight(const CEmbodiedEntity& body) const;
  void Build();
  Real ChooseScale() const;
  void AddToWorld(CDynamics2DModel& model);
  void WriteBack(CDynamics2DModel& model, const SPlanarPose& pose);
  CDynamics2DEngine* FindNext(CEmbodiedEntity& body) const;
  void ReplaceDisplaced();
  void ForgetDisplaced(CDynamics2DModel& model);
  bool LeadsItsCluster(const CDynamics2DModel& model);
  void TransferCluster(CDynamics2DModel& model, CDynamics2DEngine& next);
  void TakeOver(CDynamics2DModel& model);
  void AddModel(std::unique_ptr<CDynamics2DModel> model);
  std::unique_ptr<CDynamics2DModel> TakeOut(CDynamics2DModel& model);

  Real m_elevation = 0.0;  // m
  Real m_grippingRigidity = 10000.0;  // N/m
  std::unique_ptr<SPlanarSettings> m_settings;
  std::unique_ptr<CPlanarWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<std::unique_ptr<CDynamics2DModel>> m_models;
  std::vector<CDynamics2DModel*> m_displaced;
  std::vector<SPlanarHandle> m_walls;  // of the region
  std::vector<SGhostDisc> m_ghostDiscs;  // of this tick
  // while bodies in grips change engines
  std::vector<SPlanarOwner> m_cluster;
  std::vector<SGripToMove> m_grips;
};

}  // namespace argos

#endif
