#include <argos3/plugins/robots/generic/control_interface/ci_gripper_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

#include <algorithm>

namespace argos {

void CCI_GripperActuator::SetLockState(Real state) {
  m_fLockState = std::clamp(state, 0.0, 1.0);
}

void CCI_GripperActuator::Lock() {
  SetLockState(1.0);
}

void CCI_GripperActuator::Unlock() {
  SetLockState(0.0);
}

void CCI_GripperActuator::CreateLuaState(lua_State* state) {
  CLuaTable gripper(state, *this, "gripper");
  gripper.AddMethod<&CCI_GripperActuator::Lock>("lock", *this);
  gripper.AddMethod<&CCI_GripperActuator::Unlock>("unlock", *this);
}

}  // namespace argos
