#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_ENGINE_H

#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

#include <memory>
#include <vector>

namespace argos {

class CKinematicWorld;
class CKinematics2DModel;
struct SGroundFriction;

/**
 * Robots that drive on a plane without momentum: the engine for the largest swarms.
 *
 * Robots follow the arcs of their wheels, do not overlap each other or walls, and push objects.
 * The README beside this file gives model, limits and measured accuracy; `argos3 -q kinematics2d`
 * every XML parameter.
 */
class CKinematics2DEngine : public CPlanarEngine {
 public:
  CKinematics2DEngine();
  ~CKinematics2DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  /** @throws CARGoSException if a wheel speed is not a number, or a gripper is locked. */
  bool UsesThreadPool() const override { return true; }

  /** Only for robots: the motion that their drives command. */
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  /** Only of robots: the last command. */
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  Real GetGhostReach() const override;

  void UpdateManipulator(CPlanarModel& model) override;

 private:
  void UpdateWorld() override;
  void DropWorld() override;
  bool HasWorld() const override { return m_world != nullptr; }
  std::unique_ptr<CDescribedBodyModel> CreateModel(CEmbodiedEntity& body,
                                                   const CRecordedBody* recorded) override;
  void Enter(CDescribedBodyModel& model) override;
  void Leave(CDescribedBodyModel& model) override;
  void Reposition(CDescribedBodyModel& model) override;
  void Build();
  void AddToWorld(CKinematics2DModel& model);
  void Advance();
  void UpdateManipulators();
  void WriteBackDiscs();
  void WriteBackDiscs(size_t begin, size_t end);
  void WriteBackSolids();
  bool HasLeft(const CEmbodiedEntity& body);

  std::unique_ptr<SGroundFriction> m_boxFriction, m_cylinderFriction;
  std::unique_ptr<CKinematicWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<CKinematics2DModel*> m_manipulators;  // models with a gripper or a turret
  std::vector<UInt8> m_hasLeft;  // (discs by slot): left the region in this tick
};

}  // namespace argos

#endif
