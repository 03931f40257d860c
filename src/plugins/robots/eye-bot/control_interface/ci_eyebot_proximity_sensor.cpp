#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

namespace {

// as published with ARGoS 3
constexpr UInt32 kNumReadings = 24;
constexpr Real kStartAngle = 7.5;  // degrees

}  // namespace

CCI_EyeBotProximitySensor::CCI_EyeBotProximitySensor() {
  m_tReadings = MakeRing<SReading>(kNumReadings, kStartAngle);
}

void CCI_EyeBotProximitySensor::CreateLuaState(lua_State* state) {
  CLuaTable proximity(state, *this, "proximity");
  WriteAngularReadings(proximity, m_tReadings);
}

void CCI_EyeBotProximitySensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable proximity(state, *this);
  WriteAngularReadings(proximity, m_tReadings);
}

}  // namespace argos
