#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& table, const CCI_PositioningSensor::SReading& reading) {
  table.Set("position", reading.Position);
  table.Set("orientation", reading.Orientation);
}

}  // namespace

const CCI_PositioningSensor::SReading& CCI_PositioningSensor::GetReading() const {
  return m_sReading;
}

void CCI_PositioningSensor::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, "positioning");
  Write(table, m_sReading);
}

void CCI_PositioningSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  Write(table, m_sReading);
}

}  // namespace argos
