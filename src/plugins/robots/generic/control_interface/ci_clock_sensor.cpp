#include <argos3/plugins/robots/generic/control_interface/ci_clock_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& table, const CCI_ClockSensor::SReading& reading) {
  table.Set("tick", static_cast<Real>(reading.Tick));
  table.Set("time", reading.Time);
}

}  // namespace

const CCI_ClockSensor::SReading& CCI_ClockSensor::GetReading() const {
  return m_sReading;
}

void CCI_ClockSensor::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "clock");
  Write(table, m_sReading);
}

void CCI_ClockSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  Write(table, m_sReading);
}

}  // namespace argos
