#include <argos3/plugins/simulator/entities/light_sensor_equipped_entity.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/space/space_operations.h>

namespace argos {

void CLightSensorEquippedEntity::AddSensor(const CVector3& position, const CVector3& direction,
                                           Real range, SAnchor& anchor) {
  Append(anchor, [&](SRayLayout& layout, UInt32 number) {
    layout.AddSensor(position, direction, range, number);
  });
}

void CLightSensorEquippedEntity::AddSensorRing(const CVector3& center, Real radius,
                                               const CRadians& startAngle, Real range, UInt32 num,
                                               SAnchor& anchor) {
  Append(anchor, [&](SRayLayout& layout, UInt32 number) {
    layout.AddSensorFan(center, radius, startAngle, startAngle + CRadians::TWO_PI, range, num,
                        number);
  });
}

REGISTER_STANDARD_SPACE_OPERATIONS_ON_ENTITY(CLightSensorEquippedEntity)

}  // namespace argos
