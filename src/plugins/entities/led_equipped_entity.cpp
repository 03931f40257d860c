#include <argos3/plugins/simulator/entities/led_equipped_entity.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/space/space_operations.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/plugins/simulator/entities/anchor_use.h>
#include <argos3/plugins/simulator/entities/read_medium.h>

#include <cmath>

namespace argos {

namespace {

constexpr Real kRounding = 1e-9;  // of the square length of unit quaternions
constexpr Real kFar = 1e6;  // m; farther poses are checked

bool IsNear(const CVector3& position) {
  return std::abs(position.GetX()) < kFar && std::abs(position.GetY()) < kFar &&
         std::abs(position.GetZ()) < kFar;
}

CVector3 ComputePosition(const CLEDEquippedEntity::SActuator& actuator) {
  CVector3 position = actuator.Offset;
  position.Rotate(actuator.Anchor.Orientation);
  return position + actuator.Anchor.Position;
}

}  // namespace

void CLEDEquippedEntity::SLayout::AddLED(const CVector3& offset, const CColor& color,
                                         UInt32 anchor) {
  SPlace place;
  place.Offset = offset;
  place.Anchor = anchor;
  place.Color = color;
  Places.push_back(place);
}

void CLEDEquippedEntity::SLayout::AddLEDRing(const CVector3& center, Real radius,
                                             const CRadians& startAngle, UInt32 num,
                                             const CColor& color, UInt32 anchor) {
  for (UInt32 i = 0; i < num; ++i) {
    const CRadians angle = startAngle + CRadians::TWO_PI * i / num;
    AddLED(center + CVector3(radius * Cos(angle), radius * Sin(angle), 0.0), color, anchor);
  }
}

CLEDEquippedEntity::CLEDEquippedEntity(CComposableEntity* parent)
    : CLEDEquippedEntity(parent, std::string()) {}

CLEDEquippedEntity::CLEDEquippedEntity(CComposableEntity* parent, const std::string& id)
    : CComposableEntity(parent, id) {
  static const std::shared_ptr<const SLayout> kEmpty = std::make_shared<SLayout>();
  m_layout = kEmpty;
  SetLazyComponents(this);
  CComposableEntity::SetEnabled(false);
}

void CLEDEquippedEntity::Init(TConfigurationNode& tree) {
  CComposableEntity::Init(tree);
  SetMedium(ReadMedium<CLEDEntity::CRegistry>(tree, CurrentSimulator(), "an LED medium"));
  auto& body = GetParent().GetComponent<CEmbodiedEntity>("body");
  TConfigurationNodeIterator led("led");
  for (led = led.begin(&tree); led != led.end(); ++led) {
    CVector3 offset;
    std::string anchor;
    CColor color;
    GetNodeAttribute(*led, "offset", offset);
    GetNodeAttribute(*led, "anchor", anchor);
    GetNodeAttribute(*led, "color", color);
    AddLED(offset, body.GetAnchor(anchor), color);
  }
  Enable();
  UpdateComponents();
}

void CLEDEquippedEntity::Reset() {
  CComposableEntity::Reset();
  // place the LEDs on bodies that no engine moves, too
  UpdateComponents();
  for (size_t i = 0; i < m_colors.size(); ++i) {
    m_colors[i] = m_layout->Places[i].Color;
  }
}

void CLEDEquippedEntity::UpdateComponents() {
  if (m_entities == nullptr) {
    return;
  }
  // what MoveTo() checks, once for the LEDs of an anchor
  const bool isShared = CRobotsCode::MayRun();
  const SAnchor* anchor = nullptr;
  bool isSound = false;
  for (SActuator* actuator : m_entities->List) {
    if (&actuator->Anchor != anchor) {
      anchor = &actuator->Anchor;
      isSound = !isShared && std::abs(anchor->Orientation.SquareLength() - 1.0) <= kRounding;
    }
    const CVector3 position = ComputePosition(*actuator);
    if (isSound && IsNear(position)) {
      actuator->LED.Follow(position, anchor->Orientation);
    } else {
      actuator->LED.MoveTo(position, anchor->Orientation);
    }
  }
}

void CLEDEquippedEntity::SetEnabled(bool enabled) {
  if (enabled == IsEnabled() || EnablesLater(*this, enabled)) {
    return;
  }
  CComposableEntity::SetEnabled(enabled);
  CountFollower(*this, enabled);
  for (SAnchor* anchor : m_anchors) {
    UseAnchor(*anchor, enabled);
  }
  if (enabled) {
    // neither the LEDs nor perhaps their anchors were updated while the LEDs were disabled
    UpdateComponents();
  }
}

void CLEDEquippedEntity::SetLayout(std::shared_ptr<const SLayout> layout,
                                   const std::vector<SAnchor*>& anchors) {
  ARGOS_ASSERT(GetNumLEDs() == 0, "a layout would replace existing LEDs");
  m_layout = std::move(layout);
  m_anchors.assign(anchors.begin(), anchors.end());
  m_colors.reserve(m_layout->Places.size());
  for (const SPlace& place : m_layout->Places) {
    m_colors.push_back(place.Color);
  }
}

void CLEDEquippedEntity::AddLED(const CVector3& offset, SAnchor& anchor, const CColor& color) {
  SLayout layout = *m_layout;
  layout.AddLED(offset, color, NumberOfAnchor(m_anchors, anchor, *this));
  Append(std::move(layout));
}

void CLEDEquippedEntity::AddLEDRing(const CVector3& center, Real radius, const CRadians& startAngle,
                                    UInt32 num, SAnchor& anchor, const CColor& color) {
  SLayout layout = *m_layout;
  layout.AddLEDRing(center, radius, startAngle, num, color,
                    NumberOfAnchor(m_anchors, anchor, *this));
  Append(std::move(layout));
}

void CLEDEquippedEntity::Append(SLayout&& layout) {
  CRobotsCode::CheckShared(*this, "AddLED()");
  const size_t numBefore = GetNumLEDs();
  // LEDs are entities if they have a medium or an index in the space
  const bool asEntities = m_medium != nullptr || GetIndex() >= 0 || m_entities != nullptr;
  if (asEntities) {
    Materialize();
  }
  m_layout = std::make_shared<const SLayout>(std::move(layout));
  for (size_t i = numBefore; i < GetNumLEDs(); ++i) {
    if (!asEntities) {
      m_colors.push_back(m_layout->Places[i].Color);
      continue;
    }
    CLEDEntity& led = MakeLED(i);
    if (GetIndex() >= 0) {
      // the indices directly after this entity's belong to the LEDs added before
      CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(CurrentSpace(), led);
    }
  }
}

CLEDEntity& CLEDEquippedEntity::MakeLED(size_t index) {
  const SPlace& place = m_layout->Places[index];
  auto owned =
      std::make_unique<CLEDEntity>(this, "led_" + std::to_string(index), CVector3(), place.Color);
  CLEDEntity& led = *owned;
  AddComponent(*owned.release());
  m_entities->Owned.push_back(
      std::make_unique<SActuator>(led, place.Offset, *m_anchors[place.Anchor]));
  m_entities->List.push_back(m_entities->Owned.back().get());
  PlaceLED(*m_entities->List.back());
  if (m_medium != nullptr) {
    led.SetMedium(*m_medium);
  }
  if (place.IsSeenFromBeneath) {
    led.SetBodyOpenBeneath(&GetParent().GetComponent<CEmbodiedEntity>("body"));
  }
  led.SetEnabled(IsEnabled());
  led.SetEnabledAtStart(IsEnabledAtStart());
  return led;
}

void CLEDEquippedEntity::PlaceLED(SActuator& actuator) const {
  actuator.LED.MoveTo(ComputePosition(actuator), actuator.Anchor.Orientation);
}

void CLEDEquippedEntity::Materialize() {
  const auto lock = CRobotsCode::LockLazy();
  if (m_entities != nullptr) {
    return;
  }
  const TLazyColors colors = std::move(m_colors);
  m_colors = {};
  m_entities = std::make_unique<SEntities>();
  for (size_t i = 0; i < colors.size(); ++i) {
    CLEDEntity& led = MakeLED(i);
    led.SetColor(colors[i]);
    if (GetIndex() >= 0) {
      led.SetIndex(GetIndex() + 1 + static_cast<ssize_t>(i));
    }
  }
}

const CColor& CLEDEquippedEntity::GetLEDColor(size_t index) const {
  CheckIndex(index);
  return m_entities != nullptr ? m_entities->List[index]->LED.GetColor() : m_colors[index];
}

CLEDEntity& CLEDEquippedEntity::GetLED(UInt32 index) {
  CheckIndex(index);
  Materialize();
  return m_entities->List[index]->LED;
}

CLEDEquippedEntity::SActuator::TList& CLEDEquippedEntity::GetLEDs() {
  Materialize();
  return m_entities->List;
}

const CVector3& CLEDEquippedEntity::GetLEDOffset(size_t index) const {
  CheckIndex(index);
  return m_entities != nullptr ? m_entities->List[index]->Offset : m_layout->Places[index].Offset;
}

const SAnchor& CLEDEquippedEntity::GetLEDAnchor(size_t index) const {
  CheckIndex(index);
  return m_entities != nullptr ? m_entities->List[index]->Anchor
                               : *m_anchors[m_layout->Places[index].Anchor];
}

void CLEDEquippedEntity::SetLEDOffset(UInt32 index, const CVector3& offset) {
  CRobotsCode::CheckShared(*this, "SetLEDOffset()");
  CheckIndex(index);
  KeepForReset(&m_layout, [this, start = m_layout] {
    for (size_t i = 0; i < start->Places.size(); ++i) {
      SetLEDOffset(static_cast<UInt32>(i), start->Places[i].Offset);
    }
  });
  auto layout = std::make_shared<SLayout>(*m_layout);
  layout->Places[index].Offset = offset;
  m_layout = std::move(layout);
  if (m_entities != nullptr) {
    m_entities->List[index]->Offset = offset;
    PlaceLED(*m_entities->List[index]);
  }
}

void CLEDEquippedEntity::SetLEDColor(UInt32 index, const CColor& color) {
  CheckIndex(index);
  if (CRobotsCode::ChangesLater(*this, "SetLEDColor()",
                                [this, index, color] { SetLEDColor(index, color); })) {
    return;
  }
  if (m_entities != nullptr) {
    m_entities->List[index]->LED.SetColor(color);
  } else {
    m_colors[index] = color;
  }
}

void CLEDEquippedEntity::SetAllLEDsColors(const CColor& color) {
  for (size_t i = 0; i < GetNumLEDs(); ++i) {
    SetLEDColor(static_cast<UInt32>(i), color);
  }
}

void CLEDEquippedEntity::SetAllLEDsColors(const std::vector<CColor>& colors) {
  if (colors.size() != GetNumLEDs()) {
    THROW_ARGOSEXCEPTION("LEDs \"" << GetContext() << GetId() << "\": got " << colors.size()
                                   << " colors for " << GetNumLEDs() << " LEDs");
  }
  const bool isShared = CRobotsCode::MayRun();
  for (size_t i = 0; i < colors.size(); ++i) {
    // most keep their colours
    if (m_entities == nullptr || isShared || m_entities->List[i]->LED.GetColor() != colors[i]) {
      SetLEDColor(static_cast<UInt32>(i), colors[i]);
    }
  }
}

void CLEDEquippedEntity::SetMedium(CLEDEntity::CRegistry& medium) {
  CRobotsCode::CheckShared(*this, "SetMedium()");
  KeepForReset(m_medium);
  m_medium = &medium;
  Materialize();
  for (SActuator* actuator : m_entities->List) {
    actuator->LED.SetMedium(medium);
  }
}

void CLEDEquippedEntity::UpdateDigest(CDigest& digest) const {
  digest.Add(IsEnabled());
  for (size_t i = 0; i < GetNumLEDs(); ++i) {
    const CColor& color = GetLEDColor(i);
    digest.Add(color.GetRed());
    digest.Add(color.GetGreen());
    digest.Add(color.GetBlue());
    digest.Add(color.GetAlpha());
  }
}

void CLEDEquippedEntity::CheckIndex(size_t index) const {
  if (index >= GetNumLEDs()) {
    THROW_ARGOSEXCEPTION("LEDs \"" << GetContext() << GetId() << "\": no LED " << index
                                   << "; there are " << GetNumLEDs() << ", numbered from 0");
  }
}

namespace {

class CSpaceOperationAddCLEDEquippedEntity : public CSpaceOperationAddEntity {
 public:
  void ApplyTo(CSpace& space, CLEDEquippedEntity& entity) {
    space.AddEntity(entity);
    // the LEDs that are created later come right after their parent in the order of entities
    space.SkipIndices(entity.GetNumLazyLEDs());
    AddComponentsToSpace(space, entity);
  }
};

}  // namespace

REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAddCLEDEquippedEntity,
                         CLEDEquippedEntity)
REGISTER_STANDARD_SPACE_OPERATION_REMOVE_COMPOSABLE(CLEDEquippedEntity)

}  // namespace argos
