#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings_impl.h>

namespace argos {

CVector2 CCI_FootBotBaseGroundSensor::GetOffset(UInt32 index) {
  // cm, as published with ARGoS 3
  constexpr Real kOffsets[kNumSensors][2] = {{8.0, 0.0},  {4.2, 6.5},   {0.0, 8.0},  {-4.2, 6.5},
                                             {-8.0, 0.0}, {-4.2, -6.5}, {0.0, -8.0}, {4.2, -6.5}};
  return CVector2(kOffsets[index][0], kOffsets[index][1]);
}

const SSensorPlaces<CVector2> CCI_FootBotBaseGroundSensor::kPlaces = {
    "footbot_base_ground", "base_ground", kNumSensors, &GetOffset};

template class CPlacedSensors<COffsetReadings<CCI_FootBotBaseGroundSensor>, CVirtualTableSensor>;

}  // namespace argos
