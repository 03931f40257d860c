#include <argos3/plugins/robots/pi-puck/control_interface/ci_pipuck_differential_drive_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PiPuckDifferentialDriveActuator::CreateLuaState(lua_State* state) {
  CLuaTable drive(state, *this, "differential_drive");
  drive.AddMethod<&CCI_PiPuckDifferentialDriveActuator::SetLinearVelocity>("set_linear_velocity",
                                                                           *this);
}

}  // namespace argos
