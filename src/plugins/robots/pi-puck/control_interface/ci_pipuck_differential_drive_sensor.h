#ifndef ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_DIFFERENTIAL_DRIVE_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_PI_PUCK_CONTROL_INTERFACE_CI_PIPUCK_DIFFERENTIAL_DRIVE_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>
#include <vector>

namespace argos {

/** The speeds with which the wheels of the Pi-Puck roll. */
class CCI_PiPuckDifferentialDriveSensor : public CCI_Sensor {
 public:
  /** Over the ground, m/s, positive ahead. */
  virtual Real GetLeftVelocity() = 0;
  virtual Real GetRightVelocity() = 0;

  std::vector<SColumn> GetReadingColumns() const override;
  void CopyReadings(Real* numbers, std::size_t count) const override;

  /** robot.differential_drive.encoders = { left, right }, m/s */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
