#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_LIGHT_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_LIGHT_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_light_sensor.h>
#include <argos3/plugins/robots/generic/simulator/angular_light_sensor.h>

namespace argos {

/** The light sensors of the foot-bot. */
class CFootBotLightRotZOnlySensor : public CAngularLightSensor<CCI_FootBotLightSensor> {};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space.h>
#endif

#endif
