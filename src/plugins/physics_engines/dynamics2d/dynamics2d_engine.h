#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_DYNAMICS2D_ENGINE_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/entity_operation.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_handle.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/recorded_bodies.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

#include <memory>
#include <string>
#include <vector>

namespace argos {

class CDynamics2DBody;
class CDynamics2DModel;
class CPlanarWorld;
class CThreadPool;
struct SPlanarPose;
struct SPlanarSettings;

/**
 * Rigid bodies on a horizontal plane: robots push, slide along walls, stall and slip.
 *
 * The README beside this file gives model, integrator, limits and measured accuracy; `argos3 -q
 * dynamics2d` every XML parameter. Bodies are built from SBodyDescription. For entities without
 * one, users may register models as for ARGoS 3 (CDynamics2DModel), from which descriptions are
 * made.
 */
class CDynamics2DEngine : public CPlanarEngine {
 public:
  /** For users' models: values of cpShape::collision_type. Engines ignore them. */
  enum EShapeType { SHAPE_NORMAL = 0, SHAPE_GRIPPABLE = 1, SHAPE_GRIPPER = 2 };
  /** For users' models: values of cpShape::layers. Engines ignore them. */
  enum ELayerType : cpLayers { LAYER_FROZEN = 0, LAYER_NORMAL = CP_ALL_LAYERS };

  CDynamics2DEngine();
  ~CDynamics2DEngine() override;

  void Init(TConfigurationNode& tree) override;
  void Reset() override;
  void Destroy() override;

  bool UsesThreadPool() const override;
  bool GetMotion(const CEmbodiedEntity& body, SBodyMotion& motion) const override;
  void SetMotion(CEmbodiedEntity& body, const SBodyMotion& motion) override;
  Real GetGhostReach() const override;

  /** Stiffness of grippers, N/m. */
  Real GetGrippingRigidity() const { return m_grippingRigidity; }

  void UpdateManipulator(CPlanarModel& model) override;

  /*
   * For users' models.
   */
  /** Records what is added; nothing moves there. */
  cpSpace* GetPhysicsSpace() { return &m_space; }
  cpBody* GetGroundBody() { return &m_groundBody; }
  /** Of `<friction>`, N or N m. */
  cpFloat GetBoxLinearFriction() const;
  cpFloat GetBoxAngularFriction() const;
  cpFloat GetCylinderLinearFriction() const;
  cpFloat GetCylinderAngularFriction() const;
  /** N/m, >= 0; before the first tick. */
  void SetGrippingRigidity(Real rigidity);
  /** Always 1: free bodies keep their velocity. */
  Real GetDamping() const { return 1.0; }
  /** @throws CARGoSException unless the damping is 1. */
  void SetDamping(Real damping);
  /** @throws CARGoSException unless it is 0: the plane is horizontal. */
  void SetGravity(const CVector2& gravity);
  /** The position of a body at the height of @p original, m. */
  void PositionPhysicsToSpace(CVector3& position, const CVector3& original, const cpBody* body);
  void OrientationPhysicsToSpace(CQuaternion& orientation, const cpBody* body);

  /** For registered operations: takes ownership of a user's model. @param id  of its root entity.
   */
  void AddPhysicsModel(const std::string& id, CDynamics2DModel& model);
  /**
   * Removes the body of an entity that a user's model describes.
   * @throws CARGoSException if there is none of that id.
   */
  void RemovePhysicsModel(const std::string& id);

  /** @return true if a user has registered a model for the class of that entity. */
  static bool HasUserModel(CEntity& root);
  /** Constructs the user's model of an entity. @throws CARGoSException if that fails. */
  std::unique_ptr<CDynamics2DModel> MakeUserModel(CEntity& root);

