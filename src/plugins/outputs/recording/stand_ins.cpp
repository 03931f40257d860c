#include <argos3/plugins/simulator/outputs/recording/stand_ins.h>

#include <argos3/core/simulator/entity/anchor.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace argos {

namespace {

// views read this; the engines, which would use the rest, do not exist
std::shared_ptr<const SBodyDescription> DescribeBody(const SRecordedType& type) {
  const CVector3 size = type.Box.MaxCorner - type.Box.MinCorner;
  const CVector3 center = 0.5 * (type.Box.MaxCorner + type.Box.MinCorner);
  auto description = std::make_shared<SBodyDescription>();
  description->Shapes = type.Solids;
  if (type.Solids.empty()) {
    SShapeDescription& box = description->Shapes.emplace_back();
    box.Kind = SShapeDescription::EKind::Box;
    box.Size = size;
    box.Offset = CVector3(center.GetX(), center.GetY(), type.Box.MinCorner.GetZ());
  }
  if (type.Flies) {
    description->Propellers.emplace();
  }
  return description;
}

void SetPose(const SBodyPose& pose, SAnchor& anchor) {
  anchor.Position = pose.Position;
  anchor.Orientation = pose.Orientation;
}

}  // namespace

// bodies

CStandInBody::CStandInBody(CComposableEntity* parent, const SRecordedType& type)
    : CEmbodiedEntity(parent, "body_0", CVector3(), CQuaternion(), type.IsMovable),
      m_boxAtOrigin(type.Box),
      m_box(type.Box) {
  m_sBoundingBox = &m_box;
  SetRootFollows(false);
}

void CStandInBody::SetPose(const SBodyPose& pose) {
  argos::SetPose(pose, GetOriginAnchor());
  m_box.MinCorner = pose.Position + m_boxAtOrigin.MinCorner;
  m_box.MaxCorner = pose.Position + m_boxAtOrigin.MaxCorner;
}

CStandInEntity::CStandInEntity(const std::string& id, std::shared_ptr<const SRecordedType> type)
    : CComposableEntity(nullptr, id), m_type(std::move(type)) {
  AddParts();
}

void CStandInEntity::AddParts() {
  auto body = std::make_unique<CStandInBody>(this, *m_type);
  m_body = body.get();
  AddComponent(*body.release());
  m_body->SetBodyDescription(DescribeBody(*m_type));
  for (const std::string& id : m_type->Anchors) {
    m_anchors.push_back(&m_body->AddAnchor(id));
    m_anchors.back()->Enable();
  }
  if (m_type->NumLEDs > 0) {
    auto leds = std::make_unique<CLEDEquippedEntity>(this, "leds_0");
    m_leds = leds.get();
    AddComponent(*leds.release());
    auto layout = std::make_shared<CLEDEquippedEntity::SLayout>();
    layout->Places.resize(m_type->NumLEDs);
    m_leds->SetLayout(std::move(layout), {&m_body->GetOriginAnchor()});
  }
  if (m_type->IsRobot) {
    auto robot = std::make_unique<CControllableEntity>(this, "controller_0");
    m_robot = robot.get();
    AddComponent(*robot.release());
  }
}

const SAppearance* CStandInEntity::GetAppearance() const {
  return m_type->HasAppearance ? &m_type->Appearance : nullptr;
}

void CStandInEntity::SetState(const SRecordedState& state) {
  ARGOS_ASSERT(state.Poses.size() > m_anchors.size(),
               state.Poses.size() << " poses for " << m_anchors.size() << " anchors and the body");
  m_body->SetPose(state.Poses[0]);
  for (size_t i = 0; i < m_anchors.size(); ++i) {
    SetPose(state.Poses[i + 1], *m_anchors[i]);
  }
  if (m_robot != nullptr) {
    m_robot->SetQuarantined((state.Words[0] & ENTITY_IS_QUARANTINED) != 0);
    m_robot->SetStopped((state.Words[0] & (ENTITY_IS_QUARANTINED | ENTITY_IS_STOPPED)) != 0);
    m_robot->GetCheckedRays().clear();
    m_robot->GetIntersectionPoints().clear();
  }
  for (UInt32 i = 0; i < m_type->NumLEDs; ++i) {
    m_leds->SetLEDColor(i, UnpackColor(state.Words[1 + i]));
  }
}

