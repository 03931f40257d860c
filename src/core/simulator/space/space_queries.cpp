// Queries of CSpace for users: entities by id, by type and by pattern, and the floor.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/space/entity_views.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/text/string_utilities.h>

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

UInt32 CSpace::GetNumberEntities() const {
  return static_cast<UInt32>(m_views->GetAll().size());
}

CEntity::TVector& CSpace::GetEntityVector() {
  return m_views->GetAll();
}

CEntity::TMap& CSpace::GetEntityMapPerId() {
  return m_views->GetPerId();
}

CSpace::TMapPerTypePerId& CSpace::GetEntityMapPerTypePerId() {
  return m_views->GetPerTypePerId();
}

CEntity* CSpace::TryGetEntity(const std::string& id) {
  const auto root = m_rootById.find(id);
  if (root != m_rootById.end()) {
    return root->second.get();
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
  for (CEntity* entity : m_views->GetAll()) {
    if (MatchPattern(entity->GetId(), pattern)) {
      buffer.push_back(entity);
    }
  }
}

CSpace::TMapPerType& CSpace::GetEntitiesByType(const std::string& type) {
  TMapPerType* const entities = m_views->FindType(type);
  if (entities == nullptr) {
    std::vector<std::string> known;
    for (const auto& entry : m_views->GetPerTypePerId()) {
      known.push_back(entry.first);
    }
    THROW_ARGOSEXCEPTION("no entity of type \"" << type << "\" has been added to the space"
                                                << DidYouMean(type, known));
  }
  return *entities;
}

const CSpace::TMapPerType& CSpace::GetEntitiesByType(const std::string& type) const {
  return const_cast<CSpace*>(this)->GetEntitiesByType(type);
}

void CSpace::SetFloorEntity(CFloorEntity& floor) {
  CheckMayChange();
  m_floor = &floor;
}

CFloorEntity& CSpace::GetFloorEntity() {
  if (m_floor == nullptr) {
    THROW_ARGOSEXCEPTION("the arena has no floor; add a <floor> element to <arena>");
  }
  return *m_floor;
}

}  // namespace argos
