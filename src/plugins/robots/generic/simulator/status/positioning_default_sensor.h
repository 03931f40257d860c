#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_POSITIONING_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_POSITIONING_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CEmbodiedEntity;

/** The pose of a robot, with optional noise. */
class CPositioningDefaultSensor : public CSimulatedSensor, public CCI_PositioningSensor {
 public:
  /** @throws CARGoSException if the robot has no "body" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `pos_noise_range` (m), `angle_noise_range` (rad), `axis_noise_range`, and `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  void AddNoiseToOrientation();

  const CEmbodiedEntity* m_body = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
