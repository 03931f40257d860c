#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_LIGHT_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_LIGHT_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_light.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

namespace argos {

/** The eye-bot's light sensors; see CAngularLight for the model. */
class CEyeBotLightRotZOnlySensor
    : public CPlacedReadingsSensor<CCI_EyeBotLightSensor, CAngularLight> {
 public:
  /** @throws CARGoSException unless the robot has 24 light sensors. */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
};

}  // namespace argos

#endif
