#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_COMPOSABLE_ENTITY_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_COMPOSABLE_ENTITY_H

#include <argos3/core/simulator/entity/entity.h>

#include <memory>

namespace argos {

class CLazyComponents;

/**
 * An entity made of components, which it owns.
 *
 * Components are found by path: a type, optionally an id in brackets, nested with dots:
 * "leds.led[led_0]". A type without an id selects the component that was added first.
 */
class CComposableEntity : public CEntity {
 public:
  ENABLE_VTABLE();

  explicit CComposableEntity(CComposableEntity* parent);
  CComposableEntity(CComposableEntity* parent, const std::string& id);
  ~CComposableEntity() override;
  /** A copy has the same components, but does not own them and cannot get others. */
  CComposableEntity(const CComposableEntity& other);
  CComposableEntity& operator=(const CComposableEntity& other);

  void Reset() override;
  void Destroy() override;
  std::string GetTypeDescription() const override { return "composite"; }

  /** Calls UpdateComponents() if the entity is enabled. */
  void Update() override;
  /** Updates every enabled component; robots override it to update only those that need it. */
  virtual void UpdateComponents();
  void SetEnabled(bool enabled) override;
  void MarkStart() override;
  void MarkStartValues() override;
  void ReturnToStart() override;

  /** Adds @p component, which this entity then owns. Its type must not change later. */
  void AddComponent(CEntity& component);
  /** The same, before the component @p next in the order: it is destroyed after that one. */
  void InsertComponent(CEntity& component, const CEntity& next);
  /**
   * Removes a component; the caller then owns it.
   * @throws CARGoSException if there is none of that path.
   */
  CEntity& RemoveComponent(const std::string& component);

  /** @throws CARGoSException that lists the components there are, if there is none of that path. */
  CEntity& GetComponent(const std::string& component);
  /** @throws CARGoSException also if the component is not an E. */
  template <class E>
  E& GetComponent(const std::string& component) {
    E* result = dynamic_cast<E*>(&GetComponent(component));
    if (result == nullptr) {
      THROW_ARGOSEXCEPTION("component \"" << component << "\" of \"" << GetContext() << GetId()
                                          << "\" is not of the requested type");
    }
    return *result;
  }
  bool HasComponent(const std::string& component);
  /** Iterator into GetComponentMap(); its end() if there is no such component. */
  CEntity::TMultiMap::iterator FindComponent(const std::string& component);

  /** Direct components by type; built at the first call. */
  CEntity::TMultiMap& GetComponentMap();
  /** Direct components in order of addition. */
  CEntity::TVector& GetComponentVector();

  /** The components that exist now; creates no lazy ones. */
  const CEntity::TVector& GetExistingComponents() const { return m_components; }
  /** Releases a component without deleting it; ignores one that is not of this entity. */
  void ForgetComponent(const CEntity& component);

  void UpdateDigest(CDigest& digest) const override;

 protected:
  /** Sets what creates components at their first look-up. Not owned; null (the default): none. */
  void SetLazyComponents(CLazyComponents* lazyComponents) { m_lazyComponents = lazyComponents; }

 private:
  void DeleteComponents();
  void CheckIsNoCopy() const;
  CEntity* TryGetComponent(const std::string& path);
  void CreateLazyComponents(const std::string& type);

  CEntity::TVector m_components;  // owned, unless this is a copy
  std::unique_ptr<CEntity::TMultiMap> m_componentMap;  // keyed by type; null before a request
  CLazyComponents* m_lazyComponents = nullptr;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space.h>
#endif

#endif
