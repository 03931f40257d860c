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
 * Robots follow the arcs of their wheels, are kept out of each other and of walls, and push things.
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
  void Update() override;
  bool UsesThreadPool() const override { return true; }

  /** Asks for no memory if the next engine is of this type too. */
  void TransferEntity(CEmbodiedEntity& body) override;
  /** Of robots: as their wheels turn. */
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  Real GetGhostReach() const override;

  /** For models: puts a body where its origin anchor is. */
  void Replace(CKinematics2DModel& model);
  void UpdateManipulator(CPlanarModel& model) override;

 private:
  std::unique_ptr<CPlanarModel> MakeModel(CEmbodiedEntity& body, const Real* wheels) override;
  void RemakeModel(CPlanarModel& model, CEmbodiedEntity& body, const Real* wheels) override;
  void Enter(CPlanarModel& model) override;
  void Leave(CPlanarModel& model) override;
  void Build();
  void AddToWorld(CKinematics2DModel& model);
  void Advance();
  void UseManipulators();
  void WriteBackDiscs();
  void WriteBackDiscs(size_t begin, size_t end);
  void WriteBackSolids();
  bool HasLeft(const CEmbodiedEntity& body);

  std::unique_ptr<SGroundFriction> m_boxFriction, m_cylinderFriction;
  std::unique_ptr<CKinematicWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<CKinematics2DModel*> m_manipulators;  // those with a gripper or a turret
  std::vector<UInt8> m_hasLeft;  // (discs by slot): the region of this engine, in this tick
};

}  // namespace argos

#endif
