#include <argos3/plugins/robots/foot-bot/simulator/footbot_motor_ground_rotzonly_sensor.h>

#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>

namespace argos {

void CFootBotMotorGroundRotZOnlySensor::SetRobot(CComposableEntity& robot) {
  m_reader.SetRobot(robot);
  m_reader.RequireNumSensors(footbot::kNumGroundSensors, "footbot_motor_ground");
}

void CFootBotMotorGroundRotZOnlySensor::Update() {
  m_reader.Read(m_tReadings, footbot::kFirstMotorGroundSensor);
}

REGISTER_SENSOR(
    CFootBotMotorGroundRotZOnlySensor, "footbot_motor_ground", "rot_z_only",
    "the authors of this project", "1.0", "The ground sensors between the wheels of the foot-bot.",
    R"(The four sensors between the wheels of the foot-bot, at (6.3, 1.16), (-6.3, 1.16), (-6.3, -1.16) and (6.3, -1.16) cm
from its centre (x ahead, y left). Each reads the colour of the floor straight below it, as the grey level
(0.299 red + 0.587 green + 0.114 blue) / 255: 0 is black, 1 is white.
Bodies do not hide the floor.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <footbot_motor_ground implementation="rot_z_only" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

with a floor:

  <arena size="10,10,2">
    <floor id="floor" source="image" path="floor.png" />
  </arena>

OPTIONAL XML

  <footbot_motor_ground implementation="rot_z_only" noise_level="0.1" />

  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to what
               each sensor sees in each tick, before it is clamped to [0,1].

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise in the same place.
)",
    "Usable")

}  // namespace argos
