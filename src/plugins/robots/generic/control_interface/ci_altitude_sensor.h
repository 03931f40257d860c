#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_ALTITUDE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_ALTITUDE_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** Tells a robot how high it is above what lies below. */
class CCI_AltitudeSensor : public CCI_Sensor {
 public:
  /** m, >= 0 above the ground. */
  Real GetReading() const;

  /** robot.altitude.height (m) */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  Real m_fReading = 0.0;
};

}  // namespace argos

#endif
