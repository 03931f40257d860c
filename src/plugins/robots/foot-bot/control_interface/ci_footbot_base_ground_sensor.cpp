#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

CVector2 CCI_FootBotBaseGroundSensor::GetOffset(UInt32 index) {
  // cm, as published with ARGoS 3
  constexpr Real kOffsets[kNumSensors][2] = {{8.0, 0.0},  {4.2, 6.5},   {0.0, 8.0},  {-4.2, 6.5},
                                             {-8.0, 0.0}, {-4.2, -6.5}, {0.0, -8.0}, {4.2, -6.5}};
  return CVector2(kOffsets[index][0], kOffsets[index][1]);
}

CCI_FootBotBaseGroundSensor::CCI_FootBotBaseGroundSensor() {
  m_tReadings = MakeReadings<SReading>(kNumSensors, GetOffset);
}

void CCI_FootBotBaseGroundSensor::CreateLuaState(lua_State* state) {
  CLuaTable ground(state, *this, "base_ground");
  WriteOffsetReadings(ground, m_tReadings);
}

void CCI_FootBotBaseGroundSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable ground(state, *this);
  WriteOffsetReadings(ground, m_tReadings);
}

}  // namespace argos
