#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PLANAR_DRIVE_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PLANAR_DRIVE_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

/** A drive that can move a robot to all sides, such as omnidirectional wheels. */
class CCI_PlanarDriveActuator : public CCI_Actuator {
 public:
  /**
   * Sets the velocity of the robot, in its own frame, until the next call.
   * @param ahead    cm/s, negative backwards.
   * @param left     cm/s, negative to the right.
   * @param yawRate  rad/s, counter-clockwise.
   * @throws CARGoSException if a number is not finite.
   */
  virtual void SetVelocity(Real ahead, Real left, const CRadians& yawRate) = 0;

  /** robot.planar_drive.set_velocity(ahead, left, yaw_rate) */
  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
