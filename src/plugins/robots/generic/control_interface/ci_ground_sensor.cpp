#include <argos3/plugins/robots/generic/control_interface/ci_ground_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

const std::vector<Real>& CCI_GroundSensor::GetReadings() const {
  return m_tReadings;
}

void CCI_GroundSensor::CreateLuaState(lua_State* state) {
  CLuaTable ground(state, *this, "ground");
  ground.SetNumbers(m_tReadings);
}

void CCI_GroundSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable ground(state, *this);
  ground.SetNumbers(m_tReadings);
}

}  // namespace argos
