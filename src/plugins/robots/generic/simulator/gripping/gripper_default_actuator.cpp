#include <argos3/plugins/robots/generic/simulator/gripper_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
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
    R"(A locked gripper that holds nothing takes hold of the first body that can be gripped (movable boxes and
cylinders, foot-bots) and comes into reach, 1 cm around the gripper's point: at once, in the next tick's physics. It holds
one body at a time; a body may be held by many. Unlocked, it lets go at once. The gripper is unlocked at the start and
after a reset. How it holds, and how far what it holds gives way, is the physics engine's: see gripping_rigidity of
dynamics2d. A body that is moved by a command, or taken away, is let go.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <gripper implementation="default" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <gripper implementation="default">
    <noise on="lock_state" model="gaussian" std_dev="0.1" />
  </gripper>

Children <noise on="lock_state" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to the lock state whenever the controller sets another one; it stays in [0,1], and locks above 0.5.
)",
    "Usable")

}  // namespace argos
