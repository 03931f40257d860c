#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_QUADROTOR_SPEED_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_QUADROTOR_SPEED_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/vector3.h>

namespace argos {

/**
 * Controls the velocity and the rotational speed of a flying robot.
 *
 * Targets hold until they are replaced; at the start and after a reset they are zero. Both setters
 * throw CARGoSException if a number is not finite or beyond 1e9.
 */
class CCI_QuadRotorSpeedActuator : public CCI_Actuator {
 public:
  /** @param velocity  in the world frame, m/s. */
  virtual void SetLinearVelocity(const CVector3& velocity) = 0;
  /** @param speed  about the vertical, counter-clockwise, rad/s. */
  virtual void SetRotationalSpeed(const CRadians& speed) = 0;

  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
