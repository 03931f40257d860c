#ifndef ARGOS3_PLUGINS_ENTITIES_PROXIMITY_SENSOR_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_PROXIMITY_SENSOR_EQUIPPED_ENTITY_H

#include <argos3/plugins/simulator/entities/ray_layout.h>
#include <argos3/plugins/simulator/entities/sensor_equipped_entity.h>

#include <vector>

namespace argos {

/** A proximity sensor, for users; see CProximitySensorEquippedEntity::GetSensors(). */
struct SProximitySensor {
  CVector3 Offset; /**< start of the ray in the anchor's frame, m */
  CVector3 Direction; /**< from start to end in the anchor's frame; its length is the range, m */
  SAnchor& Anchor;

  typedef std::vector<SProximitySensor*> TList;

  /** @param direction of any length. @param range m. */
  SProximitySensor(const CVector3& offset, const CVector3& direction, Real range, SAnchor& anchor)
      : Offset(offset), Direction(WithLength(direction, range)), Anchor(anchor) {}
  SProximitySensor(const SSensorRay& ray, SAnchor& anchor)
      : Offset(ray.Offset), Direction(ray.Direction), Anchor(anchor) {}

  /** Copies the sensor to its ray. @return true if they differed. */
  bool WriteTo(SSensorRay& ray) const { return ray.Set(Offset, Direction); }
};

/** The proximity sensors on a body: rays fixed in the frames of its anchors. */
class CProximitySensorEquippedEntity : public CSensorEquippedEntity<SRayLayout, SProximitySensor> {
 public:
  ENABLE_VTABLE();

  typedef SProximitySensor SSensor;
  typedef SSensorRay SRay;

  using CSensorEquippedEntity::CSensorEquippedEntity;

  std::string GetTypeDescription() const override { return "proximity_sensors"; }

  /** See SRayLayout::AddSensor(). */
  void AddSensor(const CVector3& offset, const CVector3& direction, Real range, SAnchor& anchor);
  /**
   * Adds rays that start on a horizontal circle and point outward, counter-clockwise: ray i at
   * startAngle + i * 2 PI / num.
   */
  void AddSensorRing(const CVector3& center, Real radius, const CRadians& startAngle, Real range,
                     UInt32 num, SAnchor& anchor);
  /** See SRayLayout::AddSensorFan(). */
  void AddSensorFan(const CVector3& center, Real radius, const CRadians& startAngle,
                    const CRadians& endAngle, Real range, UInt32 num, SAnchor& anchor);
};

}  // namespace argos

#endif
