#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_CONTROL_INTERFACE_CI_EPUCK_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_CONTROL_INTERFACE_CI_EPUCK_PROXIMITY_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/plugins/robots/generic/control_interface/angular_readings.h>

namespace argos {

/**
 * The eight proximity sensors of the e-puck.
 *
 * GetReadings() has eight readings, at about 17, 50, 90, 150, -150, -90, -50 and -17 degrees: 0
 * sees nothing, larger is nearer.
 */
class CCI_EPuckProximitySensor : public CCI_Sensor,
                                 public CAngularReadings<CCI_EPuckProximitySensor> {
 public:
  static constexpr UInt32 kNumSensors = 8;
  /** Where sensor @p index (0 to 7) points; as published with ARGoS 3. */
  static CRadians GetAngle(UInt32 index);

  CCI_EPuckProximitySensor();

  /** robot.proximity[i] = { angle, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
