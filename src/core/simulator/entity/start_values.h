#ifndef ARGOS3_CORE_SIMULATOR_ENTITY_START_VALUES_H
#define ARGOS3_CORE_SIMULATOR_ENTITY_START_VALUES_H

#include <functional>
#include <vector>

namespace argos {

/**
 * The values that an entity had before setters changed them in a run, and how they are restored.
 *
 * Created by the first change, so entities that are never changed need no memory for it. See
 * CEntity::KeepForReset().
 */
class CStartValues {
 public:
  /** @param key  identifies the value: the address of the member that holds it. */
  bool Has(const void* key) const;
  /** Forgets a value, if there is one. */
  void Remove(const void* key);
  /** @param restore  called once, by Restore(); it may call the setter. */
  void Add(const void* key, std::function<void()> restore);
  /** Restores all values, the one that was changed last first. */
  void Restore();

 private:
  struct SValue {
    const void* Key;
    std::function<void()> Restore;
  };

  std::vector<SValue> m_values;  // few: searched one by one
};

}  // namespace argos

#endif
