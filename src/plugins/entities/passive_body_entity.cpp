#include <argos3/plugins/simulator/entities/passive_body_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/simulator/visualization/solid_part.h>
#include <argos3/plugins/simulator/entities/new_component.h>
#include <argos3/plugins/simulator/entities/rfid_tag_equipped_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

namespace {

// these serve drawing only
constexpr Real kLEDDiameter = 0.02;  // m
constexpr CColor kMovableColor(74, 126, 187);
constexpr CColor kFixedColor(146, 150, 156);

}  // namespace

CPassiveBodyEntity::CPassiveBodyEntity() : CComposableEntity(nullptr) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0");
  m_leds = NewComponent<CLEDEquippedEntity>(*this, "leds_0");
}

CPassiveBodyEntity::CPassiveBodyEntity(const std::string& id, const CVector3& position,
                                       const CQuaternion& orientation, bool movable, Real mass)
    : CComposableEntity(nullptr, id), m_mass(mass) {
  m_body = NewComponent<CEmbodiedEntity>(*this, "body_0", position, orientation, movable);
  m_leds = NewComponent<CLEDEquippedEntity>(*this, "leds_0");
}

void CPassiveBodyEntity::InitBody(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  bool movable = false;
  GetNodeAttribute(tree, "movable", movable);
  if (movable) {
    ReadIn(kMass, tree, "mass", m_mass);
  } else {
    // read the attribute, which is allowed and ignored, so that it is not reported as unread
    NodeAttributeExists(tree, "mass");
    m_mass = 0.0;
  }
  m_body->Init(GetNode(tree, "body"));
  m_body->SetMovable(movable);
  if (NodeExists(tree, "leds")) {
    m_leds->Init(GetNode(tree, "leds"));
  }
  if (NodeExists(tree, "rfid_tags")) {
    GetRFIDTagEquippedEntity().Init(GetNode(tree, "rfid_tags"));
  }
}

void CPassiveBodyEntity::UpdateComponents() {
  if (m_leds->IsEnabled()) {
    m_leds->Update();
  }
  if (m_rfidTags != nullptr && m_rfidTags->IsEnabled()) {
    m_rfidTags->Update();
  }
}

CRFIDTagEquippedEntity& CPassiveBodyEntity::GetRFIDTagEquippedEntity() {
  const auto lock = CRobotsCode::LockLazy();
  if (m_rfidTags == nullptr) {
    m_rfidTags = NewComponent<CRFIDTagEquippedEntity>(*this, "rfid_tags_0");
    if (GetIndex() >= 0) {
      CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(CurrentSpace(), *m_rfidTags);
    }
  }
  return *m_rfidTags;
}

void CPassiveBodyEntity::EnableLEDs(CLEDEntity::CRegistry& medium) {
  CRobotsCode::CheckShared(*this, "EnableLEDs()");
  m_leds->SetMedium(medium);
  m_leds->Enable();
  m_leds->UpdateComponents();
}

void CPassiveBodyEntity::DisableLEDs() {
  CRobotsCode::CheckShared(*this, "DisableLEDs()");
  m_leds->Disable();
}

void CPassiveBodyEntity::AddLED(const CVector3& offset, const CColor& color) {
  CRobotsCode::CheckShared(*this, "AddLED()");
  m_leds->AddLED(offset, m_body->GetOriginAnchor(), color);
  MakeAppearance();
}

void CPassiveBodyEntity::SetMass(Real mass) {
  CRobotsCode::CheckShared(*this, "SetMass()");
  RequireIn(kMass, mass, GetTypeDescription() + " \"" + GetId() + "\"", "mass");
  KeepForReset(&m_mass, [this, start = m_mass] {
    ReturnBodyToStart();
    m_mass = start;
    Describe();
  });
  m_mass = mass;
  Describe();
}

void CPassiveBodyEntity::ReturnBodyToStart() {
  m_body->ReturnToStart();
  m_body->Reset();
}

void CPassiveBodyEntity::Describe() {
  auto description = std::make_shared<SBodyDescription>();
  description->Shapes.push_back(MakeShape());
  if (m_body->IsMovable()) {
    // one that was immovable in the file has none
    description->Mass = m_mass > 0.0 ? m_mass : kDefaultMass;
    description->GroundFriction.emplace().Class = GetFrictionClass();
    description->Grippable = true;
  }
  if (m_body->GetPhysicsModelsNum() > 0) {
    CSpace& space = m_body->GetPhysicsModel(size_t(0)).GetEngine().GetSpace();
    space.RemoveEntityFromPhysicsEngines(*m_body);
    m_body->SetBodyDescription(std::move(description));
    space.AddEntityToPhysicsEngine(*m_body);
  } else {
    m_body->SetBodyDescription(std::move(description));
  }
  MakeAppearance();
}

void CPassiveBodyEntity::MakeAppearance() {
  m_appearance.Parts.clear();
  m_appearance.Parts.push_back(
      MakeSolidPart(MakeShape(), m_body->IsMovable() ? kMovableColor : kFixedColor));
  for (size_t i = 0; i < m_leds->GetNumLEDs(); ++i) {
    SVisualPart led;
    led.Kind = SVisualPart::EKind::LED;
    led.Position = m_leds->GetLEDOffset(i);
    led.Size = CVector3(kLEDDiameter, kLEDDiameter, kLEDDiameter);
    led.LED = static_cast<UInt32>(i);
    m_appearance.Parts.push_back(led);
  }
  for (size_t i = 0; m_rfidTags != nullptr && i < m_rfidTags->GetNumTags(); ++i) {
    m_appearance.Parts.push_back(MakeRFIDTagPart(m_rfidTags->GetInstances()[i].PositionOffset));
  }
}

}  // namespace argos
