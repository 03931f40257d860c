#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_AltitudeSensor::WriteReadings(CLuaTable& table) const {
  table.Set("height", m_fReading);
}

std::vector<CCI_Sensor::SColumn> CCI_AltitudeSensor::GetReadingColumns() const {
  return {{"height", "m"}};
}

void CCI_AltitudeSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_fReading}, numbers, count);
}

}  // namespace argos
