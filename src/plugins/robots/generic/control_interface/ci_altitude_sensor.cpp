#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_AltitudeSensor::WriteReadings(CLuaTable& table) const {
  table.Set("height", m_fReading);
}

}  // namespace argos
