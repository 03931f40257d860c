#include <argos3/plugins/robots/prototype/control_interface/ci_joints_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

CCI_JointsActuator::SInterface::SInterface(const std::string& id, EMode mode)
    : Id(id), Mode(mode), Target(0.0) {}

CCI_JointsActuator::SInterface::TVector& CCI_JointsActuator::GetInterfaces() {
  return m_vecInterfaces;
}

void CCI_JointsActuator::CreateLuaState(lua_State* state) {
  CLuaTable joints(state, *this, "joints");
  for (SInterface& interface : m_vecInterfaces) {
    CLuaTable joint = joints.GetTable(interface.Id.c_str());
    joint.AddFunction("set_target", interface,
                      [](SInterface& self, Real target) { self.Target = target; });
  }
}

}  // namespace argos
