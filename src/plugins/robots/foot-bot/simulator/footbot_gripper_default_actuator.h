#ifndef ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_GRIPPER_DEFAULT_ACTUATOR_H
#define ARGOS3_PLUGINS_ROBOTS_FOOT_BOT_SIMULATOR_FOOTBOT_GRIPPER_DEFAULT_ACTUATOR_H

#include <argos3/core/simulator/actuator.h>
#include <argos3/plugins/robots/foot-bot/control_interface/ci_footbot_gripper_actuator.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>

namespace argos {

class CControllableEntity;
class CGripperEquippedEntity;

/** Rotates the claw of a foot-bot's gripper; see the manual in the source. */
class CFootBotGripperDefaultActuator : public CSimulatedActuator,
                                       public CCI_FootBotGripperActuator {
 public:
  /** @throws CARGoSException if the robot has no "gripper" or "controller". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>`. */
  void Init(TConfigurationNode& tree) override;
  void Update() override;
  /** Unlocks the gripper. */
  void Reset() override;
  /** No effect: a simulated gripper never closes on nothing. */
  void EnableCheckForObjectGrippedRoutine() override {}
  void DisableCheckForObjectGrippedRoutine() override {}

 private:
  CGripperEquippedEntity* m_gripper = nullptr;  // of the robot
  const CControllableEntity* m_robot = nullptr;
  CRadians m_ordered;  // last value set by the controller
  CRadians m_aperture;  // with noise
  CDeviceNoise m_noise;
};

}  // namespace argos

#endif
