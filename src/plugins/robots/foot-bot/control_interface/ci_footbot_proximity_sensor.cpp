#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>

#include <argos3/plugins/robots/generic/control_interface/placed_readings.h>

namespace argos {

namespace {

// as published with ARGoS 3
constexpr UInt32 kNumReadings = 24;
constexpr Real kStartAngle = 7.5;  // degrees

}  // namespace

CCI_FootBotProximitySensor::CCI_FootBotProximitySensor() {
  m_tReadings = MakeRing<SReading>(kNumReadings, kStartAngle);
}

void CCI_FootBotProximitySensor::CreateLuaState(lua_State* state) {
  CLuaTable proximity(state, *this, "proximity");
  WriteAngularReadings(proximity, m_tReadings);
}

void CCI_FootBotProximitySensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable proximity(state, *this);
  WriteAngularReadings(proximity, m_tReadings);
}

}  // namespace argos
