#include <argos3/core/simulator/space/user_views.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/utility/string_utilities.h>

#include <algorithm>

namespace argos {

namespace {

// finds the component whose dotted ids are that path; ids may contain dots themselves
CEntity* FindByIds(CEntity& entity, const std::string& path) {
  auto* composable = dynamic_cast<CComposableEntity*>(&entity);
  if (composable == nullptr) {
    return nullptr;
  }
  for (CEntity* component : composable->GetComponentVector()) {
    const std::string& id = component->GetId();
    if (path == id) {
      return component;
    }
    if (path.size() > id.size() && path[id.size()] == '.' && path.compare(0, id.size(), id) == 0) {
      CEntity* found = FindByIds(*component, path.substr(id.size() + 1));
      if (found != nullptr) {
        return found;
      }
    }
  }
  return nullptr;
}

}  // namespace

void CSpace::SUserViews::Erase(CEntity& entity) {
  const auto pending = std::find(Pending.begin(), Pending.end(), &entity);
  if (pending != Pending.end()) {
    Pending.erase(pending);
  }
  const std::string id = entity.GetContext() + entity.GetId();
  const auto found = PerId.find(id);
  if (found == PerId.end() || found->second != &entity) {
    return;
  }
  PerId.erase(found);
  PerType[entity.GetTypeDescription()].erase(id);
  AllIsStale = true;
}

void CSpace::ListInUserViews(CEntity& entity) {
  const std::string id = entity.GetContext() + entity.GetId();
  if (m_views->PerId.emplace(id, &entity).second) {
    m_views->All.push_back(&entity);
    if (!entity.HasParent()) {
      m_views->RootTypes.insert(entity.GetTypeDescription());
    }
    const size_t tag = entity.GetTag();
    const bool known = tag < m_makeAny.size() && m_makeAny[tag] != nullptr;
    m_views->PerType[entity.GetTypeDescription()][id] =
        known ? m_makeAny[tag](entity) : CAny(&entity);
  }
}

// lists the entity, and its components after making those of that type; of all types if it is empty
void CSpace::AddToUserViews(CEntity& entity, const std::string& type) {
  ListInUserViews(entity);
  if (auto* composable = dynamic_cast<CComposableEntity*>(&entity)) {
    if (type.empty()) {
      composable->GetComponentVector();
    } else {
      composable->HasComponent(type);
    }
    // a copy: making components further down may add to the list
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
    const CEntity::TVector components = composable->GetExistingComponents();
    for (CEntity* component : components) {
      AddToUserViews(*component, type);
    }
  }
}

void CSpace::OpenUserViews() {
  if (m_views == nullptr) {
    m_views = std::make_unique<SUserViews>();
    // there are none now, but there have been some
    for (const std::string& type : GetExtension<SGoneTypes>().Types) {
      m_views->PerType[type];
    }
    for (CEntity* root : m_roots) {
      ListInUserViews(*root);
    }
  }
}

void CSpace::AddPendingToUserViews() {
  SUserViews& views = *m_views;
  while (!views.Pending.empty()) {
    const CEntity::TVector pending = std::move(views.Pending);
    views.Pending.clear();
    for (CEntity* entity : pending) {
      ListInUserViews(*entity);
      if (views.Complete) {
        AddToUserViews(*entity, std::string());
        continue;
      }
      for (const std::string& type : views.CompleteTypes) {
        AddToUserViews(*entity, type);
      }
    }
    views.AllIsStale = true;
  }
}

CSpace::SUserViews& CSpace::GetUserViews() {
  const std::lock_guard<std::mutex> lock(m_viewsMutex);
  OpenUserViews();
  SUserViews& views = *m_views;
  if (!views.Complete) {
    for (CEntity* root : m_roots) {
      AddToUserViews(*root, std::string());
    }
    views.Complete = true;
    views.AllIsStale = true;
  }
  AddPendingToUserViews();
  if (views.AllIsStale) {
    views.All.clear();
    for (const auto& entry : views.PerId) {
      views.All.push_back(entry.second);
    }
    views.AllIsStale = false;
    std::sort(views.All.begin(), views.All.end(), SEntityComparator());
  }
  return views;
}

CSpace::SUserViews& CSpace::GetUserViewsOf(const std::string& type) {
  const std::lock_guard<std::mutex> lock(m_viewsMutex);
  OpenUserViews();
  SUserViews& views = *m_views;
  AddPendingToUserViews();
  if (!views.Complete && views.RootTypes.count(type) == 0 &&
      views.CompleteTypes.insert(type).second) {
    for (CEntity* root : m_roots) {
      AddToUserViews(*root, type);
    }
    AddPendingToUserViews();
  }
  return views;
}

UInt32 CSpace::GetNumberEntities() const {
  return static_cast<UInt32>(const_cast<CSpace*>(this)->GetUserViews().All.size());
}

CEntity::TVector& CSpace::GetEntityVector() {
  return GetUserViews().All;
}

CEntity::TMap& CSpace::GetEntityMapPerId() {
  return GetUserViews().PerId;
}

CSpace::TMapPerTypePerId& CSpace::GetEntityMapPerTypePerId() {
  return GetUserViews().PerType;
}

CEntity* CSpace::TryGetEntity(const std::string& id) {
  const auto root = m_rootById.find(id);
  if (root != m_rootById.end()) {
    return root->second;
  }
  for (size_t dot = id.find('.'); dot != std::string::npos; dot = id.find('.', dot + 1)) {
    const auto found = m_rootById.find(id.substr(0, dot));
    CEntity* component =
        found != m_rootById.end() ? FindByIds(*found->second, id.substr(dot + 1)) : nullptr;
    if (component != nullptr) {
      return component;
    }
  }
  return nullptr;
}

CEntity& CSpace::GetEntity(const std::string& id) {
  CEntity* entity = TryGetEntity(id);
  if (entity == nullptr) {
    std::vector<std::string> known;
    for (const CEntity* root : m_roots) {
      known.push_back(root->GetId());
    }
    THROW_ARGOSEXCEPTION("there is no entity \"" << id << "\" in the space"
                                                 << DidYouMean(id, known));
  }
  return *entity;
}

void CSpace::GetEntitiesMatching(CEntity::TVector& buffer, const std::string& pattern) {
  for (CEntity* entity : GetUserViews().All) {
    if (MatchPattern(entity->GetId(), pattern)) {
      buffer.push_back(entity);
    }
  }
}

CSpace::TMapPerType& CSpace::GetEntitiesByType(const std::string& type) {
  TMapPerTypePerId& perType = GetUserViewsOf(type).PerType;
  const auto found = perType.find(type);
  if (found == perType.end()) {
    std::vector<std::string> known;
    for (const auto& entry : GetUserViews().PerType) {
      known.push_back(entry.first);
    }
    THROW_ARGOSEXCEPTION("no entity of type \"" << type << "\" has been added to the space"
                                                << DidYouMean(type, known));
  }
  return found->second;
}

const CSpace::TMapPerType& CSpace::GetEntitiesByType(const std::string& type) const {
  return const_cast<CSpace*>(this)->GetEntitiesByType(type);
}

}  // namespace argos
