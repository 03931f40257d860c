#include <argos3/plugins/robots/foot-bot/simulator/footbot_base_ground_rotzonly_sensor.h>

#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>

namespace argos {

void CFootBotBaseGroundRotZOnlySensor::SetRobot(CComposableEntity& robot) {
  m_reader.SetRobot(robot);
  m_reader.RequireNumSensors(footbot::kNumGroundSensors, "footbot_base_ground");
}

void CFootBotBaseGroundRotZOnlySensor::Update() {
  m_reader.Read(m_tReadings, footbot::kFirstBaseGroundSensor);
}

REGISTER_SENSOR(
    CFootBotBaseGroundRotZOnlySensor, "footbot_base_ground", "rot_z_only",
    "the authors of this project", "1.0", "The ground sensors around the base of the foot-bot.",
    R"(The eight sensors around the base of the foot-bot, at (8, 0), (4.2, 6.5), (0, 8), (-4.2, 6.5), (-8, 0), (-4.2, -6.5),
(0, -8) and (4.2, -6.5) cm from its centre (x ahead, y left). Each reads 0 if the grey level of the floor straight below
it, (0.299 red + 0.587 green + 0.114 blue) / 255, is less than 0.5, otherwise 1.
Bodies do not hide the floor.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <footbot_base_ground implementation="rot_z_only" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

with a floor:

  <arena size="10,10,2">
    <floor id="floor" source="image" path="floor.png" />
  </arena>

OPTIONAL XML

  <footbot_base_ground implementation="rot_z_only" noise_level="0.1" />

  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to what
               each sensor sees in each tick, before it is compared with 0.5.

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise in the same place.
)",
    "Usable")

}  // namespace argos
