#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_GRIPPING_GRIPPER_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/generic/control_interface/ci_gripper_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CGripperEquippedEntity;

/** Locks and unlocks the gripper of a robot; see its long description. */
class CGripperDefaultActuator : public CSimulatedActuator, public CCI_GripperActuator {
 public:
  /** @throws CARGoSException unless the robot has a "gripper" and a "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Unlocks it. */
  void Reset() override;

 private:
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  Real m_ordered = 0.0;  // what the controller set last
  Real m_lockState = 0.0;  // with noise
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
