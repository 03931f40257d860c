#include <argos3/core/simulator/entity/composable_entity.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/lazy_components.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/text/string_utilities.h>

#include <algorithm>

namespace argos {

namespace {

// one step of a component path: "type" or "type[id]"
struct SStep {
  std::string Type;
  std::string Id;  // empty: any
};

// splits the first step off a path; ids may hold dots
SStep TakeStep(const std::string& path, std::string& rest) {
  SStep step;
  const size_t dot = path.find('.');
  const size_t open = path.find('[');
  size_t end = std::min(dot, path.size());
  if (open < end) {
    const size_t close = path.find(']', open);
    if (close == std::string::npos) {
      THROW_ARGOSEXCEPTION("malformed component path \"" << path << "\": \"]\" is missing");
    }
    step.Id = path.substr(open + 1, close - open - 1);
    end = close + 1;
  }
  step.Type = path.substr(0, std::min(open, end));
  rest = end < path.size() ? path.substr(end + 1) : std::string();
  return step;
}

bool Matches(const CEntity& component, const SStep& step) {
  return (step.Id.empty() || component.GetId() == step.Id) &&
         component.GetTypeDescription() == step.Type;
}

// a capacity that suits most robots
constexpr size_t kNumComponents = 5;

}  // namespace

CComposableEntity::CComposableEntity(CComposableEntity* parent) : CEntity(parent) {}

CComposableEntity::CComposableEntity(CComposableEntity* parent, const std::string& id)
    : CEntity(parent, id) {}

CComposableEntity::CComposableEntity(const CComposableEntity& other)
    : CEntity(other), m_components(other.m_components), m_lazyComponents(other.m_lazyComponents) {}

CComposableEntity& CComposableEntity::operator=(const CComposableEntity& other) {
  if (this != &other) {
    const bool wasOwner = !IsCopy();
    CEntity::operator=(other);
    if (wasOwner) {
      DeleteComponents();
    }
    m_components = other.m_components;
    m_componentMap.reset();
    m_lazyComponents = other.m_lazyComponents;
  }
  return *this;
}

CComposableEntity::~CComposableEntity() {
  if (!IsCopy()) {
    DeleteComponents();
  }
}

// needed only for entities that were never in a space: the space removes components itself
void CComposableEntity::DeleteComponents() {
  while (!m_components.empty()) {
    const std::unique_ptr<CEntity> last(m_components.back());
    m_components.pop_back();
  }
}

void CComposableEntity::Reset() {
  for (CEntity* component : m_components) {
    component->Reset();
  }
}

void CComposableEntity::Destroy() {
  for (CEntity* component : m_components) {
    component->Destroy();
  }
}

void CComposableEntity::Update() {
  if (IsEnabled()) {
    UpdateComponents();
  }
}

void CComposableEntity::UpdateComponents() {
  for (CEntity* component : m_components) {
    if (component->IsEnabled()) {
      component->Update();
    }
  }
}

void CComposableEntity::SetEnabled(bool enabled) {
  CEntity::SetEnabled(enabled);
  for (CEntity* component : m_components) {
    component->SetEnabled(enabled);
  }
}

void CComposableEntity::MarkStart() {
  CEntity::MarkStart();
  for (CEntity* component : m_components) {
    component->MarkStart();
  }
}

void CComposableEntity::MarkStartValues() {
  CEntity::MarkStartValues();
  for (CEntity* component : m_components) {
    component->MarkStartValues();
  }
}

void CComposableEntity::ReturnToStart() {
  CEntity::ReturnToStart();
  // bodies last: a component that is enabled or disabled changes how often their anchors are in use
  for (const bool bodies : {false, true}) {
    for (CEntity* component : m_components) {
      if ((dynamic_cast<CEmbodiedEntity*>(component) != nullptr) == bodies) {
        component->ReturnToStart();
      }
    }
  }
}

void CComposableEntity::CheckIsNoCopy() const {
  if (IsCopy()) {
    THROW_ARGOSEXCEPTION("\"" << GetId() << "\" (" << GetTypeDescription()
                              << ") is a copy of an entity: change the components of the entity "
                                 "that is in the arena");
  }
}

void CComposableEntity::AddComponent(CEntity& component) {
  CheckIsNoCopy();
  component.SetParent(*this);
  if (m_components.empty()) {
    m_components.reserve(kNumComponents);
  }
  m_components.push_back(&component);
  m_componentMap.reset();
}

void CComposableEntity::InsertComponent(CEntity& component, const CEntity& next) {
  CheckIsNoCopy();
  component.SetParent(*this);
  m_components.insert(std::find(m_components.begin(), m_components.end(), &next), &component);
  m_componentMap.reset();
}

CEntity& CComposableEntity::RemoveComponent(const std::string& path) {
  CheckIsNoCopy();
  CRobotsCode::CheckShared(*this, "RemoveComponent()");
  CEntity& component = GetComponent(path);
  CComposableEntity& parent = component.GetParent();
  auto& siblings = parent.m_components;
  siblings.erase(std::find(siblings.begin(), siblings.end(), &component));
  parent.m_componentMap.reset();
  if (parent.m_lazyComponents != nullptr) {
    parent.m_lazyComponents->Forget(component);
  }
  return component;
}

void CComposableEntity::CreateLazyComponents(const std::string& type) {
  if (m_lazyComponents != nullptr) {
    m_lazyComponents->Create(type);
  }
}

CEntity* CComposableEntity::TryGetComponent(const std::string& path) {
  const auto lock = CRobotsCode::LockLazy();
  if (path.find_first_of(".[") == std::string::npos) {
    // a type
    CreateLazyComponents(path);
    const auto found = std::ranges::find(m_components, path, &CEntity::GetTypeDescription);
    return found != m_components.end() ? *found : nullptr;
  }
  std::string rest;
  const SStep step = TakeStep(path, rest);
  CreateLazyComponents(step.Type);
  for (CEntity* component : m_components) {
    if (!Matches(*component, step)) {
      continue;
    }
    if (rest.empty()) {
      return component;
    }
    auto* composable = dynamic_cast<CComposableEntity*>(component);
    CEntity* found = composable != nullptr ? composable->TryGetComponent(rest) : nullptr;
    if (found != nullptr) {
      return found;
    }
  }
  return nullptr;
}

CEntity& CComposableEntity::GetComponent(const std::string& path) {
  CEntity* component = TryGetComponent(path);
  if (component == nullptr) {
    std::vector<std::string> known;
    for (const CEntity* each : GetComponentVector()) {
      known.push_back(each->GetTypeDescription());
    }
    THROW_ARGOSEXCEPTION("\"" << GetContext() << GetId() << "\" (" << GetTypeDescription()
                              << ") has no component \"" << path << "\""
                              << DidYouMean(path, known));
  }
  return *component;
}

bool CComposableEntity::HasComponent(const std::string& path) {
  return TryGetComponent(path) != nullptr;
}

CEntity::TMultiMap::iterator CComposableEntity::FindComponent(const std::string& path) {
  CEntity* component = TryGetComponent(path);
  TMultiMap& map =
      component != nullptr ? component->GetParent().GetComponentMap() : GetComponentMap();
  return std::find_if(map.begin(), map.end(),
                      [component](const auto& entry) { return entry.second == component; });
}

CEntity::TMultiMap& CComposableEntity::GetComponentMap() {
  const auto lock = CRobotsCode::LockLazy();
  CreateLazyComponents(std::string());
  if (m_componentMap == nullptr) {
    m_componentMap = std::make_unique<TMultiMap>();
    for (CEntity* component : m_components) {
      m_componentMap->emplace(component->GetTypeDescription(), component);
    }
  }
  return *m_componentMap;
}

CEntity::TVector& CComposableEntity::GetComponentVector() {
  const auto lock = CRobotsCode::LockLazy();
  CreateLazyComponents(std::string());
  return m_components;
}

void CComposableEntity::ForgetComponent(const CEntity& component) {
  const auto found = std::find(m_components.rbegin(), m_components.rend(), &component);
  if (found != m_components.rend()) {
    m_components.erase(std::next(found).base());
    m_componentMap.reset();
    if (m_lazyComponents != nullptr) {
      m_lazyComponents->Forget(component);
    }
  }
}

void CComposableEntity::UpdateDigest(CDigest& digest) const {
  CEntity::UpdateDigest(digest);
  for (const CEntity* component : m_components) {
    component->UpdateDigest(digest);
  }
}

}  // namespace argos
