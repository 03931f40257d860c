#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_SYSTEM_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_SYSTEM_SENSOR_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

namespace argos {

/** The clock and the thermometer of the Pi-Puck; for Lua, as in ARGoS 3. */
class CCI_PiPuckSystemSensor : public CTableSensor {
 protected:
  Real m_fTime = 0.0;  // time since the start, s
  Real m_fTemperature = 0.0;  // always 0

 private:
  const char* GetLuaName() const override { return "system"; }
  /** robot.system = { time, temperature } */
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
