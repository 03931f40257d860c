#include <argos3/plugins/robots/e-puck/simulator/epuck_proximity_default_sensor.h>

#include <algorithm>

namespace argos {

namespace {

// response curve as published with ARGoS 3: kA D^2 + kB D + kC up to kReach
constexpr Real kReach = 0.05;  // m
constexpr Real kA = 298.701;  // 1/m^2
constexpr Real kB = -36.8961;  // 1/m
constexpr Real kC = 1.08212;

}  // namespace

void CEPuckProximityDefaultSensor::SetRobot(CComposableEntity& robot) {
  TakeRays(robot, "epuck_proximity");
}

Real CEPuckProximityDefaultSensor::CalculateReading(Real distance) {
  if (distance > kReach) {
    return 0.0;
  }
  return std::clamp((kA * distance + kB) * distance + kC, 0.0, 1.0);
}

REGISTER_SENSOR(
    CEPuckProximityDefaultSensor, "epuck_proximity", "default", "the authors of this project",
    "1.0", "The proximity sensors of the e-puck.",
    R"(Eight sensors at a height of 6 cm, at about 17, 50, 90, 150, -150, -90, -50 and -17 degrees, each with a
ray of 10 cm from the surface of the body. If the ray meets a body other than the robot's own at the distance D (m)
from its start, the sensor reads 298.701 D^2 - 36.8961 D + 1.08212, clamped to [0,1], for D <= 0.05; otherwise 0. A ray
that meets nothing reads 0.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <epuck_proximity implementation="default" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <epuck_proximity implementation="default" show_rays="true" noise_level="0.1" />

  show_rays    "true" or "false", default "false": rays are shown by visualizations that can.
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to each
               reading in each tick, and the sum is clamped to [0,1].

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to every reading, before it is clamped.
)",
    "Usable")

}  // namespace argos
