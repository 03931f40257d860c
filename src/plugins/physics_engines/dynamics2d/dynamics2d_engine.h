#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

#include <memory>
#include <vector>

namespace argos {

class CDynamics2DModel;
class CPlanarWorld;
struct SPlanarPose;
struct SPlanarSettings;

/**
 * Rigid bodies on a horizontal plane, on Box2D: robots push, slide along walls, stall and slip.
 *
 * The README beside this file gives model, integrator, limits and measured accuracy; `argos3 -q
 * dynamics2d` every XML parameter. Bodies are built from SBodyDescription; third-party models that
 * call a physics library directly are not supported.
 */
class CDynamics2DEngine : public CPlanarEngine {
 public:
  CDynamics2DEngine();
  ~CDynamics2DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  void Update() override;

  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  Real GetGhostReach() const override;

  /** Stiffness of grippers, N/m. */
  Real GetGrippingRigidity() const { return m_grippingRigidity; }

  void UpdateManipulator(CPlanarModel& model) override;

 private:
  bool HasWorld() const override { return m_world != nullptr; }
  std::unique_ptr<CDescribedBodyModel> CreateModel(CEmbodiedEntity& body) override;
  void Enter(CDescribedBodyModel& model) override;
  void Leave(CDescribedBodyModel& model) override;
  /** Contacts and grips are lost. */
  void Reposition(CDescribedBodyModel& model) override;
  bool DefersMoves() const override { return true; }
  bool IsAtLastPose(const CDescribedBodyModel& model) const override;
  void Adopt(CDescribedBodyModel& model) override;
  void FindCluster(CEmbodiedEntity& body, TBodies& cluster) const override;
  void CopyGrips(const TBodies& cluster, std::vector<SGripTransfer>& grips) const override;
  void RestoreGrip(const SGripTransfer& grip) override;
  CDynamics2DModel& GetModel(const CEmbodiedEntity& body) const;
  void Build();
  Real ChooseScale() const;
  void AddToWorld(CDynamics2DModel& model);
  void WriteBack(CDynamics2DModel& model, const SPlanarPose& pose);

  Real m_grippingRigidity = 10000.0;  // N/m
  std::unique_ptr<SPlanarSettings> m_settings;
  std::unique_ptr<CPlanarWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<SPlanarHandle> m_walls;  // of the region
};

}  // namespace argos

#endif
