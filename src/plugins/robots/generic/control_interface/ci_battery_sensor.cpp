#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_BatterySensor::WriteReadings(CLuaTable& table) const {
  table.Set("available_charge", m_sReading.AvailableCharge);
  table.Set("time_left", m_sReading.TimeLeft);
}

std::vector<CCI_Sensor::SColumn> CCI_BatterySensor::GetReadingColumns() const {
  return {{"available_charge", ""}, {"time_left", "s"}};
}

void CCI_BatterySensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_sReading.AvailableCharge, m_sReading.TimeLeft}, numbers, count);
}

}  // namespace argos
