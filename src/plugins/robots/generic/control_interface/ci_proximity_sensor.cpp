#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

const std::vector<Real>& CCI_ProximitySensor::GetReadings() const {
  return m_tReadings;
}

void CCI_ProximitySensor::CreateLuaState(lua_State* state) {
  CLuaTable proximity(state, *this, "proximity");
  proximity.SetNumbers(m_tReadings);
}

void CCI_ProximitySensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable proximity(state, *this);
  proximity.SetNumbers(m_tReadings);
}

}  // namespace argos
