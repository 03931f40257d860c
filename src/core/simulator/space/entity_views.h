#ifndef ARGOS3_CORE_SIMULATOR_SPACE_ENTITY_VIEWS_H
#define ARGOS3_CORE_SIMULATOR_SPACE_ENTITY_VIEWS_H

#include <argos3/core/simulator/space/space.h>

#include <mutex>
#include <set>
#include <string>

namespace argos {

/**
 * The lists and maps of entities that users request from a space.
 *
 * They take several times the memory of the entities' hot data, and few experiments need them. So
 * nothing is listed before the first request. A request for the entities of one type creates the
 * lazy components of that type only; a request for a list of all entities creates all of them. The
 * tick never reads the views. Requests are safe on several threads at once, because controllers may
 * make them.
 */
class CEntityViews {
 public:
  /** @param roots  the root entities of the space, in their order; must outlive the views. */
  explicit CEntityViews(const CEntity::TVector& roots) : m_roots(roots) {}

  /** Notes that an entity or a component has been added to the space. */
  void Add(CEntity& entity);
  /** Notes that it is about to be deleted. */
  void Remove(CEntity& entity);
  /** Notes that the order of the root entities has changed. */
  void NoticeOrder() { m_isAllStale = true; }

  /** All entities, each root entity followed by its components in the order of their indices. */
  CEntity::TVector& GetAll() { return Complete().m_all; }
  /** By qualified id, such as "fb0.leds_0". */
  CEntity::TMap& GetPerId() { return Complete().m_perId; }
  CSpace::TMapPerTypePerId& GetPerTypePerId() { return Complete().m_perType; }
  /** The entities of that type by qualified id; null if there never was one. */
  CSpace::TMapPerType* FindType(const std::string& type);

 private:
  CEntityViews& Complete();
  void Open();
  void List(CEntity& entity);
  void RemoveFromLists(CEntity& entity);
  void ListWithComponents(CEntity& entity, const std::string& type);
  void ListPending();
  void ListAll();

  const CEntity::TVector& m_roots;
  std::mutex m_mutex;
  bool m_isOpen = false;  // there has been a request
  bool m_isComplete = false;  // every component of every type exists and is listed
  bool m_isAllStale = false;  // m_all must be listed again
  CEntity::TVector m_all;
  CEntity::TMap m_perId;
  CSpace::TMapPerTypePerId m_perType;
  CEntity::TVector m_pending;  // added to the space, not listed yet
  std::set<std::string> m_rootTypes;  // types of root entities: always listed
  std::set<std::string> m_completeTypes;  // every component of that type exists and is listed
  std::set<std::string>
      m_goneTypes;  // types of entities that were removed before the first request
};

}  // namespace argos

#endif
