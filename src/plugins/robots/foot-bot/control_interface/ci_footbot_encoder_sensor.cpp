#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_FootBotEncoderSensor::WriteConstants(CLuaTable& table) {
  table.Set("axis_length", m_sReading.WheelAxisLength);
}

void CCI_FootBotEncoderSensor::WriteReadings(CLuaTable& table) const {
  table.Set("distance_left", m_sReading.CoveredDistanceLeftWheel);
  table.Set("distance_right", m_sReading.CoveredDistanceRightWheel);
}

std::vector<CCI_Sensor::SColumn> CCI_FootBotEncoderSensor::GetReadingColumns() const {
  return {{"distance_left", "cm"}, {"distance_right", "cm"}};
}

void CCI_FootBotEncoderSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_sReading.CoveredDistanceLeftWheel, m_sReading.CoveredDistanceRightWheel}, numbers,
              count);
}

}  // namespace argos
