#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_ClockSensor::WriteReadings(CLuaTable& table) const {
  table.Set("tick", static_cast<Real>(m_sReading.Tick));
  table.Set("time", m_sReading.Time);
}

}  // namespace argos
