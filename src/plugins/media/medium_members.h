#ifndef ARGOS3_PLUGINS_MEDIA_MEDIUM_MEMBERS_H
#define ARGOS3_PLUGINS_MEDIA_MEDIUM_MEMBERS_H

#include <argos3/core/simulator/entity/entity.h>
#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/plugins/simulator/media/clear_medium.h>

#include <algorithm>
#include <vector>

namespace argos {

/**
 * The entities of a medium, numbered in the order of their insertion into the space; for the
 * sources of media.
 *
 * Entities can be added and removed at any time outside the phases of a tick; numbers change in
 * Update() only. An entity that is not in the space yet is waiting and has no number. ENTITY has
 * GetNumberInMedium() and SetNumberInMedium().
 */
template <typename ENTITY>
class CMediumMembers {
 public:
  static constexpr UInt32 kWaiting = ~UInt32(0);  // number of entities that have none yet

  void Add(ENTITY& entity) {
    m_waiting.push_back(&entity);
    entity.SetNumberInMedium(kWaiting);
  }
  void Remove(ENTITY& entity) {
    if (entity.GetNumberInMedium() == kWaiting) {
      m_waiting.erase(std::remove(m_waiting.begin(), m_waiting.end(), &entity), m_waiting.end());
    } else {
      ARGOS_ASSERT(Has(entity), "the number of \"" << entity.GetId() << "\" in its medium, "
                                                   << entity.GetNumberInMedium() << ", is stale");
      m_members[entity.GetNumberInMedium()] = nullptr;
      m_anyRemoved = true;
    }
  }

  /** Renumbers the entities if any were added or removed. @return true if so. */
  bool Update() {
    const auto waiting =
        std::partition(m_waiting.begin(), m_waiting.end(),
                       [](const ENTITY* entity) { return entity->GetIndex() < 0; });
    if (waiting == m_waiting.end() && !m_anyRemoved) {
      return false;
    }
    // first: numbers become stale
    m_members.reserve(m_members.size() + static_cast<size_t>(m_waiting.end() - waiting));
    m_members.erase(std::remove(m_members.begin(), m_members.end(), nullptr), m_members.end());
    m_members.insert(m_members.end(), waiting, m_waiting.end());
    m_waiting.erase(waiting, m_waiting.end());
    std::sort(m_members.begin(), m_members.end(), SEntityComparator());
    for (size_t i = 0; i < m_members.size(); ++i) {
      m_members[i]->SetNumberInMedium(static_cast<UInt32>(i));
    }
    m_anyRemoved = false;
    ++m_numbering;
    return true;
  }

  /** Changes whenever the entities are renumbered: numbers from before are stale then. */
  UInt32 GetNumbering() const { return m_numbering; }
  /** The number of numbered entities. */
  size_t GetSize() const { return m_members.size(); }
  /** Null if the entity was removed since the last Update(). */
  ENTITY* Get(size_t number) const {
    ARGOS_ASSERT(number < m_members.size(), "a medium has no entity with the number " << number);
    return m_members[number];
  }
  /** The same for all numbers, (GetSize()). */
  ENTITY* const* GetAll() const { return m_members.data(); }
  bool Has(const ENTITY& entity) const {
    const UInt32 number = entity.GetNumberInMedium();
    return number == kWaiting
               ? std::find(m_waiting.begin(), m_waiting.end(), &entity) != m_waiting.end()
               : number < m_members.size() && m_members[number] == &entity;
  }

  /** Calls ClearMedium() of all entities, which calls Remove(). Needs no memory. */
  void Clear() {
    ClearMediumOfAll(m_waiting);
    for (size_t number = 0; number < m_members.size(); ++number) {
      if (m_members[number] != nullptr) {
        m_members[number]->ClearMedium();
      }
    }
  }
  /** All entities, including the waiting ones. */
  std::vector<ENTITY*> ListAll() const {
    std::vector<ENTITY*> all = m_waiting;
    std::copy_if(m_members.begin(), m_members.end(), std::back_inserter(all),
                 [](const ENTITY* entity) { return entity != nullptr; });
    return all;
  }

 private:
  std::vector<ENTITY*> m_members;  // are indexed by number; not owned
  std::vector<ENTITY*> m_waiting;  // are not owned
  bool m_anyRemoved = false;
  UInt32 m_numbering = 0;
};

}  // namespace argos

#endif
