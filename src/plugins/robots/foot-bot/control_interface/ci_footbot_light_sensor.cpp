#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

namespace {

// as published with ARGoS 3
constexpr UInt32 kNumReadings = 24;
constexpr Real kStartAngle = 7.5;  // degrees

}  // namespace

CCI_FootBotLightSensor::CCI_FootBotLightSensor() {
  m_tReadings = MakeRing<SReading>(kNumReadings, kStartAngle);
}

void CCI_FootBotLightSensor::CreateLuaState(lua_State* state) {
  CLuaTable light(state, *this, "light");
  WriteAngularReadings(light, m_tReadings);
}

void CCI_FootBotLightSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable light(state, *this);
  WriteAngularReadings(light, m_tReadings);
}

}  // namespace argos
