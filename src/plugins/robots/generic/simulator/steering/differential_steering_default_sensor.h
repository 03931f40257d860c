#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>

namespace argos {

class CWheeledEntity;

/**
 * Wheel encoders: the rotation of the wheels as ordered, not the motion of a robot that slips,
 * pushes or drifts.
 */
class CDifferentialSteeringDefaultSensor : public CNoisySensor<CCI_DifferentialSteeringSensor> {
 public:
  void Update() override;

 private:
  /** @throws CARGoSException if the robot does not have two "wheels". */
  void FindParts(CComposableEntity& robot) override;
  /** Also reads `vel_noise_range` (cm/s) and `dist_noise_range` (cm). */
  void Configure(TConfigurationNode& tree) override;
  void ResetReading() override;

  const CWheeledEntity* m_wheels = nullptr;
};

}  // namespace argos

#endif
