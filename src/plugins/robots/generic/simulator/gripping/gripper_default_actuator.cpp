#include <argos3/plugins/robots/generic/simulator/gripper_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>

#include <algorithm>

namespace argos {

void CGripperDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_gripper = &robot.GetComponent<CGripperEquippedEntity>("gripper");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
}

void CGripperDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_GripperActuator::Init(tree);
  m_noise.Init(tree, *m_robot, {"lock_state"});
}

void CGripperDefaultActuator::Update() {
  if (m_fLockState != m_ordered) {
    m_ordered = m_fLockState;
    m_lockState = m_noise.IsOn() ? std::clamp(m_noise.Apply(0, m_ordered), 0.0, 1.0) : m_ordered;
  }
  m_gripper->SetLockState(m_lockState);
}

void CGripperDefaultActuator::Reset() {
  Unlock();
  m_ordered = m_fLockState;
  m_lockState = m_fLockState;
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CGripperDefaultActuator, "gripper", "default", "the authors of this project", "1.0",
    "Locks and unlocks the gripper of a robot.",
    R"(A locked gripper that holds nothing grips the first grippable body (movable boxes and cylinders, foot-bots)
that is within reach, 1 cm around the gripper's point, in the physics step of the next tick. A gripper holds one body at
a time; several grippers may hold the same body. An unlocked gripper releases its body at once. The gripper is unlocked
at the start and after a reset. The stiffness of a grip depends on the physics engine: see the manual of the engine. A
body that is moved by a command, or removed, is released.
)" + RequiredActuatorXML(R"(<gripper implementation="default" />)") +
        OptionalXML(R"(<gripper implementation="default">
    <noise on="lock_state" model="gaussian" std_dev="0.1" />
  </gripper>)") +
        NoiseManual(
            "lock_state",
            "the lock state each time the controller changes it. The sum is clamped to [0,1];\nthe "
            "gripper is locked above 0.5."),
    "Usable")

}  // namespace argos
