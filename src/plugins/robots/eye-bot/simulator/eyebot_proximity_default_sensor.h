#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_PROXIMITY_DEFAULT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_SIMULATOR_EYEBOT_PROXIMITY_DEFAULT_SENSOR_H

#include <argos3/plugins/robots/eye-bot/control_interface/ci_eyebot_proximity_sensor.h>
#include <argos3/plugins/robots/generic/simulator/swarmanoid_proximity.h>

namespace argos {

/** The proximity sensors of the eye-bot. */
class CEyeBotProximityDefaultSensor : public CSwarmanoidProximitySensor<CCI_EyeBotProximitySensor> {
};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/plugins/robots/generic/simulator/proximity_default_sensor.h>
#endif

#endif
