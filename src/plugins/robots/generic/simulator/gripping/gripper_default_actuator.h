#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_DEFAULT_ACTUATOR_H

#include <argos3/plugins/robots/generic/control_interface/ci_gripper_actuator.h>
#include <argos3/plugins/robots/generic/simulator/gripper_actuator.h>

namespace argos {

/** Locks and unlocks the gripper of a robot; see the manual in the source. */
class CGripperDefaultActuator : public CGripperActuator<CCI_GripperActuator, Real> {
  const char* GetQuantity() const override { return "lock_state"; }
  Real GetOrder() const override { return m_fLockState; }
  Real AddNoise(const Real& lockState) override;
  Real ComputeLockState(const Real& lockState) const override { return lockState; }
};

}  // namespace argos

#endif
