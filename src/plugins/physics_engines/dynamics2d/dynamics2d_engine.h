#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

#include <memory>
#include <vector>

namespace argos {

class CDynamics2DModel;
class CPlanarWorld;
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
class CDynamics2DEngine : public CPlanarEngine {
 public:
  CDynamics2DEngine();
  ~CDynamics2DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  void Update() override;

  /**
   * A body that changes from one engine of this type to another keeps its velocity. What hangs
   * together in grips changes together, when the one with the lowest index of entity leaves.
   */
  void TransferEntity(CEmbodiedEntity& body) override;
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  Real GetGhostReach() const override;

  /** Stiffness of grippers, N/m. */
  Real GetGrippingRigidity() const { return m_grippingRigidity; }

  /** For models: puts a body, at rest, where its origin anchor is; contacts and grips are lost. */
  void Replace(CDynamics2DModel& model);
  /** For models: the same at the start of the next tick, if the anchor is elsewhere by then. */
  void MarkDisplaced(CDynamics2DModel& model);
  void UpdateManipulator(CPlanarModel& model) override;

 private:
  std::unique_ptr<CPlanarModel> MakeModel(CEmbodiedEntity& body, const Real* wheels) override;
  void RemakeModel(CPlanarModel& model, CEmbodiedEntity& body, const Real* wheels) override;
  void Enter(CPlanarModel& model) override;
  void Leave(CPlanarModel& model) override;
  void Build();
  Real ChooseScale() const;
  void AddToWorld(CDynamics2DModel& model);
  void WriteBack(CDynamics2DModel& model, const SPlanarPose& pose);
  void ReplaceDisplaced();
  void ForgetDisplaced(CDynamics2DModel& model);
  bool LeadsItsCluster(const CDynamics2DModel& model);
  void TransferCluster(CDynamics2DModel& model, CDynamics2DEngine& next);

  Real m_grippingRigidity = 10000.0;  // N/m
  std::unique_ptr<SPlanarSettings> m_settings;
  std::unique_ptr<CPlanarWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<CDynamics2DModel*> m_displaced;
  std::vector<SPlanarHandle> m_walls;  // of the region
  // while bodies in grips change engines
  std::vector<SPlanarOwner> m_cluster;
  std::vector<SGripToMove> m_grips;
};

}  // namespace argos

#endif