// places

CStandInPlace::CStandInPlace(const std::string& id, std::shared_ptr<const SRecordedType> type)
    : CPositionalEntity(nullptr, id), m_type(std::move(type)) {}

const SAppearance* CStandInPlace::GetAppearance() const {
  return m_type->HasAppearance ? &m_type->Appearance : nullptr;
}

void CStandInPlace::SetState(const SRecordedState& state) {
  if (!state.Poses.empty()) {
    SetPosition(state.Poses[0].Position);
    SetOrientation(state.Poses[0].Orientation);
  }
}

// all of them

CReplayedEntity::CReplayedEntity(CSpace& space, const SRecordedEntity& entity,
                                 const std::shared_ptr<const SRecordedType>& type)
    : m_type(type) {
  std::unique_ptr<CEntity> made = Make(entity.Id);
  m_entity = made.get();
  space.Adopt(std::move(made));
}

std::unique_ptr<CEntity> CReplayedEntity::Make(const std::string& id) {
  const auto keep = [](auto made, auto*& pointer) {
    pointer = made.get();
    return made;
  };
  switch (m_type->Kind) {
    case SRecordedType::EKind::Body:
      return keep(std::make_unique<CStandInEntity>(id, m_type), m_body);
    case SRecordedType::EKind::Light:
      return keep(std::make_unique<CLightEntity>(id, CVector3(), CColor(), 0.0), m_light);
    case SRecordedType::EKind::Floor: {
      constexpr UInt64 kMaxPixelsPerMeter = 1000000;
      const UInt64 height = m_type->Parameter >> SRecordedType::kHeightShift;
      const UInt64 pixels = std::clamp<UInt64>(m_type->Parameter, 1, kMaxPixelsPerMeter);
      auto floor = std::make_unique<CFloorEntity>(id, static_cast<UInt32>(pixels));
      if (height > 0) {
        floor->SetImageSize(static_cast<UInt32>(m_type->Parameter), static_cast<UInt32>(height));
      }
      return keep(std::move(floor), m_floor);
    }
    default:
      return keep(std::make_unique<CStandInPlace>(id, m_type), m_place);
  }
}

CControllableEntity* CReplayedEntity::GetRobot() const {
  return m_body != nullptr ? m_body->GetRobot() : nullptr;
}

CReplayedFields* CReplayedEntity::GetFields() const {
  return m_body != nullptr ? &m_body->GetFields() : nullptr;
}

void CReplayedEntity::SetState(const SRecordedState& state) const {
  if (m_body != nullptr) {
    m_body->SetState(state);
  } else if (m_place != nullptr) {
    m_place->SetState(state);
  } else if (m_light != nullptr) {
    m_light->SetPosition(state.Poses[0].Position);
    m_light->SetOrientation(state.Poses[0].Orientation);
    m_light->SetColor(UnpackColor(state.Words[1]));
    const auto intensity =
        std::bit_cast<Real>(UInt64(state.Words[2]) | UInt64(state.Words[3]) << 32);
    m_light->SetIntensity(std::isfinite(intensity) ? intensity : 0.0);
  }
}

namespace {

// bodies enter no engine
class CSpaceOperationAddCStandInEntity : public CSpaceOperationAddEntity {
 public:
  void ApplyTo(CSpace& space, CStandInEntity& entity) {
    space.AddEntity(entity);
    space.AddEntity<CEmbodiedEntity>(entity.GetBody());
    if (entity.GetLEDs() != nullptr) {
      CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(space, *entity.GetLEDs());
    }
    if (entity.GetRobot() != nullptr) {
      CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(space, *entity.GetRobot());
    }
  }
};

}  // namespace

REGISTER_SPACE_OPERATION(CSpaceOperationAddEntity, CSpaceOperationAddCStandInEntity, CStandInEntity)
REGISTER_STANDARD_SPACE_OPERATION_REMOVE_COMPOSABLE(CStandInEntity)
REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CStandInPlace)

}  // namespace argos
