#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_DifferentialSteeringSensor::WriteConstants(CLuaTable& table) {
  table.Set("axis_length", m_sReading.WheelAxisLength);
}

void CCI_DifferentialSteeringSensor::WriteReadings(CLuaTable& table) const {
  table.Set("velocity_left", m_sReading.VelocityLeftWheel);
  table.Set("velocity_right", m_sReading.VelocityRightWheel);
  table.Set("distance_left", m_sReading.CoveredDistanceLeftWheel);
  table.Set("distance_right", m_sReading.CoveredDistanceRightWheel);
}

}  // namespace argos
