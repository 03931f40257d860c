#ifndef ARGOS3_PLUGINS_ENTITIES_LIGHT_SENSOR_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_LIGHT_SENSOR_EQUIPPED_ENTITY_H

#include <argos3/plugins/simulator/entities/ray_layout.h>
#include <argos3/plugins/simulator/entities/sensor_equipped_entity.h>

#include <vector>

namespace argos {

/** A light sensor, for users; see CLightSensorEquippedEntity::GetSensors(). */
struct SLightSensor {
  CVector3 Position; /**< position in the anchor's frame, m */
  CVector3 Direction; /**< away from the body, in the anchor's frame; its length is the range, m */
  SAnchor& Anchor;

  typedef std::vector<SLightSensor*> TList;

  /** @param direction of any length. @param range m. */
  SLightSensor(const CVector3& position, const CVector3& direction, Real range, SAnchor& anchor)
      : Position(position), Direction(WithLength(direction, range)), Anchor(anchor) {}
  SLightSensor(const SSensorRay& ray, SAnchor& anchor)
      : Position(ray.Offset), Direction(ray.Direction), Anchor(anchor) {}

  /** Copies the sensor to its ray. @return true if they differed. */
  bool WriteTo(SSensorRay& ray) const { return ray.Set(Position, Direction); }
};

/**
 * The light sensors on a body: a position and an outward direction each. The sensor that uses this
 * component defines the response to distance; the range has no effect.
 */
class CLightSensorEquippedEntity : public CSensorEquippedEntity<SRayLayout, SLightSensor> {
 public:
  ENABLE_VTABLE();

  typedef SLightSensor SSensor;

  using CSensorEquippedEntity::CSensorEquippedEntity;

  std::string GetTypeDescription() const override { return "light_sensors"; }

  /**
   * @param position   in the anchor's frame, m.
   * @param direction  away from the body, in the anchor's frame, of any length but 0.
   * @param range      m, > 0.
   * @throws CARGoSException if the direction is zero or the range is not > 0.
   */
  void AddSensor(const CVector3& position, const CVector3& direction, Real range, SAnchor& anchor);
  /** Adds sensors on a horizontal circle, counter-clockwise: i at startAngle + i * 2 PI / num. */
  void AddSensorRing(const CVector3& center, Real radius, const CRadians& startAngle, Real range,
                     UInt32 num, SAnchor& anchor);
};

}  // namespace argos

#endif
