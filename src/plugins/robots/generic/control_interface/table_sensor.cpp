#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

template <class BASE>
void CTableSensorOn<BASE>::CreateLuaState(lua_State* state) {
  CLuaTable table(state, *this, GetLuaName());
  WriteConstants(table);
  WriteReadings(table);
}

template <class BASE>
void CTableSensorOn<BASE>::ReadingsToLuaState(lua_State* state) {
  CLuaTable table(state, *this);
  WriteReadings(table);
}

template class CTableSensorOn<CCI_Sensor>;
template class CTableSensorOn<CVirtualSensor>;

}  // namespace argos
