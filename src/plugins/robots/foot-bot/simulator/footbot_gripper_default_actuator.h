#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_GRIPPER_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_GRIPPER_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CGripperEquippedEntity;

/** Turns the claw of a foot-bot's gripper; see its long description. */
class CFootBotGripperDefaultActuator : public CSimulatedActuator,
                                       public CCI_FootBotGripperActuator {
 public:
  /** @throws CARGoSException unless the robot has a "gripper" and a "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Unlocks it. */
  void Reset() override;
  /** Nothing: a simulated gripper grips when there is something, however often it is locked. */
  void EnableCheckForObjectGrippedRoutine() override {}
  void DisableCheckForObjectGrippedRoutine() override {}

 private:
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  CRadians m_ordered;  // what the controller set last
  CRadians m_aperture;  // with noise
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
