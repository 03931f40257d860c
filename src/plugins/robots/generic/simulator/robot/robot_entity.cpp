#include <argos3/plugins/robots/generic/simulator/robot_entity.h>

#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/magnet_equipped_entity.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>
#include <argos3/plugins/simulator/entities/simple_radio_equipped_entity.h>
#include <argos3/plugins/simulator/entities/tag_equipped_entity.h>

#include <algorithm>
#include <cstring>

namespace argos {

CRobotEntity::CRobotEntity(const SRobotType& type, const std::string& id, const CVector3& position,
                           const CQuaternion& orientation)
    : CComposableEntity(nullptr, id), m_type(type) {
  SetLazyComponents(this);
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0", position, orientation);
  // components that must be updated after a move are counted by the body
  m_body->SetRootFollows(false);
  SAnchor& origin = m_body->GetOriginAnchor();
  SAnchor& ledAnchor = m_type.LEDAnchor.empty() ? origin : m_body->AddAnchor(m_type.LEDAnchor);
  m_leds = NewComponent<CLEDEquippedEntity>(*this, "leds_0");
  m_leds->SetLayout(m_type.LEDs, {&ledAnchor});
  m_proximity = NewComponent<CProximitySensorEquippedEntity>(*this, "proximity_0");
  m_proximity->SetLayout(m_type.Proximity, {&origin});
}

void CRobotEntity::AddController() {
  m_controllable = NewComponent<CControllableEntity>(*this, "controller_0");
}

void CRobotEntity::InitParts(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  m_body->Init(GetNode(tree, "body"));
  MountFromXML<CDirectionalLEDEquippedEntity>(tree, "directional_leds");
  MountFromXML<CTagEquippedEntity>(tree, "tags");
  MountFromXML<CMagnetEquippedEntity>(tree, "magnets");
  MountFromXML<CSimpleRadioEquippedEntity>(tree, "simple_radios");
  MountFromXML<CRFIDTagEquippedEntity>(tree, "rfid_tags");
}

template <typename COMPONENT>
void CRobotEntity::MountFromXML(TConfigurationNode& tree, const char* tag) {
  if (!NodeExists(tree, tag)) {
    return;
  }
  auto& component = MakeOnDemand<COMPONENT>();
  component.Init(GetNode(tree, tag));
  if (m_mounted == nullptr) {
    m_mounted = std::make_unique<CEntity::TVector>();
  }
  m_mounted->push_back(&component);
}

void CRobotEntity::SetDeviceParameters(const SDeviceParameters& parameters) {
  if (parameters != m_type.Parameters) {
    m_parameters = std::make_unique<const SDeviceParameters>(parameters);
  }
}

void CRobotEntity::InitController(TConfigurationNode& tree) {
  m_controllable->Init(GetNode(tree, "controller"));
}

void CRobotEntity::InitController(const std::string& controllerId) {
  if (!controllerId.empty()) {
    m_controllable->SetController(controllerId);
  }
}

void CRobotEntity::UpdateComponents() {
  if (m_leds->IsEnabled()) {
    m_leds->Update();
  }
  if (m_mounted != nullptr) {
    for (CEntity* component : *m_mounted) {
      component->Update();
    }
  }
  if (m_onDemand == nullptr) {
    return;
  }
  for (size_t i = 0; i < m_type.OnDemand.size(); ++i) {
    CEntity* const component = m_onDemand[i];
    if (component != nullptr && component->IsEnabled()) {
      component->Update();
    }
  }
}

void CRobotEntity::SetEnabled(bool enabled) {
  if (EnablesLater(*this, enabled)) {
    return;
  }
  const size_t num = m_onDemand != nullptr ? m_type.OnDemand.size() : 0;
  ARGOS_ASSERT(num <= 32, "a robot type has at most 32 components on demand");
  if (IsEnabled()) {
    m_inUse = 0;
    for (size_t i = 0; i < num; ++i) {
      m_inUse |= (m_onDemand[i] != nullptr && m_onDemand[i]->IsEnabled() ? 1U : 0U) << i;
    }
  }
  CComposableEntity::SetEnabled(enabled);
  for (size_t i = 0; enabled && i < num; ++i) {
    if (m_onDemand[i] != nullptr && (m_inUse >> i & 1U) == 0) {
      m_onDemand[i]->SetEnabled(false);
    }
  }
}

void CRobotEntity::UpdateDigest(CDigest& digest) const {
  // the parent's version would add all components, enabled or not
  CEntity::UpdateDigest(digest);  // NOLINT(bugprone-parent-virtual-call)
  for (const CEntity* component : GetExistingComponents()) {
    if (component->IsEnabled() || FindOnDemand(*component) == m_type.OnDemand.size()) {
      component->UpdateDigest(digest);
    }
  }
}

size_t CRobotEntity::FindOnDemand(const CEntity& component) const {
  size_t number = m_onDemand != nullptr ? 0 : m_type.OnDemand.size();
  while (number < m_type.OnDemand.size() && m_onDemand[number] != &component) {
    ++number;
  }
  return number;
}

void CRobotEntity::Forget(const CEntity& component) {
  const size_t number = FindOnDemand(component);
  if (number < m_type.OnDemand.size()) {
    m_onDemand[number] = nullptr;
  }
}

void CRobotEntity::Create(const std::string& type) {
  for (size_t i = 0; i < m_type.OnDemand.size(); ++i) {
    if (type.empty() || type == m_type.OnDemand[i].Type) {
      MakeComponent(i);
    }
  }
}

CEntity& CRobotEntity::GetOrCreateComponent(const char* type) {
  const auto lock = CRobotsCode::LockLazy();
  for (size_t i = 0; i < m_type.OnDemand.size(); ++i) {
    if (std::strcmp(type, m_type.OnDemand[i].Type) == 0) {
      MakeComponent(i);
      return *m_onDemand[i];
    }
  }
  THROW_ARGOSEXCEPTION("robot \"" << GetId() << "\" (" << GetTypeDescription()
                                  << ") has no component \"" << type << "\"");
}

void CRobotEntity::MakeComponent(size_t number) {
  if (m_onDemand == nullptr) {
    m_onDemand = std::make_unique<CEntity*[]>(m_type.OnDemand.size());
  }
  if (m_onDemand[number] != nullptr) {
    return;
  }
  CEntity& component = m_type.OnDemand[number].Make(*this);
  m_onDemand[number] = &component;
  if (GetIndex() >= 0) {
    CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(m_controllable->GetSpace(),
                                                                component);
  }
}

}  // namespace argos
