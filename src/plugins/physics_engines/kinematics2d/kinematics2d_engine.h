#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATICS2D_ENGINE_H

#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <memory>
#include <vector>

namespace argos {

class CEmbodiedEntity;
class CKinematicWorld;
class CKinematics2DModel;
struct SGhostDisc;
struct SGroundFriction;

/**
 * Robots that drive on a plane without momentum: the engine for the largest swarms.
 *
 * Robots follow the arcs of their wheels, are kept out of each other and of walls, and push things.
 * The README beside this file gives model, limits and measured accuracy; `argos3 -q kinematics2d`
 * every XML parameter.
 */
class CKinematics2DEngine : public CPhysicsEngine {
 public:
  CKinematics2DEngine();
  ~CKinematics2DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;
  /** @throws CARGoSException if a wheel speed is not a number, or a gripper is locked. */
  void Update() override;
  bool UsesThreadPool() const override { return true; }

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
  /** Asks for no memory if the next engine is of this type too. */
  void TransferEntity(CEmbodiedEntity& body) override;
  /** Of robots: as their wheels turn. */
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
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

  /** For models: puts a body where its origin anchor is. */
  void Replace(CKinematics2DModel& model);
  /** For models: their robot has got, or lost, a gripper or turret. */
  void UpdateManipulator(CKinematics2DModel& model);

 private:
  void Build();
  void AddToWorld(CKinematics2DModel& model);
  void AddModel(std::unique_ptr<CKinematics2DModel> model);
  std::unique_ptr<CKinematics2DModel> TakeOut(CKinematics2DModel& model);
  CKinematics2DEngine* FindNext(CEmbodiedEntity& body) const;
  void TakeOver(CKinematics2DModel& model);
  void Advance();
  void UseManipulators();
  void TakeGhosts();
  void WriteBackDiscs();
  void WriteBackDiscs(size_t begin, size_t end);
  void WriteBackSolids();
  bool HasLeft(const CEmbodiedEntity& body);

  Real m_elevation = 0.0;  // m
  std::unique_ptr<SGroundFriction> m_boxFriction, m_cylinderFriction;
  std::unique_ptr<CKinematicWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<std::unique_ptr<CKinematics2DModel>> m_models;
  std::vector<CKinematics2DModel*> m_manipulators;  // those with a gripper or a turret
  std::vector<UInt8> m_hasLeft;  // (discs by slot): the region of this engine, in this tick
  std::vector<SGhostDisc> m_ghostDiscs;  // of this tick
};

}  // namespace argos

#endif
