#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GRIPPER_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GRIPPER_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** A gripper: when locked, it grips a body within reach; when unlocked, it releases it. */
class CCI_GripperActuator : public CCI_Actuator {
 public:
  /** Starts unlocked. */
  CCI_GripperActuator() = default;

  /** @param state  0 is open, 1 is closed; clamped to [0,1]. Above 0.5 the gripper is locked. */
  void SetLockState(Real state);
  void Lock();
  void Unlock();

  /** robot.gripper.lock(), unlock() */
  void CreateLuaState(lua_State* state) override;

 protected:
  Real m_fLockState = 0.0;
};

}  // namespace argos

#endif
