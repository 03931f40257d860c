#ifndef ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_ROOT_COMPONENTS_H
#define ARGOS3_PLUGINS_OUTPUTS_QUANTITIES_ROOT_COMPONENTS_H

#include <argos3/core/simulator/entity/existing_component.h>

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
  const auto* const composable = dynamic_cast<const CComposableEntity*>(&root);
  return composable == nullptr ? nullptr : FindExistingComponent<COMPONENT>(*composable);
}

}  // namespace argos

#endif
