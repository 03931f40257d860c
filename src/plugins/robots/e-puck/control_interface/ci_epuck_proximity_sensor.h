#ifndef ARGOS3_PLUGINS_ROBOTS_E_PUCK_CONTROL_INTERFACE_CI_EPUCK_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_E_PUCK_CONTROL_INTERFACE_CI_EPUCK_PROXIMITY_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

#include <vector>

namespace argos {

/** The eight proximity sensors of the e-puck. */
class CCI_EPuckProximitySensor : public CCI_Sensor {
 public:
  struct SReading {
    Real Value = 0.0; /**< in [0,1]: 0 sees nothing, larger is nearer */
    CRadians Angle; /**< where the sensor points, in (-PI,PI], counter-clockwise from ahead */

    SReading() = default;
    SReading(Real value, const CRadians& angle) : Value(value), Angle(angle) {}
  };

  /** Eight readings, at about 17, 50, 90, 150, -150, -90, -50, -17 degrees. */
  typedef std::vector<SReading> TReadings;

  static constexpr UInt32 kNumSensors = 8;
  /** Where sensor @p index (0 to 7) points; as published with ARGoS 3. */
  static CRadians GetAngle(UInt32 index);

  CCI_EPuckProximitySensor();

  const TReadings& GetReadings() const;

  /** robot.proximity[i] = { angle, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  TReadings m_tReadings;
};

}  // namespace argos

#endif
