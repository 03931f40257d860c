#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

// as published with ARGoS 3
constexpr int kNumReadings = 24;
constexpr Real kStartAngle = 7.5;  // degrees
constexpr Real kAngleStep = 360.0 / kNumReadings;  // degrees

void Write(CLuaTable& proximity, const CCI_EyeBotProximitySensor::TReadings& readings) {
  proximity.SetRecords(readings,
                       [](CLuaTable& record, const CCI_EyeBotProximitySensor::SReading& reading) {
                         record.Set("value", reading.Value);
                         if (record.IsNew()) {
                           record.Set("angle", reading.Angle);
                         }
                       });
}

}  // namespace

CCI_EyeBotProximitySensor::CCI_EyeBotProximitySensor() {
  m_tReadings.reserve(kNumReadings);
  for (int i = 0; i < kNumReadings; ++i) {
    m_tReadings.emplace_back(0.0,
                             ToRadians(CDegrees(kStartAngle + kAngleStep * i)).SignedNormalize());
  }
}

const CCI_EyeBotProximitySensor::TReadings& CCI_EyeBotProximitySensor::GetReadings() const {
  return m_tReadings;
}

void CCI_EyeBotProximitySensor::CreateLuaState(lua_State* state) {
  CLuaTable proximity(state, *this, "proximity");
  Write(proximity, m_tReadings);
}

void CCI_EyeBotProximitySensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable proximity(state, *this);
  Write(proximity, m_tReadings);
}

}  // namespace argos
