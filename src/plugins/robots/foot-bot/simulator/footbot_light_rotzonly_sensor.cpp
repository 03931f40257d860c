#include <argos3/plugins/robots/foot-bot/simulator/footbot_light_rotzonly_sensor.h>

namespace argos {

void CFootBotLightRotZOnlySensor::SetRobot(CComposableEntity& robot) {
  m_reader.SetRobot(robot, m_tReadings.size(), "footbot_light");
}

void CFootBotLightRotZOnlySensor::Update() {
  m_reader.Read(m_tReadings);
}

REGISTER_SENSOR(
    CFootBotLightRotZOnlySensor, "footbot_light", "rot_z_only", "the authors of this project",
    "1.0", "The light sensors of the foot-bot.",
    R"(A ring of 24 sensors, counter-clockwise from 7.5 degrees in steps of 15. A light of intensity I > 0 is seen
along the straight line from the centre of the robot's base, unless a body other than the robot's own lies on it. With
D = length of that line / I, and delta the angle in [0,pi] between the light's azimuth and the sensor's, it adds

  g(D) max(0, 1 - 2 delta / pi),  where g(D) = exp(-2 D) for D <= 2.5, otherwise 0

to the reading. The contributions of all lights add up, and the sum is clamped to [0,1]. A light exactly above the robot
has no azimuth: every sensor then gets the mean over all of them, g(D) / 4.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <footbot_light implementation="rot_z_only" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

  <footbot_light implementation="rot_z_only" show_rays="true" noise_level="0.1" />

  show_rays    "true" or "false", default "false": visualizations that can show a ray from the
               robot to each light that is near enough.
  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to each
               reading in each tick, and the sum is clamped to [0,1].

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise to every reading, before it is clamped.
)",
    "Usable")

}  // namespace argos
