#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_distance_scanner_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_FootBotDistanceScannerActuator::CreateLuaState(lua_State* state) {
  CLuaTable scanner(state, *this, "distance_scanner");
  scanner.AddMethod<&CCI_FootBotDistanceScannerActuator::Enable>("enable", *this);
  scanner.AddMethod<&CCI_FootBotDistanceScannerActuator::Disable>("disable", *this);
  scanner.AddMethod<&CCI_FootBotDistanceScannerActuator::SetAngle>("set_angle", *this);
  scanner.AddMethod<&CCI_FootBotDistanceScannerActuator::SetRPM>("set_rpm", *this);
}

}  // namespace argos
