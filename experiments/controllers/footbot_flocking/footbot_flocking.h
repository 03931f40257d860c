#ifndef FOOTBOT_FLOCKING_H
#define FOOTBOT_FLOCKING_H

#include "../common/steering.h"

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_colored_blob_omnidirectional_camera_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_leds_actuator.h>

#include <memory>

/**
 * Foot-bots that keep a distance from each other, and drive to a light, as a flock.
 *
 * Every robot shows a red beacon. Visible beacons attract or repel the robot like atoms: with the
 * distance d and the target distance t, the force is gain / d ((t/d)^4 - (t/d)^2), repulsive for d
 * < t and attractive for d > t. The light adds a vector of fixed length towards it.
 *
 * Source: W. M. Spears et al., "Distributed, physics-based control of swarms of vehicles",
 * Autonomous Robots 17 (2004), for forces like those between molecules.
 */
class CFootBotFlocking : public argos::CCI_Controller {
 public:
  /**
   * Reads the optional attributes max_speed (cm/s), target_distance (cm), gain (cm^2/s), and
   * light_speed (cm/s), all > 0.
   */
  void Init(argos::TConfigurationNode& params) override;
  void ControlStep() override;
  void Reset() override;

 private:
  argos::CVector2 VectorToLight() const;
  argos::CVector2 FlockingVector() const;

  argos::CCI_LEDsActuator* m_leds = nullptr;
  argos::CCI_FootBotLightSensor* m_light = nullptr;
  argos::CCI_ColoredBlobOmnidirectionalCameraSensor* m_camera = nullptr;
  std::unique_ptr<CSteering> m_steering;

  argos::Real m_targetDistance = 75.0;  // cm
  argos::Real m_gain = 1000.0;  // cm^2/s
  argos::Real m_lightSpeed = 5.0;  // cm/s
};

#endif
