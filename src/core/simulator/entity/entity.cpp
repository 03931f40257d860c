#include <argos3/core/simulator/entity/entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/utility/datatypes/digest.h>

#include <memory>

namespace argos {

INIT_VTABLE_FOR(CEntity)

namespace {

thread_local UInt32 numSetups = 0;  // number of setups that exist in this thread

}  // namespace

CEntity::CEntity(CComposableEntity* parent) : CEntity(parent, std::string()) {}

CEntity::CEntity(CComposableEntity* parent, const std::string& id)
    : m_parent(parent), m_id(id), m_index(-1), m_isCopy(false) {}

CEntity::CEntity(const CEntity& other)
    : CBaseConfigurableResource(other),
      EnableVTableFor<CEntity>(other),
      CSlabObject(other),
      m_parent(other.m_parent),
      m_id(other.m_id),
      m_index(other.m_index),
      m_isCopy(true),
      m_enabled(other.m_enabled),
      m_enabledAtStart(other.m_enabledAtStart) {
  if (other.m_configurationNode != nullptr) {
    SetNode(*other.m_configurationNode);
  }
}

CEntity& CEntity::operator=(const CEntity& other) {
  if (this != &other) {
    // one in a space stays what it is
    if (!m_isCopy && (m_parent != nullptr || m_index >= 0)) {
      THROW_ARGOSEXCEPTION("entity \"" << GetContext() << m_id
                                       << "\" is in use: only a copy can be assigned to");
    }
    ReleaseNode();
    m_parent = other.m_parent;
    m_id = other.m_id;
    m_index = other.m_index;
    m_isCopy = true;
    m_enabled = other.m_enabled;
    m_enabledAtStart = other.m_enabledAtStart;
    m_startValues.reset();
    if (other.m_configurationNode != nullptr) {
      SetNode(*other.m_configurationNode);
    }
  }
  return *this;
}

CEntity::~CEntity() {
  ReleaseNode();
}

void CEntity::ReleaseNode() {
  if (m_ownsNode) {
    const std::unique_ptr<TConfigurationNode> owned(m_configurationNode);
  }
  m_configurationNode = nullptr;
  m_ownsNode = false;
}

void CEntity::SetNode(TConfigurationNode& node) {
  // kept as a pointer, because there is one in each of a million entities
  const bool isLasting = node.IsLasting();
  TConfigurationNode* const kept =
      isLasting ? &node : std::make_unique<TConfigurationNode>(node).release();
  ReleaseNode();
  m_configurationNode = kept;
  m_ownsNode = !isLasting;
}

void CEntity::Init(TConfigurationNode& tree) {
  SetNode(tree);
  if (NodeAttributeExists(tree, "id")) {
    GetNodeAttribute(tree, "id", m_id);
    return;
  }
  if (!HasParent()) {
    THROW_ARGOSEXCEPTION(tree.GetLocation() << ": <" << tree.Value()
                                            << ">: every entity in the arena needs an \"id\"");
  }
  // numbered among the components of its type that the parent already has
  const std::string type = GetTypeDescription();
  size_t number = 0;
  for (CEntity* component : m_parent->GetExistingComponents()) {
    number += component != this && component->GetTypeDescription() == type ? 1 : 0;
  }
  m_id = type + "_" + std::to_string(number);
}

std::string CEntity::GetContext() const {
  return m_parent != nullptr ? m_parent->GetContext() + m_parent->GetId() + "." : std::string();
}

CComposableEntity& CEntity::GetParent() {
  if (m_parent == nullptr) {
    THROW_ARGOSEXCEPTION("entity \"" << m_id << "\" is a root entity: it has no parent");
  }
  return *m_parent;
}

const CComposableEntity& CEntity::GetParent() const {
  return const_cast<CEntity*>(this)->GetParent();
}

void CEntity::SetParent(CComposableEntity& parent) {
  m_parent = &parent;
}

CEntity& CEntity::GetRootEntity() {
  CEntity* entity = this;
  while (entity->m_parent != nullptr) {
    entity = entity->m_parent;
  }
  return *entity;
}

const CEntity& CEntity::GetRootEntity() const {
  return const_cast<CEntity*>(this)->GetRootEntity();
}

void CEntity::SetEnabled(bool enabled) {
  if (CRobotsCode::MayRun()) {
    CRobotsCode::CheckOwn(*this, enabled ? "Enable()" : "Disable()");
  }
  m_enabled = enabled;
  if (m_index < 0) {
    m_enabledAtStart = enabled;
  }
}

void CEntity::ReturnToStart() {
  if (m_enabled != m_enabledAtStart) {
    SetEnabled(m_enabledAtStart);
  }
  if (m_startValues != nullptr) {
    m_startValues->Restore();
    m_startValues.reset();
  }
}

bool CEntity::MustKeep(const void* key) {
  if (numSetups > 0 && m_startValues != nullptr) {
    m_startValues->Remove(key);
  }
  return m_index >= 0 && !m_isCopy && numSetups == 0 &&
         (m_startValues == nullptr || !m_startValues->Has(key));
}

CEntity::CSetup::CSetup() {
  ++numSetups;
}

CEntity::CSetup::~CSetup() {
  --numSetups;
}

void CEntity::Keep(const void* key, std::function<void()> restore) {
  if (m_startValues == nullptr) {
    m_startValues = std::make_unique<CStartValues>();
  }
  m_startValues->Add(key, std::move(restore));
}

void CEntity::UpdateDigest(CDigest& digest) const {
  digest.Add(m_enabled);
}

}  // namespace argos
