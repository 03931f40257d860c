#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_system_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PiPuckSystemSensor::WriteReadings(CLuaTable& table) const {
  table.Set("time", m_fTime);
  table.Set("temperature", m_fTemperature);
}

std::vector<CCI_Sensor::SColumn> CCI_PiPuckSystemSensor::GetReadingColumns() const {
  return {{"time", "s"}, {"temperature", ""}};
}

void CCI_PiPuckSystemSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_fTime, m_fTemperature}, numbers, count);
}

}  // namespace argos