 private:
  void UpdateWorld() override;
  void DropWorld() override;
  bool HasWorld() const override { return m_world != nullptr; }
  std::unique_ptr<CDescribedBodyModel> CreateModel(CEmbodiedEntity& body,
                                                   const CRecordedBody* recorded) override;
  void Enter(CDescribedBodyModel& model) override;
  void Leave(CDescribedBodyModel& model) override;
  /** Contacts and grips are lost. */
  void Reposition(CDescribedBodyModel& model) override;
  bool DefersMoves() const override { return true; }
  bool IsAtLastPose(const CDescribedBodyModel& model) const override;
  void FindCluster(CEmbodiedEntity& body, TBodies& cluster) const override;
  void CopyGrips(const TBodies& cluster, std::vector<SGripTransfer>& grips) const override;
  void RestoreGrip(const SGripTransfer& grip) override;
  CDynamics2DBody& GetModel(const CEmbodiedEntity& body) const;
  void Build();
  Real ComputeSmallestRadius() const;
  void AddToWorld(CDynamics2DBody& model);
  bool WriteBack(CDynamics2DBody& model, const SPlanarPose& pose, Real radius);
  void WriteBackDriven(CThreadPool& pool);
  void ScheduleIfLeading(CEmbodiedEntity& body);

  Real m_grippingRigidity = 10000.0;  // N/m
  std::unique_ptr<SPlanarSettings> m_settings;
  std::unique_ptr<CThreadPool> m_alone;  // of one thread: where engines share the simulator's
  std::vector<UInt8> m_hasLeft;  // by slot of driven bodies
  std::unique_ptr<CPlanarWorld> m_world;  // null: to be built from the models in the next tick
  std::vector<SPlanarHandle> m_walls;  // of the region
  // for users' models
  cpSpace m_space;
  cpBody m_groundBody;
  std::unique_ptr<CDynamics2DModel> m_handedOver;  // by AddPhysicsModel(), in MakeUserModel()
};

/** Kind of operation: gives an entity a user's model in this engine. */
class CDynamics2DOperationAddEntity
    : public CEntityOperation<CDynamics2DOperationAddEntity, CDynamics2DEngine, SOperationOutcome> {
};
/** Kind of operation: removes an entity's model from this engine. */
class CDynamics2DOperationRemoveEntity
    : public CEntityOperation<CDynamics2DOperationRemoveEntity, CDynamics2DEngine,
                              SOperationOutcome> {};

}  // namespace argos

#define REGISTER_DYNAMICS2D_OPERATION(ACTION, OPERATION, ENTITY) \
  REGISTER_ENTITY_OPERATION(ACTION, CDynamics2DEngine, OPERATION, SOperationOutcome, ENTITY)

/** ENTITY, whose "body" a new MODEL(engine, entity) describes. Inside namespace argos. */
#define REGISTER_STANDARD_DYNAMICS2D_OPERATION_ADD_ENTITY(ENTITY, MODEL)                          \
  class CDynamics2DOperationAdd##ENTITY : public CDynamics2DOperationAddEntity {                  \
   public:                                                                                        \
    SOperationOutcome ApplyTo(CDynamics2DEngine& engine, ENTITY& entity) {                        \
      engine.AddPhysicsModel(entity.GetId(), *std::make_unique<MODEL>(engine, entity).release()); \
      return SOperationOutcome(true);                                                             \
    }                                                                                             \
  };                                                                                              \
  REGISTER_DYNAMICS2D_OPERATION(CDynamics2DOperationAddEntity, CDynamics2DOperationAdd##ENTITY,   \
                                ENTITY)

#define REGISTER_STANDARD_DYNAMICS2D_OPERATION_REMOVE_ENTITY(ENTITY)                   \
  class CDynamics2DOperationRemove##ENTITY : public CDynamics2DOperationRemoveEntity { \
   public:                                                                             \
    SOperationOutcome ApplyTo(CDynamics2DEngine& engine, ENTITY& entity) {             \
      engine.RemovePhysicsModel(entity.GetId());                                       \
      return SOperationOutcome(true);                                                  \
    }                                                                                  \
  };                                                                                   \
  REGISTER_DYNAMICS2D_OPERATION(CDynamics2DOperationRemoveEntity,                      \
                                CDynamics2DOperationRemove##ENTITY, ENTITY)

#define REGISTER_STANDARD_DYNAMICS2D_OPERATIONS_ON_ENTITY(ENTITY, MODEL) \
  REGISTER_STANDARD_DYNAMICS2D_OPERATION_ADD_ENTITY(ENTITY, MODEL)       \
  REGISTER_STANDARD_DYNAMICS2D_OPERATION_REMOVE_ENTITY(ENTITY)

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/entity/controllable_entity.h>
#endif

#endif
