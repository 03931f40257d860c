#include <argos3/plugins/robots/generic/control_interface/ci_pan_tilt_camera_actuator.h>

#include <argos3/core/wrappers/lua/lua_table.h>

namespace argos {

void CCI_PanTiltCameraActuator::CreateLuaState(lua_State* state) {
  CLuaTable camera(state, *this, "pan_tilt_camera");
  camera.AddMethod<&CCI_PanTiltCameraActuator::SetPan>("set_pan", *this);
  camera.AddMethod<&CCI_PanTiltCameraActuator::SetTilt>("set_tilt", *this);
}

}  // namespace argos
