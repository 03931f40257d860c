#include <argos3/core/simulator/space/entity_views.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/root_places.h>

#include <algorithm>
#include <new>

namespace argos {

void CEntityViews::Add(CEntity& entity) {
  if (m_isOpen) {
    m_pending.push_back(&entity);
  }
}

// removal must succeed without memory, too
void CEntityViews::Remove(CEntity& entity) {
  if (m_isOpen) {
    RemoveFromLists(entity);
    return;
  }
  try {
    m_goneTypes.insert(entity.GetTypeDescription());
  } catch (const std::bad_alloc&) {
    // a request for this type alone will be an error instead of an empty list
  }
}

void CEntityViews::RemoveFromLists(CEntity& entity) {
  const auto pending = std::find(m_pending.begin(), m_pending.end(), &entity);
  if (pending != m_pending.end()) {
    m_pending.erase(pending);
  }
  auto found = m_perId.end();
  try {
    found = m_perId.find(entity.GetContext() + entity.GetId());
  } catch (const std::bad_alloc&) {
    found = std::find_if(m_perId.begin(), m_perId.end(),
                         [&entity](const auto& entry) { return entry.second == &entity; });
  }
  if (found == m_perId.end() || found->second != &entity) {
    return;
  }
  // ids are unique, so the others do not contain it
  for (auto& entry : m_perType) {
    entry.second.erase(found->first);
  }
  m_perId.erase(found);
  m_isAllStale = true;
}

void CEntityViews::List(CEntity& entity) {
  const std::string id = entity.GetContext() + entity.GetId();
  if (!m_perId.emplace(id, &entity).second) {
    return;
  }
  m_all.push_back(&entity);
  if (!entity.HasParent()) {
    m_rootTypes.insert(entity.GetTypeDescription());
  }
  const TEntityCast cast = GetVTable<CEntityViews, CEntity, TEntityCast>()[entity.GetTag()];
  m_perType[entity.GetTypeDescription()][id] = cast != nullptr ? cast(entity) : CAny(&entity);
}

// lists the entity and its components; creates the lazy ones of that type, of all types if it is
// empty
void CEntityViews::ListWithComponents(CEntity& entity, const std::string& type) {
  List(entity);
  if (auto* composable = dynamic_cast<CComposableEntity*>(&entity)) {
    if (type.empty()) {
      composable->GetComponentVector();
    } else {
      composable->HasComponent(type);
    }
    // a copy: creating components further down may add to the list
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
    const CEntity::TVector components = composable->GetExistingComponents();
    for (CEntity* component : components) {
      ListWithComponents(*component, type);
    }
  }
}

void CEntityViews::Open() {
  if (m_isOpen) {
    return;
  }
  m_isOpen = true;
  for (const std::string& type : m_goneTypes) {
    m_perType[type];
  }
  for (CEntity* root : m_roots) {
    List(*root);
  }
}

void CEntityViews::ListPending() {
  while (!m_pending.empty()) {
    const CEntity::TVector pending = std::move(m_pending);
    m_pending.clear();
    for (CEntity* entity : pending) {
      List(*entity);
      if (m_isComplete) {
        ListWithComponents(*entity, std::string());
        continue;
      }
      for (const std::string& type : m_completeTypes) {
        ListWithComponents(*entity, type);
      }
    }
    m_isAllStale = true;
  }
}

CEntityViews& CEntityViews::Complete() {
  // components that robots create at the same time are added to the pending ones
  const auto lazy = CRobotsCode::LockLazy();
  const std::lock_guard<std::mutex> lock(m_mutex);
  Open();
  if (!m_isComplete) {
    for (CEntity* root : m_roots) {
      ListWithComponents(*root, std::string());
    }
    m_isComplete = true;
    m_isAllStale = true;
  }
  ListPending();
  if (m_isAllStale) {
    ListAll();
    m_isAllStale = false;
  }
  return *this;
}

void CEntityViews::ListAll() {
  std::vector<ssize_t> indices;
  indices.reserve(m_roots.size());
  for (const CEntity* root : m_roots) {
    indices.push_back(root->GetIndex());
  }
  const CRootPlaces places(indices);
  struct SListed {
    size_t Place;  // place of the root
    CEntity* Entity;
  };
  std::vector<SListed> listed;
  listed.reserve(m_perId.size());
  for (const auto& entry : m_perId) {
    listed.push_back({places.Find(entry.second->GetRootEntity()), entry.second});
  }
  std::sort(listed.begin(), listed.end(), [](const SListed& a, const SListed& b) {
    return a.Place != b.Place ? a.Place < b.Place : a.Entity->GetIndex() < b.Entity->GetIndex();
  });
  m_all.clear();
  for (const SListed& each : listed) {
    m_all.push_back(each.Entity);
  }
}

CSpace::TMapPerType* CEntityViews::FindType(const std::string& type) {
  const auto lazy = CRobotsCode::LockLazy();
  const std::lock_guard<std::mutex> lock(m_mutex);
  Open();
  ListPending();
  if (!m_isComplete && m_rootTypes.count(type) == 0 && m_completeTypes.insert(type).second) {
    for (CEntity* root : m_roots) {
      ListWithComponents(*root, type);
    }
    ListPending();
  }
  const auto found = m_perType.find(type);
  return found != m_perType.end() ? &found->second : nullptr;
}

}  // namespace argos
