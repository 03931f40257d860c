#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

CProximitySensorEquippedEntity::SSensor::SSensor(const CVector3& offset, const CVector3& direction,
                                                 Real range, SAnchor& anchor)
    : Offset(offset), Direction(direction), Anchor(anchor) {
  Direction.Normalize();
  Direction *= range;
}

void CProximitySensorEquippedEntity::SLayout::AddSensor(const CVector3& offset,
                                                        const CVector3& direction, Real range,
                                                        UInt32 anchor) {
  RequirePositive(range, "proximity sensor", "range (m)");
  RequirePositive(direction.Length(), "proximity sensor", "length of the direction");
  SRay ray;
  ray.Offset = offset;
  ray.Direction = direction;
  ray.Direction.Normalize();
  ray.Direction *= range;
  ray.Anchor = anchor;
  Rays.push_back(ray);
  ComputeBounds();
}

void CProximitySensorEquippedEntity::SLayout::AddSensorFan(const CVector3& center, Real radius,
                                                           const CRadians& startAngle,
                                                           const CRadians& endAngle, Real range,
                                                           UInt32 num, UInt32 anchor) {
  for (UInt32 i = 0; i < num; ++i) {
    const CRadians angle = startAngle + (endAngle - startAngle) * i / num;
    const CVector3 outward(Cos(angle), Sin(angle), 0.0);
    AddSensor(center + outward * radius, outward, range, anchor);
  }
}

void CProximitySensorEquippedEntity::SLayout::ComputeBounds() {
  Planar = true;
  CenterX = CenterY = Reach = 0.0;
  for (const SRay& ray : Rays) {
    Planar = Planar && ray.Direction.GetZ() == 0.0 && ray.Anchor == Rays.front().Anchor;
    CenterX += ray.Offset.GetX() / static_cast<Real>(Rays.size());
    CenterY += ray.Offset.GetY() / static_cast<Real>(Rays.size());
  }
  for (const SRay& ray : Rays) {
    const Real startX = ray.Offset.GetX() - CenterX;
    const Real startY = ray.Offset.GetY() - CenterY;
    Reach = std::max({Reach, std::hypot(startX, startY),
                      std::hypot(startX + ray.Direction.GetX(), startY + ray.Direction.GetY())});
  }
}

CProximitySensorEquippedEntity::CProximitySensorEquippedEntity(CComposableEntity* parent)
    : CProximitySensorEquippedEntity(parent, std::string()) {}

CProximitySensorEquippedEntity::CProximitySensorEquippedEntity(CComposableEntity* parent,
                                                               const std::string& id)
    : CEntity(parent, id) {
  static const std::shared_ptr<const SLayout> kEmpty = std::make_shared<SLayout>();
  m_layout = kEmpty;
  CEntity::SetEnabled(false);
}

void CProximitySensorEquippedEntity::SetEnabled(bool enabled) {
  if (enabled == IsEnabled()) {
    return;
  }
  CEntity::SetEnabled(enabled);
  for (SAnchor* anchor : m_anchors) {
    // the origin anchor is always in use
    if (anchor->Index > 0) {
      enabled ? anchor->Enable() : anchor->Disable();
    }
  }
}

void CProximitySensorEquippedEntity::SetLayout(std::shared_ptr<const SLayout> layout,
                                               const std::vector<SAnchor*>& anchors) {
  ARGOS_ASSERT(GetNumSensors() == 0, "a layout replaces sensors that exist already");
  m_layout = std::move(layout);
  m_anchors.assign(anchors.begin(), anchors.end());
}

void CProximitySensorEquippedEntity::AddSensor(const CVector3& offset, const CVector3& direction,
                                               Real range, SAnchor& anchor) {
  SLayout layout = GetLayout();
  layout.AddSensor(offset, direction, range, NumberOfAnchor(anchor));
  Append(std::move(layout));
}

void CProximitySensorEquippedEntity::AddSensorRing(const CVector3& center, Real radius,
                                                   const CRadians& startAngle, Real range,
                                                   UInt32 num, SAnchor& anchor) {
  AddSensorFan(center, radius, startAngle, startAngle + CRadians::TWO_PI, range, num, anchor);
}

void CProximitySensorEquippedEntity::AddSensorFan(const CVector3& center, Real radius,
                                                  const CRadians& startAngle,
                                                  const CRadians& endAngle, Real range, UInt32 num,
                                                  SAnchor& anchor) {
  SLayout layout = GetLayout();
  layout.AddSensorFan(center, radius, startAngle, endAngle, range, num, NumberOfAnchor(anchor));
  Append(std::move(layout));
}

UInt32 CProximitySensorEquippedEntity::NumberOfAnchor(SAnchor& anchor) {
  const auto known = std::find(m_anchors.begin(), m_anchors.end(), &anchor);
  if (known != m_anchors.end()) {
    return static_cast<UInt32>(known - m_anchors.begin());
  }
  m_anchors.push_back(&anchor);
  if (IsEnabled() && anchor.Index > 0) {
    anchor.Enable();
  }
  // this use of the anchor stays after a Reset()
  if (IsEnabledAtStart() && anchor.Index > 0) {
    ++anchor.InUseCountAtStart;
  }
  return static_cast<UInt32>(m_anchors.size() - 1);
}

void CProximitySensorEquippedEntity::Append(SLayout&& layout) {
  const bool listed = m_sensors != nullptr;
  m_layout = std::make_shared<const SLayout>(std::move(layout));
  if (listed) {
    GetSensors();
  }
}

CProximitySensorEquippedEntity::SSensor& CProximitySensorEquippedEntity::GetSensor(size_t index) {
  if (index >= GetNumSensors()) {
    THROW_ARGOSEXCEPTION("proximity sensors \"" << GetContext() << GetId() << "\": no sensor "
                                                << index << "; there are " << GetNumSensors()
                                                << ", numbered from 0");
  }
  return *GetSensors()[index];
}

CProximitySensorEquippedEntity::SSensor::TList& CProximitySensorEquippedEntity::GetSensors() {
  if (m_sensors == nullptr) {
    m_sensors = std::make_unique<SSensors>();
  }
  for (size_t i = m_sensors->List.size(); i < GetNumSensors(); ++i) {
    const SRay& ray = m_layout->Rays[i];
    auto sensor = std::make_unique<SSensor>(ray.Offset, ray.Direction, ray.Direction.Length(),
                                            *m_anchors[ray.Anchor]);
    // exactly the ray: the constructor rounds
    sensor->Direction = ray.Direction;
    m_sensors->List.push_back(sensor.get());
    m_sensors->Owned.push_back(std::move(sensor));
  }
  return m_sensors->List;
}

void CProximitySensorEquippedEntity::TakeOverChanges() {
  std::shared_ptr<SLayout> changed;
  for (size_t i = 0; i < m_sensors->List.size(); ++i) {
    const SSensor& sensor = *m_sensors->List[i];
    const SRay& ray = m_layout->Rays[i];
    if (sensor.Offset == ray.Offset && sensor.Direction == ray.Direction) {
      continue;
    }
    if (changed == nullptr) {
      changed = std::make_shared<SLayout>(*m_layout);
    }
    changed->Rays[i].Offset = sensor.Offset;
    changed->Rays[i].Direction = sensor.Direction;
  }
  if (changed != nullptr) {
    changed->ComputeBounds();
    m_layout = std::move(changed);
  }
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CProximitySensorEquippedEntity)

}  // namespace argos
