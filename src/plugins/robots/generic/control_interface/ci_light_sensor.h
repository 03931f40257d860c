#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_LIGHT_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_LIGHT_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/plain_readings.h>

namespace argos {

/** The light sensors of any robot. Readings are in [0,1]: 0 is dark, larger is brighter. In Lua:
 * robot.light[i]. */
class CCI_LightSensor : public CPlainReadings {
 private:
  const char* GetLuaName() const override { return "light"; }
};

}  // namespace argos

#endif
