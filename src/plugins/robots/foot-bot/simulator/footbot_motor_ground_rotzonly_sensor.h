#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_MOTOR_GROUND_ROTZONLY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_MOTOR_GROUND_ROTZONLY_SENSOR_H

#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_motor_ground_sensor.h>
#include <argos3/plugins/robots/generic/simulator/floor_reader.h>
#include <argos3/plugins/robots/generic/simulator/placed_readings_sensor.h>

namespace argos {

/** The ground sensors between the wheels of the foot-bot. */
class CFootBotMotorGroundRotZOnlySensor
    : public CPlacedReadingsSensor<CCI_FootBotMotorGroundSensor, CFloorReader> {
 public:
  /** @throws CARGoSException unless the robot has the 12 ground sensors of the foot-bot. */
  void SetRobot(CComposableEntity& robot) override;
  void Update() override;
};

}  // namespace argos

#endif
