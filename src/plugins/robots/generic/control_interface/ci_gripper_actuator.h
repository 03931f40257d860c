#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GRIPPER_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_CONTROL_INTERFACE_CI_GRIPPER_ACTUATOR_H

#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** A gripper: locked, it takes hold of what comes into it; unlocked, it lets go. */
class CCI_GripperActuator : public CCI_Actuator {
 public:
  /** Starts unlocked. */
  CCI_GripperActuator() = default;

  /** @param state  0 is open, 1 is closed; cut to [0,1]. Above 0.5 it is locked. */
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
