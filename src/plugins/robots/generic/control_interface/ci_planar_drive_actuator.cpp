#include <argos3/plugins/robots/generic/control_interface/ci_planar_drive_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PlanarDriveActuator::CreateLuaState(lua_State* state) {
  CLuaTable drive(state, *this, "planar_drive");
  drive.AddMethod<&CCI_PlanarDriveActuator::SetVelocity>("set_velocity", *this);
}

}  // namespace argos
