#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_ENCODER_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_ENCODER_DEFAULT_SENSOR_H

#include <argos3/core/simulator/sensor.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CTurretEntity;

/** Reads the rotation of a foot-bot's turret, in every mode. */
class CFootBotTurretEncoderDefaultSensor : public CSimulatedSensor,
                                           public CCI_FootBotTurretEncoderSensor {
 public:
  /** @throws CARGoSException if the robot has no "turret" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  void Reset() override;

 private:
  const CTurretEntity* m_turret = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
