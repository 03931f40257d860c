#ifndef ARGOS3_PLUGINS_ROBOTS_EYE_BOT_CONTROL_INTERFACE_CI_EYEBOT_PROXIMITY_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_EYE_BOT_CONTROL_INTERFACE_CI_EYEBOT_PROXIMITY_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

#include <vector>

namespace argos {

/** The ring of 24 proximity sensors of the eye-bot. */
class CCI_EyeBotProximitySensor : public CCI_Sensor {
 public:
  struct SReading {
    Real Value = 0.0; /**< in [0,1]: 0 sees nothing, larger is nearer */
    CRadians Angle; /**< where the sensor points, in (-PI,PI], counter-clockwise from ahead */

    SReading() = default;
    SReading(Real value, const CRadians& angle) : Value(value), Angle(angle) {}
  };

  /** 24 readings, counter-clockwise from 7.5 degrees in steps of 15. */
  typedef std::vector<SReading> TReadings;

  CCI_EyeBotProximitySensor();

  const TReadings& GetReadings() const;

  /** robot.proximity[i] = { angle, value } */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  TReadings m_tReadings;
};

}  // namespace argos

#endif
