#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_TURRET_ENCODER_SENSOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_TURRET_ENCODER_SENSOR_H

#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/range.h>

namespace argos {

/** Where the turret of the foot-bot points. */
class CCI_FootBotTurretEncoderSensor : virtual public CCI_Sensor {
 public:
  static const CRange<CRadians> ANGULAR_RANGE; /**< [-pi, pi] */

  /** Of the turret on the base, in (-pi, pi], counter-clockwise from straight ahead. */
  const CRadians& GetRotation() const { return m_cRotation; }

  /** robot.turret.rotation, rad */
  void CreateLuaState(lua_State* state) override;
  void ReadingsToLuaState(lua_State* state) override;

 protected:
  CRadians m_cRotation;
};

}  // namespace argos

#endif
