#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_PROXIMITY_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/angular_readings.h>

namespace argos {

/**
 * The ring of 24 proximity sensors of the foot-bot.
 *
 * GetReadings() has 24 readings, counter-clockwise from 7.5 degrees in steps of 15: 0 sees
 * nothing, larger is nearer.
 */
class CCI_FootBotProximitySensor : public CCI_Sensor,
                                   public CAngularReadings<CCI_FootBotProximitySensor> {
 public:
  CCI_FootBotProximitySensor();

  /** robot.proximity[i] = { angle, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
