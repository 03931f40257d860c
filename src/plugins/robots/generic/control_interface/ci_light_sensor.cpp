#include <argos3/plugins/robots/generic/control_interface/ci_light_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

const std::vector<Real>& CCI_LightSensor::GetReadings() const {
  return m_tReadings;
}

void CCI_LightSensor::CreateLuaState(lua_State* state) {
  CLuaTable light(state, *this, "light");
  light.SetNumbers(m_tReadings);
}

void CCI_LightSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable light(state, *this);
  light.SetNumbers(m_tReadings);
}

}  // namespace argos
