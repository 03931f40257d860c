#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_LAZY_COMPONENTS_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_LAZY_COMPONENTS_H

#include <string>

namespace argos {

class CEntity;

/**
 * Components that an entity creates only when they are first looked up, because they take much
 * memory and few robots use them. See CComposableEntity::SetLazyComponents().
 */
class CLazyComponents {
 public:
  /**
   * Creates the components of that type that do not exist yet. This changes the space: it must not
   * happen while robots act or sense in parallel.
   * @param type  a GetTypeDescription(); empty: all types.
   */
  virtual void Create(const std::string& type) = 0;
  /** Called after a component was removed from the entity, for any reason. */
  virtual void Forget(const CEntity& component) = 0;

 protected:
  ~CLazyComponents() = default;
};

}  // namespace argos

#endif
