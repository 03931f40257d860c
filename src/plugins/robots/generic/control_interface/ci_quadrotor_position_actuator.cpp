#include <argos3/plugins/robots/generic/control_interface/ci_quadrotor_position_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_QuadRotorPositionActuator::CreateLuaState(lua_State* state) {
  using TDevice = CCI_QuadRotorPositionActuator;
  CLuaTable quadrotor(state, *this, "quadrotor");
  quadrotor.AddFunction("set_absolute_position", *this,
                        [](TDevice& device, Real x, Real y, Real z) {
                          device.SetAbsolutePosition(CVector3(x, y, z));
                        });
  quadrotor.AddFunction("set_relative_position", *this,
                        [](TDevice& device, Real x, Real y, Real z) {
                          device.SetRelativePosition(CVector3(x, y, z));
                        });
  // takes degrees, like ARGoS 3; Lua's other angles are in radians
  quadrotor.AddFunction("set_absolute_yaw", *this, [](TDevice& device, Real degrees) {
    device.SetAbsoluteYaw(ToRadians(CDegrees(degrees)));
  });
  quadrotor.AddFunction("set_relative_yaw", *this, [](TDevice& device, Real degrees) {
    device.SetRelativeYaw(ToRadians(CDegrees(degrees)));
  });
}

}  // namespace argos
