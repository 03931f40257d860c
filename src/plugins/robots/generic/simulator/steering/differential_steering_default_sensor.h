#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STEERING_DIFFERENTIAL_STEERING_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_differential_steering_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CWheeledEntity;

/** Wheel encoders: the rotation of the wheels, not the motion of a robot that slips or pushes. */
class CDifferentialSteeringDefaultSensor : public CSimulatedSensor,
                                           public CCI_DifferentialSteeringSensor {
 public:
  /** @throws CARGoSException if the robot does not have two "wheels". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `vel_noise_range` (cm/s), `dist_noise_range` (cm), and `<noise>` children. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  const CWheeledEntity* m_wheels = nullptr;  // of the robot
  CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
