#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void Write(CLuaTable& wheels, const CCI_DifferentialSteeringSensor::SReading& reading) {
  wheels.Set("velocity_left", reading.VelocityLeftWheel);
  wheels.Set("velocity_right", reading.VelocityRightWheel);
  wheels.Set("distance_left", reading.CoveredDistanceLeftWheel);
  wheels.Set("distance_right", reading.CoveredDistanceRightWheel);
}

}  // namespace

const CCI_DifferentialSteeringSensor::SReading& CCI_DifferentialSteeringSensor::GetReading() const {
  return m_sReading;
}

void CCI_DifferentialSteeringSensor::CreateLuaState(lua_State* state) {
  CLuaTable wheels(state, *this, "wheels");
  Write(wheels, m_sReading);
  wheels.Set("axis_length", m_sReading.WheelAxisLength);
}

void CCI_DifferentialSteeringSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable wheels(state, *this);
  Write(wheels, m_sReading);
}

}  // namespace argos
