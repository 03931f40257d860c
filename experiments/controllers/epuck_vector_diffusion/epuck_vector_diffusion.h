#ifndef EPUCK_VECTOR_DIFFUSION_H
#define EPUCK_VECTOR_DIFFUSION_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/e-puck/control_interface/ci_epuck_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

/**
 * Diffusion as in the thesis of C. Pinciroli (appendix C), for e-pucks.
 *
 * The proximity readings are added up as vectors. The robot drives straight on while the mean is
 * short and ahead; otherwise it turns away about one wheel, which stops. It has no memory and draws
 * nothing at random. Robots in a crowd touch and press, because one wheel always turns.
 */
class CEPuckVectorDiffusion : public argos::CCI_Controller {
 public:
  /**
   * Reads the optional attributes velocity (cm/s), delta (greatest length of the mean of the
   * readings with which the robot drives straight on, 0 to 1) and alpha (its greatest angle from
   * straight ahead, degrees).
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;

 private:
  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_EPuckProximitySensor* m_proximity = nullptr;
  argos::Real m_velocity = 6.4;  // cm/s
  argos::Real m_delta = 0.05;
  argos::CDegrees m_alpha = argos::CDegrees(7.5);
};

#endif
