#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_CONTROL_INTERFACE_CI_EYEBOT_LIGHT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_CONTROL_INTERFACE_CI_EYEBOT_LIGHT_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/angular_readings.h>

namespace argos {

/**
 * The ring of 24 light sensors of the eye-bot.
 *
 * GetReadings() has 24 readings, counter-clockwise from 7.5 degrees in steps of 15: 0 is dark,
 * larger is brighter.
 */
class CCI_EyeBotLightSensor : public CCI_Sensor, public CAngularReadings<CCI_EyeBotLightSensor> {
 public:
  CCI_EyeBotLightSensor();

  /** robot.light[i] = { angle, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
