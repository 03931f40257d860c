#include <argos3/plugins/robots/generic/simulator/gripper_default_actuator.h>

#include <argos3/plugins/robots/generic/simulator/device_manual.h>

#include <algorithm>

namespace argos {

Real CGripperDefaultActuator::AddNoise(const Real& lockState) {
  return GetNoise().IsOn() ? std::clamp(GetNoise().Apply(0, lockState), 0.0, 1.0) : lockState;
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
        OptionalNoiseXML("gripper", R"(on="lock_state" model="gaussian" std_dev="0.1")") +
        NoiseManual(
            "lock_state",
            "the lock state each time the controller changes it. The sum is clamped to [0,1];\nthe "
            "gripper is locked above 0.5."),
    "Usable")

}  // namespace argos
