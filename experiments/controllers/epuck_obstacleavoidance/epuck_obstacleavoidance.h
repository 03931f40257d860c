#ifndef EPUCK_OBSTACLEAVOIDANCE_H
#define EPUCK_OBSTACLEAVOIDANCE_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_proximity_sensor.h>

/**
 * Drives an e-puck straight on and turns it away from obstacles ahead.
 *
 * The generic proximity sensor of an e-puck has eight rays, counter-clockwise from 17 degrees on: 0
 * to 2 from ahead to the left side, 5 to 7 from the right side to ahead, 3 and 4 to the rear. The
 * weight of a reading decreases with the angle to the heading.
 */
class CEPuckObstacleAvoidance : public argos::CCI_Controller {
 public:
  /** Reads the optional attribute velocity (cm/s). */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_ProximitySensor* m_proximity = nullptr;
  argos::Real m_velocity = 5.0;  // cm/s
  argos::Real m_turnDirection = 0.0;  // 1 left, -1 right, 0 not turning
};

#endif
