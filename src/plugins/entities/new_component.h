#ifndef ARGOS3_PLUGINS_ENTITIES_NEW_COMPONENT_H
#define ARGOS3_PLUGINS_ENTITIES_NEW_COMPONENT_H

#include <argos3/core/simulator/entity/composable_entity.h>

#include <memory>
#include <utility>

namespace argos {

/**
 * Creates a component, owned by @p parent; for the sources of plug-ins.
 *
 * @param arguments  arguments of COMPONENT's constructor after the parent.
 */
template <typename COMPONENT, typename... ARGUMENTS>
COMPONENT* NewComponent(CComposableEntity& parent, ARGUMENTS&&... arguments) {
  auto component = std::make_unique<COMPONENT>(&parent, std::forward<ARGUMENTS>(arguments)...);
  COMPONENT* borrowed = component.get();
  parent.AddComponent(*component.release());
  return borrowed;
}

}  // namespace argos

#endif
