#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_POINTMASS3D_ENGINE_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/entity_operation.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_model.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

class CDrivers;
class CFlyers;
class CPointMass3DBody;
struct SFlightPose;

/**
 * Point masses in space: flying robots with their own controllers, robots on wheels that pass
 * through everything, and objects that stay where they were put.
 *
 * The README beside this file gives model, integrator, limits and accuracy; `argos3 -q pointmass3d`
 * every XML parameter. Bodies are built from SBodyDescription; users may register models of their
 * own (CPointMass3DModel).
 */
class CPointMass3DEngine : public CDescribedBodyEngine {
 public:
  CPointMass3DEngine();
  ~CPointMass3DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;

  size_t GetNumPhysicsModels() override {
    return CDescribedBodyEngine::GetNumPhysicsModels() + m_userModels.size();
  }
  /**
   * Adds the body of a root entity: by the operation that a user has registered for its class, else
   * from its description.
   * @return false if there is neither.
   * @throws CARGoSException if the description is impossible, if a component is missing that it
   *         needs, or if the arena is too small for a flying body.
   */
  bool AddEntity(CEntity& entity) override;
  std::string ExplainRefusal(CEntity& entity) const override;
  bool RemoveEntity(CEntity& entity) override;
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  /** Only for flying bodies: wheels determine the motion of the others. */
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  /** Moves bodies out of walls after each tick. */
  bool StopsAtWalls() const override { return true; }
  /** Only users' models: all other bodies are in the space's index. */
  void CheckIntersectionWithRay(TEmbodiedEntityIntersectionData& data,
                                const CRay3& ray) const override;
  bool HasBodiesOutsideIndex() const override { return m_numOutsideIndex > 0; }

  /** m/s^2, along z: negative is down. */
  Real GetGravity() const { return m_gravity; }
  /**
   * Substeps of a tick for flying bodies: GetIterations(), or more where a control loop of one of
   * them needs it. Users' models are stepped GetIterations() times.
   */
  UInt32 GetSubsteps();

  /** For registered operations: takes ownership of a user's model. @param id  of its root entity.
   */
  void AddPhysicsModel(const std::string& id, CPointMass3DModel& model);
  /** Deletes a user's model. @throws CARGoSException if there is none of that id. */
  void RemovePhysicsModel(const std::string& id);

  /**
   * For models.
   * @return true if the bounding box of @p model shares a point with that of another body here.
   */
  bool HasOverlap(const CPhysicsModel& model) const;

 private:
  void UpdateWorld() override;
  /** Does nothing: the arrays of bodies are complete at any time. */
  void DropWorld() override {}
  struct SUserModel {
    std::string Id;
    std::unique_ptr<CPointMass3DModel> Model;
  };

  bool HasWorld() const override { return true; }
  bool Accepts(const CEmbodiedEntity& body) const override;
  void CheckBody(CEmbodiedEntity& body) const override;
  std::unique_ptr<CDescribedBodyModel> CreateModel(CEmbodiedEntity& body,
                                                   const CRecordedBody* recorded) override;
  void Enter(CDescribedBodyModel& model) override;
  void Leave(CDescribedBodyModel& model) override;
  void Reposition(CDescribedBodyModel& model) override;
  /** The state of the controllers is transferred, too. */
  void Adopt(CDescribedBodyModel& model) override;
  void CheckFlyer(const CEmbodiedEntity& body) const;
  std::pair<CVector3, CVector3> ComputeFlightSpace(const CEmbodiedEntity& body) const;
  CPointMass3DBody* FindBody(const CEmbodiedEntity& body) const;
  void CountBodiesOutsideIndex();
  void HoldInsideWalls();
  void UpdateUserModels();
  void WriteBack(CPointMass3DBody& body, const CVector3& position, Real halfCos, Real halfSin);

  Real m_gravity = -9.81;  // m/s^2
  bool m_moveAsArgos3 = false;  // with its defects, to repeat experiments
  std::unique_ptr<CFlyers> m_flyers;
  std::unique_ptr<CDrivers> m_drivers;
  std::vector<SUserModel> m_userModels;
  size_t m_numOutsideIndex = 0;  // of users' models
  UInt32 m_substeps = 0;  // 0: not computed yet from the flying bodies
};

/** Kind of operation: gives an entity a model in this engine. */
class CPointMass3DOperationAddEntity
    : public CEntityOperation<CPointMass3DOperationAddEntity, CPointMass3DEngine,
                              SOperationOutcome> {};
/** Kind of operation: removes an entity's model from this engine and deletes it. */
class CPointMass3DOperationRemoveEntity
    : public CEntityOperation<CPointMass3DOperationRemoveEntity, CPointMass3DEngine,
                              SOperationOutcome> {};

}  // namespace argos

#define REGISTER_POINTMASS3D_OPERATION(ACTION, OPERATION, ENTITY) \
  REGISTER_ENTITY_OPERATION(ACTION, CPointMass3DEngine, OPERATION, SOperationOutcome, ENTITY)

/** ENTITY, whose "body" is moved by a new MODEL(engine, entity). Inside namespace argos. */
#define REGISTER_STANDARD_POINTMASS3D_OPERATION_ADD_ENTITY(ENTITY, MODEL)                          \
  class CPointMass3DOperationAdd##ENTITY : public CPointMass3DOperationAddEntity {                 \
   public:                                                                                         \
    SOperationOutcome ApplyTo(CPointMass3DEngine& engine, ENTITY& entity) {                        \
      MODEL& model = *std::make_unique<MODEL>(engine, entity).release();                           \
      engine.AddPhysicsModel(entity.GetId(), model);                                               \
      model.GetEmbodiedEntity().AddPhysicsModel(engine.GetId(), model);                            \
      return SOperationOutcome(true);                                                              \
    }                                                                                              \
  };                                                                                               \
  REGISTER_POINTMASS3D_OPERATION(CPointMass3DOperationAddEntity, CPointMass3DOperationAdd##ENTITY, \
                                 ENTITY)

#define REGISTER_STANDARD_POINTMASS3D_OPERATION_REMOVE_ENTITY(ENTITY)                           \
  class CPointMass3DOperationRemove##ENTITY : public CPointMass3DOperationRemoveEntity {        \
   public:                                                                                      \
    SOperationOutcome ApplyTo(CPointMass3DEngine& engine, ENTITY& entity) {                     \
      entity.template GetComponent<CEmbodiedEntity>("body").RemovePhysicsModel(engine.GetId()); \
      engine.RemovePhysicsModel(entity.GetId());                                                \
      return SOperationOutcome(true);                                                           \
    }                                                                                           \
  };                                                                                            \
  REGISTER_POINTMASS3D_OPERATION(CPointMass3DOperationRemoveEntity,                             \
                                 CPointMass3DOperationRemove##ENTITY, ENTITY)

#define REGISTER_STANDARD_POINTMASS3D_OPERATIONS_ON_ENTITY(ENTITY, MODEL) \
  REGISTER_STANDARD_POINTMASS3D_OPERATION_ADD_ENTITY(ENTITY, MODEL)       \
  REGISTER_STANDARD_POINTMASS3D_OPERATION_REMOVE_ENTITY(ENTITY)

#endif
