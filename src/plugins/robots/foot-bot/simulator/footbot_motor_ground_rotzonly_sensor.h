#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_MOTOR_GROUND_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_MOTOR_GROUND_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>
#include <argos3/plugins/robots/generic/simulator/offset_ground_sensor.h>

namespace argos {

/** The ground sensors between the wheels of the foot-bot. */
class CFootBotMotorGroundRotZOnlySensor
    : public COffsetGroundSensor<CCI_FootBotMotorGroundSensor, footbot::kFirstMotorGroundSensor,
                                 footbot::kNumGroundSensors> {};

}  // namespace argos

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/space.h>
#endif

#endif
