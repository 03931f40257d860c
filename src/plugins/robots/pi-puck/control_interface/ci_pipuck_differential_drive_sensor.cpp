#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PiPuckDifferentialDriveSensor::ListNumbers(CNumberList& list) const {
  // the getters of ARGoS 3 are not const
  auto& self = const_cast<CCI_PiPuckDifferentialDriveSensor&>(*this);
  list.Add("left", "m/s", self.GetLeftVelocity());
  list.Add("right", "m/s", self.GetRightVelocity());
}

void CCI_PiPuckDifferentialDriveSensor::WriteReadings(CLuaTable& table) const {
  CLuaTable encoders = table.GetTable("encoders");
  CTableSensor::WriteReadings(encoders);
}

}  // namespace argos
