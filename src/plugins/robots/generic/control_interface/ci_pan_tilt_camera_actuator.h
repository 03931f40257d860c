#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PAN_TILT_CAMERA_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PAN_TILT_CAMERA_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

/** Rotates the perspective camera of a robot. Both angles are 0 at the start. */
class CCI_PanTiltCameraActuator : public CCI_Actuator {
 public:
  /** Sideways rotation about the z axis of the camera's mount; positive to the left. */
  virtual void SetPan(const CRadians& pan) = 0;
  /** Rotation about the camera's y axis; positive is down. */
  virtual void SetTilt(const CRadians& tilt) = 0;

  /** robot.pan_tilt_camera.set_pan(rad), set_tilt(rad) */
  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
