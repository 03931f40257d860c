#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PositioningSensor::WriteReadings(CLuaTable& table) const {
  table.Set("position", m_sReading.Position);
  table.Set("orientation", m_sReading.Orientation);
}

void CCI_PositioningSensor::ListNumbers(CNumberList& list) const {
  const auto& [position, orientation] = m_sReading;
  list.Add("x", "m", position.GetX());
  list.Add("y", "m", position.GetY());
  list.Add("z", "m", position.GetZ());
  list.Add("qw", "", orientation.GetW());
  list.Add("qx", "", orientation.GetX());
  list.Add("qy", "", orientation.GetY());
  list.Add("qz", "", orientation.GetZ());
}

}  // namespace argos
