#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_TURRET_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_TURRET_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/range.h>

namespace argos {

/** The motor that rotates the turret of the foot-bot, with its gripper and LEDs. */
class CCI_FootBotTurretActuator : virtual public CCI_Actuator {
 public:
  enum ETurretModes {
    MODE_OFF, /**< at the start: the turret keeps its rotation on the base */
    MODE_PASSIVE, /**< the same; in both it rotates freely while the gripper holds a body */
    MODE_SPEED_CONTROL, /**< rotates at the target speed */
    MODE_POSITION_CONTROL /**< rotates towards the target rotation */
  };

  /** Range of real motors, turns per minute; not enforced. */
  static const CRange<SInt32> SPEED_RANGE;
  static const CRange<Real> NORMALIZED_SPEED_RANGE; /**< [-1,1] */

  /** @param angle  of the turret on the base, for MODE_POSITION_CONTROL. */
  virtual void SetRotation(const CRadians& angle) = 0;
  /** @param pulses  turns per minute, counter-clockwise, for MODE_SPEED_CONTROL. */
  virtual void SetRotationSpeed(SInt32 pulses) = 0;
  virtual void SetMode(ETurretModes mode) = 0;

  /** SetMode(MODE_POSITION_CONTROL) and SetRotation(). */
  void SetActiveWithRotation(const CRadians& angle);
  void SetSpeedControlMode();
  void SetPositionControlMode();
  void SetPassiveMode();

  /**
   * robot.turret.set_rotation(rad), set_rotation_speed(turns per minute, truncated to a whole
   * number), set_passive_mode(), set_position_control_mode(), set_speed_control_mode()
   */
  void CreateLuaState(lua_State* state) override;
};

}  // namespace argos

#endif
