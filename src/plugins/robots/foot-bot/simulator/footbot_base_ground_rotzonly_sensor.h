#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_BASE_GROUND_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_BASE_GROUND_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_base_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>
#include <argos3/plugins/robots/generic/simulator/offset_ground_sensor.h>

namespace argos {

/** The ground sensors around the base of the foot-bot. */
class CFootBotBaseGroundRotZOnlySensor
    : public COffsetGroundSensor<CCI_FootBotBaseGroundSensor, footbot::kFirstBaseGroundSensor,
                                 footbot::kNumGroundSensors> {};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space.h>
#endif

#endif
