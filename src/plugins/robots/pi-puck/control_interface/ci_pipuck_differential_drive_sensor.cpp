#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_sensor.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

namespace {

void WriteReadings(CCI_PiPuckDifferentialDriveSensor& sensor, CLuaTable& drive) {
  CLuaTable encoders = drive.GetTable("encoders");
  encoders.Set("left", sensor.GetLeftVelocity());
  encoders.Set("right", sensor.GetRightVelocity());
}

}  // namespace

void CCI_PiPuckDifferentialDriveSensor::CreateLuaState(lua_State* state) {
  CLuaTable drive(state, *this, "differential_drive");
  WriteReadings(*this, drive);
}

void CCI_PiPuckDifferentialDriveSensor::ReadingsToLuaState(lua_State* state) {
  CLuaTable drive(state, *this);
  WriteReadings(*this, drive);
}

std::vector<CCI_Sensor::SColumn> CCI_PiPuckDifferentialDriveSensor::GetReadingColumns() const {
  return {{"left", "m/s"}, {"right", "m/s"}};
}

void CCI_PiPuckDifferentialDriveSensor::CopyReadings(Real* numbers, std::size_t count) const {
  // the getters of ARGoS 3 are not const
  auto& self = const_cast<CCI_PiPuckDifferentialDriveSensor&>(*this);
  CopyNumbers({self.GetLeftVelocity(), self.GetRightVelocity()}, numbers, count);
}

}  // namespace argos
