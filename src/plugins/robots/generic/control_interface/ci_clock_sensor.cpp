#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_ClockSensor::WriteReadings(CLuaTable& table) const {
  table.Set("tick", static_cast<Real>(m_sReading.Tick));
  table.Set("time", m_sReading.Time);
}

std::vector<CCI_Sensor::SColumn> CCI_ClockSensor::GetReadingColumns() const {
  return {{"tick", "ticks"}, {"time", "s"}};
}

void CCI_ClockSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({static_cast<Real>(m_sReading.Tick), m_sReading.Time}, numbers, count);
}

}  // namespace argos
