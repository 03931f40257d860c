#ifndef ARGOS3_PLUGINS_ENTITIES_GROUND_SENSOR_EQUIPPED_ENTITY_H
#define ARGOS3_PLUGINS_ENTITIES_GROUND_SENSOR_EQUIPPED_ENTITY_H

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/simulator/entities/sensor_equipped_entity.h>

#include <vector>

namespace argos {

/** Place of a ground sensor, common to a type of robot. */
struct SGroundSensorPlace {
  enum ESensorType {
    TYPE_BLACK_WHITE, /**< reads 0 or 1 */
    TYPE_GRAYSCALE /**< reads from 0, black, to 1, white */
  };

  CVector2 Offset; /**< offset in the xy plane of the anchor's frame, m */
  ESensorType Type = TYPE_GRAYSCALE;
  UInt32 Anchor = 0; /**< index of the anchor in the layout */
};

/** The ground sensors, common to a type of robot. */
struct SGroundSensorLayout {
  typedef SGroundSensorPlace TPlace;

  std::vector<SGroundSensorPlace> Places;

  std::vector<SGroundSensorPlace>& GetPlaces() { return Places; }
  const std::vector<SGroundSensorPlace>& GetPlaces() const { return Places; }

  /** @param offset in the xy plane of the anchor's frame, m. */
  void AddSensor(const CVector2& offset, SGroundSensorPlace::ESensorType type, UInt32 anchor = 0);
  /** Adds sensors on a circle, counter-clockwise: i at startAngle + i * 2 PI / num. */
  void AddSensorRing(const CVector2& center, Real radius, const CRadians& startAngle,
                     SGroundSensorPlace::ESensorType type, UInt32 num, UInt32 anchor = 0);
  /** Does nothing: no data are derived from the places. */
  void ComputeBounds() {}
};

/** A ground sensor, for users; see CGroundSensorEquippedEntity::GetSensors(). */
struct SGroundSensor {
  CVector2 Offset; /**< offset in the xy plane of the anchor's frame, m */
  SGroundSensorPlace::ESensorType Type;
  SAnchor& Anchor;

  typedef std::vector<SGroundSensor*> TList;

  SGroundSensor(const CVector2& offset, SGroundSensorPlace::ESensorType type, SAnchor& anchor)
      : Offset(offset), Type(type), Anchor(anchor) {}
  SGroundSensor(const SGroundSensorPlace& place, SAnchor& anchor)
      : SGroundSensor(place.Offset, place.Type, anchor) {}

  /** Copies the sensor to its place. @return true if they differed. */
  bool WriteTo(SGroundSensorPlace& place) const;
};

/** Sensors under a body that measure the colour of the floor. */
class CGroundSensorEquippedEntity
    : public CSensorEquippedEntity<SGroundSensorLayout, SGroundSensor> {
 public:
  ENABLE_VTABLE();

  typedef SGroundSensor SSensor;
  typedef SGroundSensorPlace::ESensorType ESensorType;
  static constexpr ESensorType TYPE_BLACK_WHITE = SGroundSensorPlace::TYPE_BLACK_WHITE;
  static constexpr ESensorType TYPE_GRAYSCALE = SGroundSensorPlace::TYPE_GRAYSCALE;

  using CSensorEquippedEntity::CSensorEquippedEntity;

  std::string GetTypeDescription() const override { return "ground_sensors"; }

  /** See SGroundSensorLayout. */
  void AddSensor(const CVector2& offset, ESensorType type, SAnchor& anchor);
  void AddSensorRing(const CVector2& center, Real radius, const CRadians& startAngle,
                     ESensorType type, UInt32 num, SAnchor& anchor);
};

}  // namespace argos

#endif
