#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIFFERENTIAL_STEERING_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_DIFFERENTIAL_STEERING_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** Two wheels on one axis, driven independently. */
class CCI_DifferentialSteeringActuator : public CCI_Actuator {
 public:
  CCI_DifferentialSteeringActuator();

  /**
   * Sets the speeds of the wheels, until the next call.
   * @param left, right  ground speeds of the wheels, cm/s, positive ahead.
   * @throws CARGoSException if one is not finite.
   */
  virtual void SetLinearVelocity(Real left, Real right) = 0;

  /** robot.wheels.set_velocity(left, right) */
  void CreateLuaState(lua_State* state) override;

 protected:
  Real m_fCurrentVelocity[2];  // m/s: left, right
};

}  // namespace argos

#endif
