#include <argos3/plugins/robots/generic/simulator/gripper_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>

namespace argos {

void CGripperDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_gripper = &robot.GetComponent<CGripperEquippedEntity>("gripper");
}

void CGripperDefaultActuator::Update() {
  m_gripper->SetLockState(m_fLockState);
}

void CGripperDefaultActuator::Reset() {
  Unlock();
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

  None.
)",
    "Usable")

}  // namespace argos
