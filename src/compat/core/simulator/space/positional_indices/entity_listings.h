#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_ENTITY_LISTINGS_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_ENTITY_LISTINGS_H

#include <argos3/core/simulator/space/positional_indices/entity_list.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace argos {

/**
 * The entities of an index, and how they are listed in its cells: an entity may be in several.
 *
 * The listings of all cells share one array, in which the owner chains those of a cell. So listing
 * the entities again allocates nothing however they have moved, and takes time in proportion to
 * them, not to the cells.
 * @tparam CELL  identifies a cell.
 */
template <class ENTITY, class CELL>
class CEntityListings {
 public:
  static constexpr UInt32 kNone = CEntityList<ENTITY>::kNone;

  /** An entity in a cell. */
  struct SListing {
    ENTITY* Entity; /**< null: removed since */
    CELL Cell;
    UInt32 NextInCell; /**< the owner's chain; or kNone */
    UInt32 NextOfEntity; /**< or kNone */
  };

  const CEntityList<ENTITY>& GetEntities() const { return m_entities; }
  size_t GetNumListings() const { return m_listings.size(); }
  SListing& operator[](UInt32 listing) { return m_listings[listing]; }
  const SListing& operator[](UInt32 listing) const { return m_listings[listing]; }

  void AddEntity(ENTITY& entity) { m_entities.Add(entity); }
  /** Calls forget(CELL) for each cell in which the entity was listed. */
  template <typename FORGET>
  void RemoveEntity(ENTITY& entity, FORGET&& forget) {
    const UInt32 slot = m_entities.Remove(entity);
    if (slot == kNone || slot >= m_firstOfEntity.size()) {
      return;
    }
    UInt32 number = std::exchange(m_firstOfEntity[slot], kNone);
    while (number != kNone) {
      SListing& listing = m_listings[number];
      listing.Entity = nullptr;
      forget(listing.Cell);
      number = listing.NextOfEntity;
    }
  }

  /** Removes all listings, and allocates for one listing of each entity. */
  void Clear() {
    // both before memory is needed: entities must not refer to listings that are gone
    m_listings.clear();
    m_firstOfEntity.clear();
    if (m_listings.capacity() < m_entities.GetNumEntities()) {
      m_listings.reserve(std::max(m_entities.GetNumEntities(), 2 * m_listings.capacity()));
    }
    m_firstOfEntity.assign(m_entities.GetNumSlots(), kNone);
  }
  /** Closes the holes that removed entities have left; Clear() has to follow. */
  void Compact() { m_entities.Compact(); }
  /** Calls list(ENTITY&), which calls List(), for every entity in order of addition. */
  template <typename LIST>
  void ListAll(LIST&& list) {
    // restored also if list() throws
    struct SEnd {
      UInt32& Slot;
      ~SEnd() { Slot = kNone; }
    } const end{m_listedSlot};
    for (UInt32 slot = 0; slot < m_entities.GetNumSlots(); ++slot) {
      if (m_entities[slot] != nullptr) {
        m_listedSlot = slot;
        list(*m_entities[slot]);
      }
    }
  }
  /**
   * Adds a listing, which the owner has to chain. Within ListAll(), of the entity that it visits.
   * @return its number, or kNone if the entity is not in the index.
   */
  UInt32 List(ENTITY& entity, const CELL& cell) {
    const UInt32 slot = m_listedSlot != kNone ? m_listedSlot : m_entities.FindSlot(entity);
    if (slot == kNone) {
      return kNone;
    }
    if (slot >= m_firstOfEntity.size()) {
      m_firstOfEntity.resize(m_entities.GetNumSlots(), kNone);
    }
    const UInt32 listing = static_cast<UInt32>(m_listings.size());
    m_listings.push_back({&entity, cell, kNone, m_firstOfEntity[slot]});
    m_firstOfEntity[slot] = listing;
    return listing;
  }

 private:
  CEntityList<ENTITY> m_entities;
  UInt32 m_listedSlot = kNone;  // of the entity that ListAll() visits
  std::vector<SListing> m_listings;  // in the order of List()
  std::vector<UInt32> m_firstOfEntity;  // by slot: into m_listings; kNone: not listed
};

}  // namespace argos

#endif
