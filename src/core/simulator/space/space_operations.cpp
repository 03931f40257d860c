// How the entities of the core are added to the space and removed from it.

#include <argos3/core/simulator/space/space_operations.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

void AddComponentsToSpace(CSpace& space, CComposableEntity& entity) {
  // a copy: adding a component may create further ones
  // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
  const CEntity::TVector components = entity.GetExistingComponents();
  for (CEntity* component : components) {
    CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(space, *component);
  }
}

void RemoveComponentsFromSpace(CSpace& space, CComposableEntity& entity) {
  space.CheckMayChange();
  while (!entity.GetExistingComponents().empty()) {
    CEntity* const last = entity.GetExistingComponents().back();
    // the space detaches it from the entity; a type without operations is deleted here
    CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(space, *last);
    const CEntity::TVector& left = entity.GetExistingComponents();
    if (!left.empty() && left.back() == last) {
      const std::unique_ptr<CEntity> owned(last);
      entity.ForgetComponent(*last);
    }
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_COMPOSABLE(CComposableEntity)

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CPositionalEntity)

namespace {

class CSpaceOperationAddCEmbodiedEntity : public CSpaceOperationAddEntity {
 public:
  void ApplyTo(CSpace& space, CEmbodiedEntity& entity) {
    space.AddEntity(entity);
    space.AddEntityToPhysicsEngine(entity);
  }
};

class CSpaceOperationRemoveCEmbodiedEntity : public CSpaceOperationRemoveEntity {
 public:
  void ApplyTo(CSpace& space, CEmbodiedEntity& entity) {
    space.RemoveEntityFromPhysicsEngines(entity);
    space.RemoveEntity(entity);
  }
};

class CSpaceOperationAddCControllableEntity : public CSpaceOperationAddEntity {
 public:
  void ApplyTo(CSpace& space, CControllableEntity& entity) {
    space.AddEntity(entity);
    space.AddControllableEntity(entity);
  }
};

class CSpaceOperationRemoveCControllableEntity : public CSpaceOperationRemoveEntity {
 public:
  void ApplyTo(CSpace& space, CControllableEntity& entity) {
    space.RemoveControllableEntity(entity);
    space.RemoveEntity(entity);
  }
};

class CSpaceOperationAddCFloorEntity : public CSpaceOperationAddEntity {
 public:
  void ApplyTo(CSpace& space, CFloorEntity& floor) {
    if (space.HasFloorEntity() && !space.GetContext().IsReplay) {
      CFloorEntity& other = space.GetFloorEntity();
      const TConfigurationNode* const node = other.GetConfigurationNode();
      THROW_ARGOSEXCEPTION("there is already a floor, \""
                           << other.GetId() << '"'
                           << (node != nullptr ? " at " + node->GetLocation() : std::string())
                           << ": an arena has one at most");
    }
    space.AddEntity(floor);
    space.SetFloorEntity(floor);
  }
};

}  // namespace

REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAddCEmbodiedEntity,
                         CEmbodiedEntity)
REGISTER_SPACE_OPERATION(CSpaceOperationRemoveEntity, CSpaceOperationRemoveCEmbodiedEntity,
                         CEmbodiedEntity)
REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAddCControllableEntity,
                         CControllableEntity)
REGISTER_SPACE_OPERATION(CSpaceOperationRemoveEntity, CSpaceOperationRemoveCControllableEntity,
                         CControllableEntity)
REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAddCFloorEntity, CFloorEntity)
REGISTER_STANDARD_SPACE_OPERATION_REMOVE_ENTITY(CFloorEntity)

}  // namespace argos
