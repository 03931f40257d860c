#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_PROXIMITY_SENSOR_H

#include <argos3/plugins/robots/generic/control_interface/plain_readings.h>

namespace argos {

/** The proximity sensors of any robot. Readings are in [0,1]: 0 means that no object is in range,
 * larger is nearer. In Lua: robot.proximity[i]. */
class CCI_ProximitySensor : public CPlainReadings {
 private:
  const char* GetLuaName() const override { return "proximity"; }
};

}  // namespace argos

#endif
