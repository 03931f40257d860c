#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings_impl.h>

namespace argos {

CVector2 CCI_FootBotMotorGroundSensor::GetOffset(UInt32 index) {
  // cm, as published with ARGoS 3
  constexpr Real kOffsets[kNumSensors][2] = {
      {6.3, 1.16}, {-6.3, 1.16}, {-6.3, -1.16}, {6.3, -1.16}};
  return CVector2(kOffsets[index][0], kOffsets[index][1]);
}

const SSensorPlaces<CVector2> CCI_FootBotMotorGroundSensor::kPlaces = {
    "footbot_motor_ground", "motor_ground", kNumSensors, &GetOffset};

template class CPlacedSensors<COffsetReadings<CCI_FootBotMotorGroundSensor>>;

}  // namespace argos
