#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

namespace {

// as published with ARGoS 3
constexpr UInt32 kNumReadings = 24;
constexpr Real kStartAngle = 7.5;  // degrees

}  // namespace

CCI_EyeBotLightSensor::CCI_EyeBotLightSensor() {
  m_tReadings = MakeRing<SReading>(kNumReadings, kStartAngle);
}

void CCI_EyeBotLightSensor::CreateLuaState(lua_State* state) {
  CLuaTable light(state, *this, "light");
  WriteAngularReadings(light, m_tReadings);
}

void CCI_EyeBotLightSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable light(state, *this);
  WriteAngularReadings(light, m_tReadings);
}

}  // namespace argos
