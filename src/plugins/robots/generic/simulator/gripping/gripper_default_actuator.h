#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_gripper_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CGripperEquippedEntity;

/** Locks and unlocks the gripper of a robot; see the manual in the source. */
class CGripperDefaultActuator : public CSimulatedActuator, public CCI_GripperActuator {
 public:
  /** @throws CARGoSException if the robot has no "gripper" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Unlocks the gripper. */
  void Reset() override;

 private:
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  Real m_ordered = 0.0;  // last value set by the controller
  Real m_lockState = 0.0;  // with noise
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
