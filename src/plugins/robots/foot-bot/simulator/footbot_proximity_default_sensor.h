#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/swarmanoid_proximity.h>

namespace argos {

/** The proximity sensors of the foot-bot. */
class CFootBotProximityDefaultSensor
    : public CSwarmanoidProximitySensor<CCI_FootBotProximitySensor> {};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>
#endif

#endif
