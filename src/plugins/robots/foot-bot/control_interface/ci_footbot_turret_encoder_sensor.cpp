#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

const CRange<CRadians> CCI_FootBotTurretEncoderSensor::ANGULAR_RANGE(-CRadians::PI, CRadians::PI);

void CCI_FootBotTurretEncoderSensor::WriteReadings(CLuaTable& table) const {
  table.Set("rotation", m_cRotation);
}

std::vector<CCI_Sensor::SColumn> CCI_FootBotTurretEncoderSensor::GetReadingColumns() const {
  return {{"rotation", "rad"}};
}

void CCI_FootBotTurretEncoderSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_cRotation.GetValue()}, numbers, count);
}

}  // namespace argos
