#include <argos3/plugins/robots/generic/control_interface/ci_battery_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& table, const CCI_BatterySensor::SReading& reading) {
  table.Set("available_charge", reading.AvailableCharge);
  table.Set("time_left", reading.TimeLeft);
}

}  // namespace

const CCI_BatterySensor::SReading& CCI_BatterySensor::GetReading() const {
  return m_sReading;
}

void CCI_BatterySensor::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "battery");
  Write(table, m_sReading);
}

void CCI_BatterySensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  Write(table, m_sReading);
}

}  // namespace argos
