#include "ci_compass_sensor.h"

#include <argos3/core/wrappers/lua/lua_table.h>

using namespace argos;

void CCI_CompassSensor::CreateLuaState(lua_State* state) {
  CLuaTable compass(state, *this, "compass");
  compass.Set("north", m_north);
}

void CCI_CompassSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable compass(state, *this);
  compass.Set("north", m_north);
}

void CCI_CompassSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_north.GetValue()}, numbers, count);
}
