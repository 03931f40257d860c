#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_MOTOR_GROUND_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_MOTOR_GROUND_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/offset_readings.h>

namespace argos {

/**
 * The four ground sensors between the wheels of the foot-bot, which see shades of grey.
 *
 * GetReadings() has a reading for each, in the order of GetOffset(): 0 is black, 1 is white.
 */
class CCI_FootBotMotorGroundSensor : public CCI_Sensor,
                                     public COffsetReadings<CCI_FootBotMotorGroundSensor> {
 public:
  static constexpr UInt32 kNumSensors = 4;

  CCI_FootBotMotorGroundSensor();

  /** Where a sensor is, cm: x ahead, y left. @param index < kNumSensors. */
  static CVector2 GetOffset(UInt32 index);

  /** robot.motor_ground[i] = { offset, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
