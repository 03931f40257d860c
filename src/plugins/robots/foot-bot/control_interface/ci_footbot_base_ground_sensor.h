#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_BASE_GROUND_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_BASE_GROUND_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/offset_readings.h>

namespace argos {

/**
 * The eight ground sensors around the base of the foot-bot, which tell black from white.
 *
 * GetReadings() has a reading for each, in the order of GetOffset(): 0 is black, 1 is white.
 */
class CCI_FootBotBaseGroundSensor : virtual public CCI_Sensor,
                                    public COffsetReadings<CCI_FootBotBaseGroundSensor> {
 public:
  static constexpr UInt32 kNumSensors = 8;

  CCI_FootBotBaseGroundSensor();

  /** Where a sensor is, cm: x ahead, y left. @param index < kNumSensors. */
  static CVector2 GetOffset(UInt32 index);

  /** robot.base_ground[i] = { offset, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
