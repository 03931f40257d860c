#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_DIFFERENTIAL_DRIVE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_DIFFERENTIAL_DRIVE_SENSOR_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/plugins/robots/generic/control_interface/table_sensor.h>

namespace argos {

/** The speeds with which the wheels of the Pi-Puck roll. */
class CCI_PiPuckDifferentialDriveSensor : public CTableSensor {
 public:
  /** Over the ground, m/s, positive ahead. */
  virtual Real GetLeftVelocity() = 0;
  virtual Real GetRightVelocity() = 0;

 private:
  const char* GetLuaName() const override { return "differential_drive"; }
  void ListNumbers(CNumberList& list) const override;
  /** robot.differential_drive.encoders = { left, right }, m/s */
  void WriteReadings(CLuaTable& table) const override;
};

}  // namespace argos

#endif
