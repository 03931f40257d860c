#include <argos3/plugins/robots/generic/control_interface/plain_readings.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CPlainReadings::WriteReadings(CLuaTable& table) const {
  table.SetNumbers(m_tReadings);
}

}  // namespace argos
