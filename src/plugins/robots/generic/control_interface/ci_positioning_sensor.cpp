#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PositioningSensor::WriteReadings(CLuaTable& table) const {
  table.Set("position", m_sReading.Position);
  table.Set("orientation", m_sReading.Orientation);
}

}  // namespace argos
