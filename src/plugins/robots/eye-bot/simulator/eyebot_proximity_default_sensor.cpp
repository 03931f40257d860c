#include <argos3/plugins/robots/eye-bot/simulator/eyebot_proximity_default_sensor.h>

#include <argos3/plugins/robots/generic/simulator/swarmanoid_proximity.h>

namespace argos {

void CEyeBotProximityDefaultSensor::SetRobot(CComposableEntity& robot) {
  TakeRays(robot, "eyebot_proximity");
}

Real CEyeBotProximityDefaultSensor::CalculateReading(Real distance) {
  return ComputeSwarmanoidProximity(distance);
}

REGISTER_SENSOR(
    CEyeBotProximityDefaultSensor, "eyebot_proximity", "default", "the authors of this project",
    "1.0", "The proximity sensors of the eye-bot.",
    R"(A ring of 24 sensors at a height of 16 cm above the base, counter-clockwise from 7.5 degrees in steps of
15, each with a horizontal ray of 3 m that starts 5 mm outside the body. If the ray meets a body other than the robot's
own at the distance D (m) from its start, the sensor reads 1 for D < 0.009889556, otherwise
0.0100527 / (D + 0.000163144): 0.0034 at the end of its range. A ray that meets nothing reads 0.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <eyebot_proximity implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <eyebot_proximity implementation="default" show_rays="true" noise_level="0.001" />

  show_rays    "true" or "false", default "false": rays are shown by visualizations that can.
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to each
               reading in each tick, and the sum is clamped to [0,1].

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to every reading, before it is clamped.
)",
    "Usable")

}  // namespace argos
