#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GROUND_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GROUND_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/plain_readings.h>

namespace argos {

/** The ground sensors of any robot. Readings are in [0,1]: 0 is black, 1 is white. In Lua:
 * robot.ground[i]. */
class CCI_GroundSensor : public CPlainReadings {
 private:
  const char* GetLuaName() const override { return "ground"; }
};

}  // namespace argos

#endif
