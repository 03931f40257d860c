#include <argos3/plugins/robots/foot-bot/simulator/footbot_gripper_default_actuator.h>

#include <argos3/core/utility/math/range.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

CRadians CFootBotGripperDefaultActuator::AddNoise(const CRadians& aperture) {
  CRadians noisy(GetNoise().Apply(0, aperture.GetValue()));
  CRange<CRadians>(-CRadians::PI_OVER_TWO, CRadians::PI_OVER_TWO).TruncValue(noisy);
  return noisy;
}

REGISTER_ACTUATOR(
    CFootBotGripperDefaultActuator, "footbot_gripper", "default", "the authors of this project",
    "1.0", "The gripper of the foot-bot.",
    R"(The controller sets the aperture of the claw, an angle in [-pi/2,pi/2]; the gripper is locked while the aperture
is beyond pi/4 to either side. lock_positive and lock_negative set pi/2 and -pi/2, with the same effect, and unlock sets
0. A locked gripper grips movable boxes, movable cylinders and foot-bots within 1 cm of its point, which is on the rim of
the robot, straight ahead of the turret: see the actuator "gripper". While the gripper holds a body and the turret is off
or passive, the turret rotates freely under the load.
)" + RequiredActuatorXML(R"(<footbot_gripper implementation="default" />)") +
        OptionalNoiseXML("footbot_gripper", R"(on="aperture" model="gaussian" std_dev="0.1")") +
        NoiseManual("aperture",
                    "the aperture (rad) each time the controller changes it. The sum is clamped to "
                    "[-pi/2,pi/2]."),
    "Usable")

}  // namespace argos
