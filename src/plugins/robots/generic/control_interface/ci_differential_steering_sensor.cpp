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

std::vector<CCI_Sensor::SColumn> CCI_DifferentialSteeringSensor::GetReadingColumns() const {
  return {{"velocity_left", "cm/s"},
          {"velocity_right", "cm/s"},
          {"distance_left", "cm"},
          {"distance_right", "cm"}};
}

void CCI_DifferentialSteeringSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_sReading.VelocityLeftWheel, m_sReading.VelocityRightWheel,
               m_sReading.CoveredDistanceLeftWheel, m_sReading.CoveredDistanceRightWheel},
              numbers, count);
}

}  // namespace argos
