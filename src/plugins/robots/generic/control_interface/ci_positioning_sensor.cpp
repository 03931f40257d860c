#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PositioningSensor::WriteReadings(CLuaTable& table) const {
  table.Set("position", m_sReading.Position);
  table.Set("orientation", m_sReading.Orientation);
}

std::vector<CCI_Sensor::SColumn> CCI_PositioningSensor::GetReadingColumns() const {
  return {{"x", "m"}, {"y", "m"}, {"z", "m"}, {"qw", ""}, {"qx", ""}, {"qy", ""}, {"qz", ""}};
}

void CCI_PositioningSensor::CopyReadings(Real* numbers, std::size_t count) const {
  CopyNumbers({m_sReading.Position.GetX(), m_sReading.Position.GetY(), m_sReading.Position.GetZ(),
               m_sReading.Orientation.GetW(), m_sReading.Orientation.GetX(),
               m_sReading.Orientation.GetY(), m_sReading.Orientation.GetZ()},
              numbers, count);
}

}  // namespace argos
