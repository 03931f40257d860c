#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GROUND_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GROUND_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>

#include <vector>

namespace argos {

/** The ground sensors of any robot. */
class CCI_GroundSensor : public CCI_Sensor {
 public:
  /** One reading in [0,1] for each sensor of the robot: 0 is black, 1 is white. */
  const std::vector<Real>& GetReadings() const;

  /** robot.ground[i], numbers. */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  std::vector<Real> m_tReadings;
};

}  // namespace argos

#endif
