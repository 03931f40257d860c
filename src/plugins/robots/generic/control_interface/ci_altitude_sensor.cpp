#include <argos3/plugins/robots/generic/control_interface/ci_altitude_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& table, Real reading) {
  table.Set("height", reading);
}

}  // namespace

Real CCI_AltitudeSensor::GetReading() const {
  return m_fReading;
}

void CCI_AltitudeSensor::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "altitude");
  Write(table, m_fReading);
}

void CCI_AltitudeSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  Write(table, m_fReading);
}

}  // namespace argos
