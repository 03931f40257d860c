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

void CSpace::AddToUserViews(CEntity& entity) {
  const std::string id = entity.GetContext() + entity.GetId();
  if (m_views->PerId.emplace(id, &entity).second) {
    m_views->All.push_back(&entity);
    const size_t tag = entity.GetTag();
    const bool known = tag < m_makeAny.size() && m_makeAny[tag] != nullptr;
    m_views->PerType[entity.GetTypeDescription()][id] =
        known ? m_makeAny[tag](entity) : CAny(&entity);
  }
  if (auto* composable = dynamic_cast<CComposableEntity*>(&entity)) {
    for (CEntity* component : composable->GetComponentVector()) {
      AddToUserViews(*component);
    }
  }
}

CSpace::SUserViews& CSpace::GetUserViews() {
  const std::lock_guard<std::mutex> lock(m_viewsMutex);
  if (m_views == nullptr) {
    m_views = std::make_unique<SUserViews>();
    m_views->Pending = m_roots;
  }
  SUserViews& views = *m_views;
  if (views.AllIsStale) {
    views.All.clear();
    for (const auto& entry : views.PerId) {
      views.All.push_back(entry.second);
    }
    views.AllIsStale = false;
    std::sort(views.All.begin(), views.All.end(), SEntityComparator());
  }
  if (!views.Pending.empty()) {
    const CEntity::TVector pending = std::move(views.Pending);
    views.Pending.clear();
    for (CEntity* entity : pending) {
      AddToUserViews(*entity);
    }
    std::sort(views.All.begin(), views.All.end(), SEntityComparator());
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
  TMapPerTypePerId& perType = GetUserViews().PerType;
  const auto found = perType.find(type);
  if (found == perType.end()) {
    std::vector<std::string> known;
    for (const auto& entry : perType) {
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
