#include <argos3/plugins/simulator/outputs/recording/tracked_entity.h>

#include <argos3/core/simulator/entity/anchor.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/existing_component.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/positional_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/memory/load_ahead.h>
#include <argos3/plugins/simulator/entities/directional_led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/led_equipped_entity.h>
#include <argos3/plugins/simulator/entities/light_entity.h>

#include <algorithm>
#include <bit>

namespace argos {

CTrackedEntity::CTrackedEntity(CEntity& root) : m_root(&root), m_index(root.GetIndex()) {
  if (auto* const composable = dynamic_cast<CComposableEntity*>(&root)) {
    FindParts(*composable);
  } else if (auto* const place = dynamic_cast<CPositionalEntity*>(&root)) {
    m_light = dynamic_cast<CLightEntity*>(&root);
    m_kind = m_light != nullptr ? SRecordedType::EKind::Light : SRecordedType::EKind::Place;
    m_place = place;
  } else if (dynamic_cast<CFloorEntity*>(&root) != nullptr) {
    m_kind = SRecordedType::EKind::Floor;
  }
}

void CTrackedEntity::FindParts(CComposableEntity& entity) {
  m_composable = &entity;
  m_numComponents = entity.GetExistingComponents().size();
  m_robot = FindExistingComponent<CControllableEntity>(entity);
  m_leds = FindExistingComponent<CLEDEquippedEntity>(entity);
  if (m_leds == nullptr) {
    m_directionalLEDs = FindExistingComponent<CDirectionalLEDEquippedEntity>(entity);
  }
  m_numLEDs = CountLEDs();
  if (auto* const body = FindExistingComponent<CEmbodiedEntity>(entity)) {
    m_kind = SRecordedType::EKind::Body;
    m_origin = &body->GetOriginAnchor();
    FindAnchors();
  }
}

// directional LEDs that the appearance has
UInt32 CTrackedEntity::CountLEDs() const {
  if (m_leds != nullptr) {
    return static_cast<UInt32>(m_leds->GetNumLEDs());
  }
  const SAppearance* const appearance =
      m_directionalLEDs == nullptr ? nullptr : m_root->GetAppearance();
  if (appearance == nullptr) {
    return 0;
  }
  size_t count = 0;
  for (const SVisualPart& part : appearance->Parts) {
    if (part.Kind == SVisualPart::EKind::LED) {
      count = std::max(count, size_t(part.LED) + 1);
    }
  }
  return static_cast<UInt32>(std::min(count, m_directionalLEDs->GetNumLEDs()));
}

void CTrackedEntity::FindAnchors() {
  const SAppearance* const appearance = m_root->GetAppearance();
  if (appearance == nullptr) {
    return;
  }
  const auto& anchors = m_origin->Body.GetAnchors();
  for (const SVisualPart& part : appearance->Parts) {
    const auto found = anchors.find(part.Anchor);
    if (found != anchors.end() && found->second != m_origin &&
        std::find(m_anchors.begin(), m_anchors.end(), found->second) == m_anchors.end()) {
      m_anchors.push_back(found->second);
    }
  }
}

bool CTrackedEntity::Is(const CEntity& root) const {
  return m_root == &root && m_index == root.GetIndex();
}

bool CTrackedEntity::HasNewParts() const {
  return m_composable != nullptr &&
         (m_composable->GetExistingComponents().size() != m_numComponents ||
          (m_leds != nullptr && m_leds->GetNumLEDs() != m_numLEDs));
}

bool CTrackedEntity::IsLike(const CTrackedEntity& other) const {
  // lamps and robots may have appearances of their own
  const SAppearance* const appearance = m_root->GetAppearance();
  return appearance != nullptr && appearance == other.m_root->GetAppearance() &&
         m_kind == SRecordedType::EKind::Body && m_kind == other.m_kind &&
         m_numLEDs == other.m_numLEDs && m_anchors.size() == other.m_anchors.size() &&
         (m_robot == nullptr) == (other.m_robot == nullptr) &&
         m_origin->Body.GetBodyDescription() == other.m_origin->Body.GetBodyDescription() &&
         m_origin->Body.IsMovable() == other.m_origin->Body.IsMovable() &&
         m_root->GetTypeDescription() == other.m_root->GetTypeDescription();
}

SRecordedType CTrackedEntity::MakeType() const {
  SRecordedType type;
  type.Kind = m_kind;
  type.Tag = m_root->GetTypeDescription();
  type.IsRobot = m_robot != nullptr;
  type.NumLEDs = m_numLEDs;
  const SAppearance* const appearance = m_root->GetAppearance();
  // a lamp makes its appearance of its colour
  if (appearance != nullptr && m_light == nullptr) {
    type.HasAppearance = true;
    type.Appearance = *appearance;
  }
  for (const SAnchor* anchor : m_anchors) {
    type.Anchors.push_back(anchor->Id);
  }
  if (m_origin != nullptr) {
    const SBodyDescription* const description = m_origin->Body.GetBodyDescription();
    type.IsMovable = m_origin->Body.IsMovable();
    type.Flies = description != nullptr && description->Propellers.has_value();
    if (description != nullptr && !description->Shapes.empty()) {
      type.Box = description->ComputeBoundingBox(CVector3(), CQuaternion());
      type.Solids = description->Shapes;
      for (SShapeDescription& solid : type.Solids) {
        if (solid.Kind == SShapeDescription::EKind::Hull) {
          solid.Kind = SShapeDescription::EKind::Box;
          solid.Solid = nullptr;
        }
      }
    }
  }
  if (m_kind == SRecordedType::EKind::Floor) {
    const auto& floor = static_cast<const CFloorEntity&>(*m_root);
    type.Parameter = floor.IsPixelated()
                         ? floor.GetImageWidth() + (static_cast<UInt64>(floor.GetImageHeight())
                                                    << SRecordedType::kHeightShift)
                         : floor.GetPixelsPerMeter();
  }
  return type;
}

void CTrackedEntity::PrepareCheck() const {
  LoadAhead(*m_root);
  if (m_composable != nullptr) {
    LoadAhead(*m_composable);
  }
}

void CTrackedEntity::PrepareRead() const {
  if (m_origin != nullptr) {
    LoadAhead(*m_origin);
  }
  if (m_leds != nullptr) {
    LoadAhead(*m_leds);
  }
  if (m_robot != nullptr) {
    m_robot->LoadEntityAhead();
  }
}

void CTrackedEntity::PrepareColors() const {
  if (m_leds != nullptr) {
    const auto& colors = m_leds->GetLazyColors();
    LoadAhead(colors.data(), colors.size() * sizeof(CColor));
  }
}

void CTrackedEntity::AppendPoses(std::vector<SBodyPose>& poses) const {
  if (m_origin != nullptr) {
    poses.push_back(*m_origin);
    for (const SAnchor* anchor : m_anchors) {
      poses.push_back(ComputeVisiblePose(*anchor));
    }
  } else if (m_place != nullptr) {
    poses.push_back({m_place->GetPosition(), m_place->GetOrientation()});
  }
}

void CTrackedEntity::AppendWords(std::vector<UInt32>& words) const {
  const bool isQuarantined = m_robot != nullptr && m_robot->IsQuarantined();
  const bool isStopped = m_robot != nullptr && m_robot->IsStopped();
  words.push_back((isQuarantined ? UInt32(ENTITY_IS_QUARANTINED) : 0) |
                  (isStopped ? UInt32(ENTITY_IS_STOPPED) : 0));
  if (m_leds != nullptr && !m_leds->GetLazyColors().empty()) {
    const auto& colors = m_leds->GetLazyColors();
    const size_t start = words.size();
    words.resize(start + colors.size());
    std::transform(colors.begin(), colors.end(), words.begin() + static_cast<std::ptrdiff_t>(start),
                   PackColor);
  } else {
    for (UInt32 i = 0; i < m_numLEDs; ++i) {
      words.push_back(PackColor(m_leds != nullptr ? m_leds->GetLEDColor(i)
                                                  : m_directionalLEDs->GetLED(i).GetColor()));
    }
  }
  if (m_light != nullptr) {
    const UInt64 intensity = std::bit_cast<UInt64>(m_light->GetIntensity());
    words.push_back(PackColor(m_light->GetColor()));
    words.push_back(static_cast<UInt32>(intensity));
    words.push_back(static_cast<UInt32>(intensity >> 32));
  }
}

void CTrackedEntity::AppendRays(UInt32 number, std::vector<SRecordedRay>& rays) const {
  if (m_robot == nullptr) {
    return;
  }
  using EKind = SRecordedRay::EKind;
  for (const auto& [obstructed, ray] : m_robot->GetCheckedRays()) {
    rays.push_back(
        {number, obstructed ? EKind::Obstructed : EKind::Free, ray.GetStart(), ray.GetEnd()});
  }
  for (const CVector3& point : m_robot->GetIntersectionPoints()) {
    rays.push_back({number, EKind::HitPoint, point, point});
  }
}

}  // namespace argos
