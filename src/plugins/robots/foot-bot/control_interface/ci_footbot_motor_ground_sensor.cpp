#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

CVector2 CCI_FootBotMotorGroundSensor::GetOffset(UInt32 index) {
  // cm, as published with ARGoS 3
  constexpr Real kOffsets[kNumSensors][2] = {
      {6.3, 1.16}, {-6.3, 1.16}, {-6.3, -1.16}, {6.3, -1.16}};
  return CVector2(kOffsets[index][0], kOffsets[index][1]);
}

CCI_FootBotMotorGroundSensor::CCI_FootBotMotorGroundSensor() {
  m_tReadings = MakeReadings<SReading>(kNumSensors, GetOffset);
}

void CCI_FootBotMotorGroundSensor::CreateLuaState(lua_State* state) {
  CLuaTable ground(state, *this, "motor_ground");
  WriteOffsetReadings(ground, m_tReadings);
}

void CCI_FootBotMotorGroundSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable ground(state, *this);
  WriteOffsetReadings(ground, m_tReadings);
}

}  // namespace argos
