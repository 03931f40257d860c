#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_DIFFERENTIAL_DRIVE_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_DIFFERENTIAL_DRIVE_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** The two wheels of the Pi-Puck. */
class CCI_PiPuckDifferentialDriveActuator : public CCI_Actuator {
 public:
  /**
   * Sets the speeds of the wheels over the ground, from the next tick on.
   * @param left, right  m/s, positive ahead.
   */
  virtual void SetLinearVelocity(Real left, Real right) = 0;

  /** robot.differential_drive.set_linear_velocity(left, right), m/s */
  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
