#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_EXISTING_COMPONENT_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_EXISTING_COMPONENT_H

#include <argos3/core/simulator/entity/composable_entity.h>

namespace argos {

/** The first direct component that is a COMPONENT, or null; creates no lazy component. */
template <typename COMPONENT>
COMPONENT* FindExistingComponent(const CComposableEntity& entity) {
  for (CEntity* component : entity.GetExistingComponents()) {
    if (auto* found = dynamic_cast<COMPONENT*>(component)) {
      return found;
    }
  }
  return nullptr;
}

}  // namespace argos

#endif
