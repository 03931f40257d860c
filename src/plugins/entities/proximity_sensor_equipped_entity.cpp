#include <argos3/plugins/simulator/entities/proximity_sensor_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/space/space_operations.h>

namespace argos {

void CProximitySensorEquippedEntity::AddSensor(const CVector3& offset, const CVector3& direction,
                                               Real range, SAnchor& anchor) {
  Append(anchor, [&](SRayLayout& layout, UInt32 number) {
    layout.AddSensor(offset, direction, range, number);
  });
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
  Append(anchor, [&](SRayLayout& layout, UInt32 number) {
    layout.AddSensorFan(center, radius, startAngle, endAngle, range, num, number);
  });
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CProximitySensorEquippedEntity)

}  // namespace argos
