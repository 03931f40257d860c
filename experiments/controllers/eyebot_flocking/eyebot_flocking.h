#ifndef EYEBOT_FLOCKING_H
#define EYEBOT_FLOCKING_H

#include "../common/flying.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

#include <memory>

/**
 * Eye-bots that take off, keep a distance from each other, and fly to a light, as a flock.
 *
 * Robots attract or repel each other like atoms: with the horizontal distance d and the target
 * distance t, the force is gain / d ((t/d)^4 - (t/d)^2), repulsive for d < t and attractive for d >
 * t. The light adds a vector of fixed length towards it. A robot moves towards the mean height of
 * the robots whose messages it receives.
 *
 * Source: W. M. Spears et al., "Distributed, physics-based control of swarms of vehicles",
 * Autonomous Robots 17 (2004), for forces like those between molecules.
 */
class CEyeBotFlocking : public argos::CCI_Controller {
 public:
  /**
   * Reads the optional attributes height (m), max_speed (m/s), target_distance (m), gain (m^2/s),
   * and light_speed (m/s), all > 0.
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  argos::CVector3 VectorToLight() const;
  argos::CVector3 FlockingVector() const;

  argos::CCI_QuadRotorPositionActuator* m_propellers = nullptr;
  argos::CCI_RangeAndBearingSensor* m_ears = nullptr;
  argos::CCI_EyeBotLightSensor* m_light = nullptr;
  argos::CCI_LEDsActuator* m_leds = nullptr;  // null without such an actuator
  std::unique_ptr<CFlying> m_flying;

  argos::Real m_height = 1.0;  // above the start, m
  argos::Real m_targetDistance = 1.0;  // m
  argos::Real m_gain = 0.3;  // m^2/s
  argos::Real m_lightSpeed = 0.1;  // m/s
  argos::UInt32 m_step = 0;  // since the start
};

#endif
