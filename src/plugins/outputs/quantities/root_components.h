#ifndef ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_ROOT_COMPONENTS_H
#define ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_ROOT_COMPONENTS_H

#include <argos3/core/simulator/entity/composable_entity.h>

namespace argos {

/**
 * For fields: the first component of a class that a root entity has now, or the entity itself; null
 * if there is none. Creates no component.
 */
template <typename COMPONENT>
COMPONENT* FindExisting(CEntity& root) {
  if (auto* const self = dynamic_cast<COMPONENT*>(&root)) {
    return self;
  }
  if (const auto* const composable = dynamic_cast<const CComposableEntity*>(&root)) {
    for (CEntity* component : composable->GetExistingComponents()) {
      if (auto* const found = dynamic_cast<COMPONENT*>(component)) {
        return found;
      }
    }
  }
  return nullptr;
}

}  // namespace argos

#endif
