#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& encoder, const CCI_FootBotEncoderSensor::SReading& reading) {
  encoder.Set("distance_left", reading.CoveredDistanceLeftWheel);
  encoder.Set("distance_right", reading.CoveredDistanceRightWheel);
}

}  // namespace

const CCI_FootBotEncoderSensor::SReading& CCI_FootBotEncoderSensor::GetReading() const {
  return m_sReading;
}

void CCI_FootBotEncoderSensor::CreateLuaState(lua_State* state) {
  CLuaTable encoder(state, *this, "encoder");
  Write(encoder, m_sReading);
  encoder.Set("axis_length", m_sReading.WheelAxisLength);
}

void CCI_FootBotEncoderSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable encoder(state, *this);
  Write(encoder, m_sReading);
}

}  // namespace argos
