#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_ENTITY_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_ENTITY_H

#include <argos3/core/simulator/entity/entity_operation.h>
#include <argos3/core/simulator/entity/start_values.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/configuration/base_configurable_resource.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/plugins/factory.h>
#include <argos3/core/utility/plugins/vtable.h>

#include <sys/types.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

// user code written for ARGoS 3 uses the unqualified name after including any entity
using std::unordered_map;

namespace argos {

class CComposableEntity;
class CDigest;
struct SAppearance;

/**
 * An object in the arena, or a component of one: a node of the entity tree.
 *
 * Every concrete class carries ENABLE_VTABLE() and registers its space operations, so that the core
 * dispatches on its exact type without knowing it.
 */
class CEntity : public CBaseConfigurableResource,
                public EnableVTableFor<CEntity>,
                public CSlabObject {
 public:
  ENABLE_VTABLE();

  typedef std::vector<CEntity*> TVector;
  typedef std::unordered_map<std::string, CEntity*> TMap;
  typedef std::multimap<std::string, CEntity*> TMultiMap;

  /** @param parent the composite that owns this entity, or nullptr for a root. */
  explicit CEntity(CComposableEntity* parent);
  CEntity(CComposableEntity* parent, const std::string& id);
  ~CEntity() override;
  /**
   * A copy has the id and index of the original, and refers to the same parts and to the same body.
   * It is in no space: it owns nothing, and must not be used after the original was removed.
   */
  CEntity(const CEntity& other);
  CEntity& operator=(const CEntity& other);

  /**
   * Reads `id`. A component without one is called `<type>_<n>`.
   * @throws CARGoSException if a root entity has no id.
   */
  void Init(TConfigurationNode& tree) override;
  void Reset() override {}
  void Destroy() override {}

  const std::string& GetId() const { return m_id; }
  /** Ids of the parents, each followed by a dot: "fb0.leds_0."; empty for a root. */
  std::string GetContext() const;

  bool HasParent() const { return m_parent != nullptr; }
  /** @throws CARGoSException if this is a root entity. */
  CComposableEntity& GetParent();
  const CComposableEntity& GetParent() const;
  void SetParent(CComposableEntity& parent);
  CEntity& GetRootEntity();
  const CEntity& GetRootEntity() const;

  /** The name of the type, as in XML: "foot-bot", "body", ... */
  virtual std::string GetTypeDescription() const { return "entity"; }
  /** Called after the body this entity belongs to has moved, if the entity is enabled. */
  virtual void Update() {}

  /** Order of insertion into the space; -1 before. */
  ssize_t GetIndex() const { return m_index; }
  void SetIndex(ssize_t index) { m_index = static_cast<SInt64>(index); }

  bool IsEnabled() const { return m_enabled; }
  void Enable() { SetEnabled(true); }
  void Disable() { SetEnabled(false); }
  virtual void SetEnabled(bool enabled);

  /**
   * Notes which of this entity and its parts are enabled, as the state that Reset() restores.
   *
   * Called for roots when they are added to the space, and again when everything is loaded. The
   * initial state of an entity that has never been in a space is that after its construction.
   */
  virtual void MarkStart() { m_enabledAtStart = m_enabled; }
  /**
   * Called when everything is loaded: the present values of this entity and its parts are those
   * that Reset() restores; see KeepForReset().
   */
  virtual void MarkStartValues() { m_startValues.reset(); }
  /**
   * While it exists, what setters change in this thread is the start, also in a run: for the set-up
   * of devices of a new controller.
   */
  class CSetup : private CNonCopyable {
   public:
    CSetup();
    ~CSetup();
  };
  /**
   * Enables and disables this entity and its parts as they were at the start, and restores the
   * values that setters have changed since. Called before Reset().
   */
  virtual void ReturnToStart();
  /** True for a copy of another entity. */
  bool IsCopy() const { return m_isCopy; }
  bool IsEnabledAtStart() const { return m_enabledAtStart; }
  void SetEnabledAtStart(bool enabled) { m_enabledAtStart = enabled; }

  /**
   * The XML element of this entity, or nullptr; for a distributed entity, the template's. Stays
   * valid as long as the entity, whatever becomes of the node that Init() got.
   */
  TConfigurationNode* GetConfigurationNode() { return m_configurationNode; }

  /** What the entity looks like, or nullptr if it is not drawn. */
  virtual const SAppearance* GetAppearance() const { return nullptr; }
  /** Adds the entity's state to a digest of the world; components are visited by their parent. */
  virtual void UpdateDigest(CDigest& digest) const;

 protected:
  /**
   * Notes the present value of a member as the one that a reset restores. For setters, before they
   * change it; not for members that Reset() sets to their initial values anyway.
   *
   * Has an effect in the first call for a member after the start of the run only, and none while
   * the entity is not in a space: what is set then, or while the experiment is loaded, is the
   * initial value. Allocates when it has an effect.
   */
  template <typename VALUE>
  void KeepForReset(VALUE& member) {
    if (MustKeep(&member)) {
      Keep(&member, [&member, value = member] { member = value; });
    }
  }
  /**
   * The same for a value that @p restore sets, which may call the setter.
   * @param key  the address of the member that holds the value.
   */
  template <typename RESTORE>
  void KeepForReset(const void* key, RESTORE&& restore) {
    if (MustKeep(key)) {
      Keep(key, std::forward<RESTORE>(restore));
    }
  }
  /** True if KeepForReset() would have an effect; in a CSetup it forgets the value. */
  bool MustKeep(const void* key);

 private:
  void SetNode(TConfigurationNode& node);
  void ReleaseNode();
  void Keep(const void* key, std::function<void()> restore);

  CComposableEntity* m_parent;
  TConfigurationNode* m_configurationNode = nullptr;
  std::string m_id;
  SInt64 m_index : 39;  // shares its word with those below
  bool m_isCopy : 1;
  bool m_ownsNode = false;  // a copy; elements of the experiment need none
  bool m_enabled = true;
  bool m_enabledAtStart = true;
  std::unique_ptr<CStartValues> m_startValues;  // null until a setter has changed something
};

/** Orders entities by index, the order of their insertion into the space. */
struct SEntityComparator {
  bool operator()(const CEntity* a, const CEntity* b) const {
    return a->GetIndex() < b->GetIndex();
  }
  bool operator()(const CEntity& a, const CEntity& b) const { return a.GetIndex() < b.GetIndex(); }
};

template <typename LABEL, typename PLUGIN, typename RETURN_VALUE>
RETURN_VALUE CallEntityOperation(PLUGIN& plugin, CEntity& entity) {
  typedef CEntityOperationInstanceHolder<LABEL, PLUGIN, RETURN_VALUE> THolder;
  auto& table = GetVTable<LABEL, CEntity, THolder*>();
  THolder* holder = table[entity.GetTag()];
  return holder != nullptr ? holder->Call(plugin, entity) : RETURN_VALUE();
}

}  // namespace argos

#define REGISTER_ENTITY(CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION,    \
                        STATUS)                                                                    \
  REGISTER_SYMBOL(CEntity, CLASSNAME, LABEL, AUTHOR, VERSION, BRIEF_DESCRIPTION, LONG_DESCRIPTION, \
                  STATUS)

#endif
