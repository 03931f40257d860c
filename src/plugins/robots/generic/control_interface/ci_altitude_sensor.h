#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_ALTITUDE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_ALTITUDE_SENSOR_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

namespace argos {

/** Height of a robot above the ground or the body below it. */
class CCI_AltitudeSensor : public CTableSensor {
 public:
  /** m, >= 0 above the ground. */
  Real GetReading() const { return m_fReading; }

 protected:
  Real m_fReading = 0.0;

 private:
  const char* GetLuaName() const override { return "altitude"; }
  /** robot.altitude.height (m) */
  void ListNumbers(CNumberList& list) const override;
};

}  // namespace argos

#endif
