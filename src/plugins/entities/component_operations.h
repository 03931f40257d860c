#ifndef ARGOS3_PLUGINS_ENTITIES_COMPONENT_OPERATIONS_H
#define ARGOS3_PLUGINS_ENTITIES_COMPONENT_OPERATIONS_H

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/described_body_model.h>
#include <argos3/core/simulator/space/space.h>

namespace argos {

/** Calls @p call for the model of each engine of the body of @p component's robot. */
template <typename CALL>
void ForModelsOfRobot(CEntity& component, CALL&& call) {
  if (CEmbodiedEntity* const body = FindDescribedBody(component.GetRootEntity())) {
    for (UInt32 i = 0; i < body->GetPhysicsModelsNum(); ++i) {
      call(body->GetPhysicsModel(i));
    }
  }
}

}  // namespace argos

/**
 * Replaces REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY for components that engines use: engines
 * are notified of additions and removals (CPhysicsModel::ComponentAdded).
 */
#define REGISTER_SPACE_OPERATIONS_TOLD_TO_ENGINES(COMPONENT)                                       \
  class CSpaceOperationAdd##COMPONENT : public CSpaceOperationAddEntity {                          \
   public:                                                                                         \
    void ApplyTo(CSpace& space, COMPONENT& component) {                                            \
      space.AddEntity(component);                                                                  \
      ForModelsOfRobot(component, [&](CPhysicsModel& model) { model.ComponentAdded(component); }); \
    }                                                                                              \
  };                                                                                               \
  class CSpaceOperationRemove##COMPONENT : public CSpaceOperationRemoveEntity {                    \
   public:                                                                                         \
    void ApplyTo(CSpace& space, COMPONENT& component) {                                            \
      ForModelsOfRobot(component,                                                                  \
                       [&](CPhysicsModel& model) { model.ComponentRemoved(component); });          \
      space.RemoveEntity(component);                                                               \
    }                                                                                              \
  };                                                                                               \
  REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAdd##COMPONENT, COMPONENT)     \
  REGISTER_SPACE_OPERATION(CSpaceOperationRemoveEntity, CSpaceOperationRemove##COMPONENT, COMPONENT)

#endif
