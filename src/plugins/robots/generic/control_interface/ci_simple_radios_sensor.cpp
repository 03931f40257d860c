#include <argos3/plugins/robots/generic/control_interface/ci_simple_radios_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>
#include <argos3/core/wrappers/lua/lua_utility.h>

namespace argos {

namespace {

void Write(CLuaTable& radios, const CCI_SimpleRadiosSensor::SInterface::TVector& interfaces) {
  for (const CCI_SimpleRadiosSensor::SInterface& interface : interfaces) {
    CLuaTable radio = radios.GetTable(interface.Id.c_str());
    CLuaTable received = radio.GetTable("recv");
    lua_State* const state = received.GetState();
    lua_Integer count = 0;
    for (CByteArray message : interface.Messages) {
      if (CLuaUtility::LuaDeserializeTable(state, message)) {
        // the list is now below the message
        lua_rawseti(state, -2, ++count);
      }
    }
    received.Truncate(static_cast<std::size_t>(count));
  }
}

}  // namespace

void CCI_SimpleRadiosSensor::CreateLuaState(lua_State* state) {
  CLuaTable radios(state, *this, "simple_radios");
  Write(radios, m_vecInterfaces);
}

void CCI_SimpleRadiosSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable radios(state, *this);
  Write(radios, m_vecInterfaces);
}

}  // namespace argos
