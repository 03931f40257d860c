#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_LIGHT_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_LIGHT_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_light.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

namespace argos {

/** The foot-bot's light sensors; see CAngularLight for the model. */
class CFootBotLightRotZOnlySensor
    : public CPlacedReadingsSensor<CCI_FootBotLightSensor, CAngularLight> {
 public:
  /** @throws CARGoSException unless the robot has 24 light sensors. */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
};

}  // namespace argos

#endif
