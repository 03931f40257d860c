#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_POSITIONING_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_STATUS_POSITIONING_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_positioning_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>

namespace argos {

class CEmbodiedEntity;

/** The pose of a robot, with optional noise. */
class CPositioningDefaultSensor : public CNoisySensor<CCI_PositioningSensor> {
 public:
  void Update() override;

 private:
  void FindParts(CComposableEntity& robot) override;
  /** Also reads `pos_noise_range` (m), `angle_noise_range` (rad) and `axis_noise_range`. */
  void Configure(TConfigurationNode& tree) override;
  void ResetReading() override;
  void AddNoiseToOrientation();

  const CEmbodiedEntity* m_body = nullptr;
};

}  // namespace argos

#endif
