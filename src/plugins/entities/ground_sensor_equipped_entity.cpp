#include <argos3/plugins/simulator/entities/ground_sensor_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/space/space_operations.h>

namespace argos {

void SGroundSensorLayout::AddSensor(const CVector2& offset, SGroundSensorPlace::ESensorType type,
                                    UInt32 anchor) {
  Places.push_back({offset, type, anchor});
}

void SGroundSensorLayout::AddSensorRing(const CVector2& center, Real radius,
                                        const CRadians& startAngle,
                                        SGroundSensorPlace::ESensorType type, UInt32 num,
                                        UInt32 anchor) {
  for (UInt32 i = 0; i < num; ++i) {
    AddSensor(center + CVector2(radius, startAngle + CRadians::TWO_PI * i / num), type, anchor);
  }
}

bool SGroundSensor::WriteTo(SGroundSensorPlace& place) const {
  if (Offset == place.Offset && Type == place.Type) {
    return false;
  }
  place.Offset = Offset;
  place.Type = Type;
  return true;
}

void CGroundSensorEquippedEntity::AddSensor(const CVector2& offset, ESensorType type,
                                            SAnchor& anchor) {
  Append(anchor, [&](SGroundSensorLayout& layout, UInt32 number) {
    layout.AddSensor(offset, type, number);
  });
}

void CGroundSensorEquippedEntity::AddSensorRing(const CVector2& center, Real radius,
                                                const CRadians& startAngle, ESensorType type,
                                                UInt32 num, SAnchor& anchor) {
  Append(anchor, [&](SGroundSensorLayout& layout, UInt32 number) {
    layout.AddSensorRing(center, radius, startAngle, type, num, number);
  });
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CGroundSensorEquippedEntity)

}  // namespace argos
