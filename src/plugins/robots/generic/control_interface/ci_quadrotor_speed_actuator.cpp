#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_speed_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_QuadRotorSpeedActuator::CreateLuaState(lua_State* state) {
  CLuaTable quadrotor(state, *this, "quadrotor");
  quadrotor.AddFunction("set_linear_velocity", *this,
                        [](CCI_QuadRotorSpeedActuator& device, Real x, Real y, Real z) {
                          device.SetLinearVelocity(CVector3(x, y, z));
                        });
  quadrotor.AddMethod<&CCI_QuadRotorSpeedActuator::SetRotationalSpeed>("set_rotational_speed",
                                                                       *this);
}

}  // namespace argos
