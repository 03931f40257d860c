#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_ENCODER_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_ENCODER_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_encoder_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class COdometerEntity;

/** How far the wheels of a foot-bot rolled; see COdometerEntity. */
class CFootBotEncoderDefaultSensor : public CSimulatedSensor, public CCI_FootBotEncoderSensor {
 public:
  /** @throws CARGoSException if the robot has no "odometer", "wheels" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  const COdometerEntity* m_odometer = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
