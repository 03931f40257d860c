#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

CCI_DifferentialSteeringActuator::CCI_DifferentialSteeringActuator()
    : m_fCurrentVelocity{0.0, 0.0} {}

void CCI_DifferentialSteeringActuator::CreateLuaState(lua_State* state) {
  CLuaTable wheels(state, *this, "wheels");
  wheels.AddMethod<&CCI_DifferentialSteeringActuator::SetLinearVelocity>("set_velocity", *this);
}

}  // namespace argos
