#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_QUADROTOR_POSITION_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_QUADROTOR_POSITION_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * Controls the position and the yaw of a flying robot.
 *
 * Targets hold until they are replaced; at the start and after a reset they are the current pose.
 * All setters throw CARGoSException if a number is not finite or beyond 1e9.
 */
class CCI_QuadRotorPositionActuator : public CCI_Actuator {
 public:
  /** @param position  world frame, m. */
  virtual void SetAbsolutePosition(const CVector3& position) = 0;
  /** @param position  in the robot's frame at the time of the call, m. */
  virtual void SetRelativePosition(const CVector3& position) = 0;
  /** @param yaw  world frame, counter-clockwise from x; the robot rotates in the shorter direction.
   */
  virtual void SetAbsoluteYaw(const CRadians& yaw) = 0;
  /** @param yaw  relative to the yaw at the time of the call. */
  virtual void SetRelativeYaw(const CRadians& yaw) = 0;

  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
