#include <argos3/plugins/robots/foot-bot/simulator/footbot_proximity_default_sensor.h>

#include <argos3/plugins/robots/generic/simulator/swarmanoid_proximity.h>

namespace argos {

void CFootBotProximityDefaultSensor::SetRobot(CComposableEntity& robot) {
  TakeRays(robot, "footbot_proximity");
}

Real CFootBotProximityDefaultSensor::CalculateReading(Real distance) {
  return ComputeSwarmanoidProximity(distance);
}

REGISTER_SENSOR(
    CFootBotProximityDefaultSensor, "footbot_proximity", "default", "the authors of this project",
    "1.0", "The proximity sensors of the foot-bot.",
    R"(A ring of 24 sensors at a height of 6 cm, counter-clockwise from 7.5 degrees in steps of 15, each with
a ray of 10 cm from the surface of the body. If the ray meets a body other than the robot's own at the distance D (m)
from its start, the sensor reads 1 for D < 0.009889556, otherwise 0.0100527 / (D + 0.000163144): 0.1 at the end of its
range. A ray that meets nothing reads 0.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <footbot_proximity implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <footbot_proximity implementation="default" show_rays="true" noise_level="0.1" />

  show_rays    "true" or "false", default "false": rays are shown by visualizations that can.
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to each
               reading in each tick, and the sum is clamped to [0,1].

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to every reading, before it is clamped.
)",
    "Usable")

}  // namespace argos
