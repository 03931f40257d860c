#ifndef USER_PROJECT_OBSTACLE_AVOIDANCE_H
#define USER_PROJECT_OBSTACLE_AVOIDANCE_H

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/utility/math/vector2.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_actuator.h>

/**
 * Drives a foot-bot straight on, and turns it away from obstacles, the faster the closer they are.
 *
 * Needs the devices differential_steering and footbot_proximity. Parameters, all optional:
 *   <params speed="10" caution="3" />
 * speed is the wheels' speed without obstacles, in cm/s; caution, dimensionless, is the gain of the
 * slow-down near obstacles: at 1 the closest obstacle straight ahead just stops the robot.
 */
class CObstacleAvoidance : public argos::CCI_Controller {
 public:
  void Init(argos::TConfigurationNode& node) override;
  void ControlStep() override;

 private:
  argos::CVector2 SumOfReadings() const;

  argos::CCI_DifferentialSteeringActuator* m_wheels = nullptr;
  argos::CCI_FootBotProximitySensor* m_proximity = nullptr;
  argos::Real m_speed = 10.0;
  argos::Real m_caution = 3.0;
};

#endif
