#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_GRIPPER_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_CONTROL_INTERFACE_CI_FOOTBOT_GRIPPER_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

/**
 * The gripper of the foot-bot: a claw that opens inside the ring of another foot-bot, or closes
 * around an object. Its aperture is an angle; far enough to either side, the gripper is locked.
 */
class CCI_FootBotGripperActuator : virtual public CCI_Actuator {
 public:
  static CRadians UNLOCKED; /**< 0 */
  static CRadians LOCKED_POSITIVE; /**< pi/2 */
  static CRadians LOCKED_NEGATIVE; /**< -pi/2 */

  /** Starts unlocked. */
  CCI_FootBotGripperActuator();

  /** @param aperture  clamped to [-pi/2, pi/2]; beyond pi/4 to either side the gripper is locked.
   */
  void SetAperture(const CRadians& aperture);
  /** Real robots then open the gripper if it has closed without an object. */
  virtual void EnableCheckForObjectGrippedRoutine() = 0;
  virtual void DisableCheckForObjectGrippedRoutine() = 0;
  void LockPositive();
  void LockNegative();
  void Unlock();

  /** robot.gripper.lock_positive(), lock_negative(), unlock() */
  void CreateLuaState(lua_State* state) override;

 protected:
  CRadians m_cAperture;
};

}  // namespace argos

#endif
