#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_FootBotEncoderSensor::WriteConstants(CLuaTable& table) {
  table.Set("axis_length", m_sReading.WheelAxisLength);
}

void CCI_FootBotEncoderSensor::ListNumbers(CNumberList& list) const {
  list.Add("distance_left", "cm", m_sReading.CoveredDistanceLeftWheel);
  list.Add("distance_right", "cm", m_sReading.CoveredDistanceRightWheel);
}

}  // namespace argos
