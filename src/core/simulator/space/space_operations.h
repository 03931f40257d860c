#ifndef ARGOS3_CORE_SIMULATOR_SPACE_SPACE_OPERATIONS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_SPACE_OPERATIONS_H

#include <argos3/core/simulator/space/space.h>

namespace argos {

class CComposableEntity;

/** Kind of operation: add an entity to the space. */
class CSpaceOperationAddEntity : public CEntityOperation<CSpaceOperationAddEntity, CSpace, void> {};
/** Kind of operation: remove an entity from the space and delete it. */
class CSpaceOperationRemoveEntity
    : public CEntityOperation<CSpaceOperationRemoveEntity, CSpace, void> {};

/** Adds every component that exists to the space, in order, each by its own type's operation. */
void AddComponentsToSpace(CSpace& space, CComposableEntity& entity);
/** Detaches and removes components from the space, last to first. */
void RemoveComponentsFromSpace(CSpace& space, CComposableEntity& entity);

}  // namespace argos

#define REGISTER_SPACE_OPERATION(ACTION, OPERATION, ENTITY) \
  REGISTER_ENTITY_OPERATION(ACTION, CSpace, OPERATION, void, ENTITY)

#define SPACE_OPERATION_ADD_ENTITY(ENTITY)                                   \
  class CSpaceOperationAdd##ENTITY : public CSpaceOperationAddEntity {       \
   public:                                                                   \
    void ApplyTo(CSpace& space, ENTITY& entity) { space.AddEntity(entity); } \
  };

#define SPACE_OPERATION_REMOVE_ENTITY(ENTITY)                                   \
  class CSpaceOperationRemove##ENTITY : public CSpaceOperationRemoveEntity {    \
   public:                                                                      \
    void ApplyTo(CSpace& space, ENTITY& entity) { space.RemoveEntity(entity); } \
  };

#define REGISTER_STANDARD_SPACE_OPERATION_ADD_ENTITY(ENTITY) \
  SPACE_OPERATION_ADD_ENTITY(ENTITY)                         \
  REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAdd##ENTITY, ENTITY)

#define REGISTER_STANDARD_SPACE_OPERATION_REMOVE_ENTITY(ENTITY) \
  SPACE_OPERATION_REMOVE_ENTITY(ENTITY)                         \
  REGISTER_SPACE_OPERATION(CSpaceOperationRemoveEntity, CSpaceOperationRemove##ENTITY, ENTITY)

/** Every entity class that is not composable needs this in its source file. */
#define REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(ENTITY) \
  REGISTER_STANDARD_SPACE_OPERATION_ADD_ENTITY(ENTITY)       \
  REGISTER_STANDARD_SPACE_OPERATION_REMOVE_ENTITY(ENTITY)

#define SPACE_OPERATION_ADD_COMPOSABLE_ENTITY(ENTITY)                  \
  class CSpaceOperationAdd##ENTITY : public CSpaceOperationAddEntity { \
   public:                                                             \
    void ApplyTo(CSpace& space, ENTITY& entity) {                      \
      space.AddEntity(entity);                                         \
      AddComponentsToSpace(space, entity);                             \
    }                                                                  \
  };

#define SPACE_OPERATION_REMOVE_COMPOSABLE_ENTITY(ENTITY)                     \
  class CSpaceOperationRemove##ENTITY : public CSpaceOperationRemoveEntity { \
   public:                                                                   \
    void ApplyTo(CSpace& space, ENTITY& entity) {                            \
      RemoveComponentsFromSpace(space, entity);                              \
      space.RemoveEntity(entity);                                            \
    }                                                                        \
  };

#define REGISTER_STANDARD_SPACE_OPERATION_ADD_COMPOSABLE(ENTITY) \
  SPACE_OPERATION_ADD_COMPOSABLE_ENTITY(ENTITY)                  \
  REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAdd##ENTITY, ENTITY)

#define REGISTER_STANDARD_SPACE_OPERATION_REMOVE_COMPOSABLE(ENTITY) \
  SPACE_OPERATION_REMOVE_COMPOSABLE_ENTITY(ENTITY)                  \
  REGISTER_SPACE_OPERATION(CSpaceOperationRemoveEntity, CSpaceOperationRemove##ENTITY, ENTITY)

#define REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(ENTITY) \
  REGISTER_STANDARD_SPACE_OPERATION_ADD_COMPOSABLE(ENTITY)       \
  REGISTER_STANDARD_SPACE_OPERATION_REMOVE_COMPOSABLE(ENTITY)

#endif
