#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_ENCODER_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_TURRET_ENCODER_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_turret_encoder_sensor.h>
#include <argos3/plugins/robots/generic/simulator/noisy_sensor.h>

namespace argos {

class CTurretEntity;

/** Reads the rotation of a foot-bot's turret, in every mode. */
class CFootBotTurretEncoderDefaultSensor : public CNoisySensor<CCI_FootBotTurretEncoderSensor> {
 public:
  void Update() override;

 private:
  void FindParts(CComposableEntity& robot) override;
  void Configure(TConfigurationNode& tree) override;
  void ResetReading() override;

  const CTurretEntity* m_turret = nullptr;
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>
#endif

#endif
