#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

#include <algorithm>

namespace argos {

void CCI_SimpleRadiosSensor::WriteReadings(CLuaTable& table) const {
  for (const SInterface& interface : m_vecInterfaces) {
    CLuaTable radio = table.GetTable(interface.Id.c_str());
    CLuaTable received = radio.GetTable("recv");
    lua_State* const state = received.GetState();
    lua_Integer count = 0;
    for (CByteArray message : interface.Messages) {
      if (CLuaUtility::LuaDeserializeTable(message, state)) {
        // the list is now below the message
        lua_rawseti(state, -2, ++count);
      }
    }
    received.Truncate(static_cast<std::size_t>(count));
  }
}

std::vector<CCI_Sensor::SColumn> CCI_SimpleRadiosSensor::GetReadingColumns() const {
  std::vector<SColumn> columns;
  for (const SInterface& interface : m_vecInterfaces) {
    columns.push_back({interface.Id + "_count", ""});
  }
  return columns;
}

void CCI_SimpleRadiosSensor::CopyReadings(Real* numbers, std::size_t count) const {
  for (std::size_t i = 0; i < std::min(count, m_vecInterfaces.size()); ++i) {
    numbers[i] = static_cast<Real>(m_vecInterfaces[i].Messages.size());
  }
}

}  // namespace argos
