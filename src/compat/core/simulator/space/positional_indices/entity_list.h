#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_ENTITY_LIST_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_ENTITY_LIST_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/memory/room.h>

#include <unordered_map>
#include <vector>

namespace argos {

/**
 * The entities of an index, in order of addition, each with a slot number.
 *
 * Removal leaves a hole, so that slots stay valid until Compact(); adding and removing take
 * constant time.
 */
template <class ENTITY>
class CEntityList {
 public:
  static constexpr UInt32 kNone = ~UInt32(0);

  /** @return false if it is in the list already. */
  bool Add(ENTITY& entity) {
    const UInt32 slot = static_cast<UInt32>(m_entities.size());
    // room first: after the entity has got a slot, nothing fails
    ReserveOneMore(m_entities);
    if (!m_slots.emplace(&entity, slot).second) {
      return false;
    }
    m_entities.push_back(&entity);
    return true;
  }

  /** @return the slot it had, or kNone if it is not in the list. */
  UInt32 Remove(const ENTITY& entity) {
    const auto found = m_slots.find(&entity);
    if (found == m_slots.end()) {
      return kNone;
    }
    const UInt32 slot = found->second;
    m_slots.erase(found);
    m_entities[slot] = nullptr;
    return slot;
  }

  UInt32 FindSlot(const ENTITY& entity) const {
    const auto found = m_slots.find(&entity);
    return found != m_slots.end() ? found->second : kNone;
  }

  /** Closes the holes if there are many; slots change, the order does not. */
  void Compact() {
    if (2 * m_slots.size() >= m_entities.size()) {
      return;
    }
    UInt32 slot = 0;
    for (ENTITY* entity : m_entities) {
      if (entity != nullptr) {
        m_entities[slot] = entity;
        m_slots[entity] = slot;
        ++slot;
      }
    }
    m_entities.resize(slot);
  }

  size_t GetNumEntities() const { return m_slots.size(); }
  /** Slots run from 0 to this, exclusive. */
  UInt32 GetNumSlots() const { return static_cast<UInt32>(m_entities.size()); }
  /** Null for a hole. */
  ENTITY* operator[](UInt32 slot) const { return m_entities[slot]; }
  /** Calls visit(ENTITY&) for each entity, in order of addition, until that returns false. */
  template <typename VISIT>
  void ForAll(VISIT&& visit) const {
    // indexed by number, because visit() may add entities
    for (size_t slot = 0; slot < m_entities.size(); ++slot) {
      if (m_entities[slot] != nullptr && !visit(*m_entities[slot])) {
        return;
      }
    }
  }

 private:
  std::vector<ENTITY*> m_entities;  // by slot; not owned
  std::unordered_map<const ENTITY*, UInt32> m_slots;  // look-up only, never iterated
};

}  // namespace argos

#endif
