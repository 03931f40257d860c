#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_LIGHT_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_LIGHT_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_light_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_light_sensor.h>

namespace argos {

/** The light sensors of the eye-bot. */
class CEyeBotLightRotZOnlySensor : public CAngularLightSensor<CCI_EyeBotLightSensor> {};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space.h>
#endif

#endif
