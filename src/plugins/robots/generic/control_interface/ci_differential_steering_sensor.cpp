#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_DifferentialSteeringSensor::WriteConstants(CLuaTable& table) {
  table.Set("axis_length", m_sReading.WheelAxisLength);
}

void CCI_DifferentialSteeringSensor::ListNumbers(CNumberList& list) const {
  list.Add("velocity_left", "cm/s", m_sReading.VelocityLeftWheel);
  list.Add("velocity_right", "cm/s", m_sReading.VelocityRightWheel);
  list.Add("distance_left", "cm", m_sReading.CoveredDistanceLeftWheel);
  list.Add("distance_right", "cm", m_sReading.CoveredDistanceRightWheel);
}

}  // namespace argos
