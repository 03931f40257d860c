#include <argos3/plugins/robots/generic/simulator/ground_rotzonly_sensor.h>

namespace argos {

void CGroundRotZOnlySensor::SetRobot(CComposableEntity& robot) {
  m_floor.SetRobot(robot);
}

void CGroundRotZOnlySensor::Init(TConfigurationNode& tree) {
  CCI_GroundSensor::Init(tree);
  m_floor.Init(tree);
  m_tReadings.assign(m_floor.GetNumSensors(), 0.0);
  Enable();
}

void CGroundRotZOnlySensor::Update() {
  CFloorReader::CView view = m_floor.Look();
  m_tReadings.resize(m_floor.GetNumSensors());
  for (size_t i = 0; i < m_tReadings.size(); ++i) {
    m_tReadings[i] = view.Read(i);
  }
}

void CGroundRotZOnlySensor::Reset() {
  m_tReadings.assign(m_floor.GetNumSensors(), 0.0);
  m_floor.Reset();
}

REGISTER_SENSOR(
    CGroundRotZOnlySensor, "ground", "rot_z_only", "the authors of this project", "1.0",
    "The ground sensors of any robot.",
    R"(Every ground sensor of the robot sees the colour of the floor straight below it, as the grey level
(0.299 red + 0.587 green + 0.114 blue) / 255: 0 is black, 1 is white. Sensors that know only black and white read 0 below
0.5, otherwise 1. Bodies do not hide the floor. The foot-bot has 12: the 4 of footbot_motor_ground (grey), then the 8 of
footbot_base_ground (black or white). The e-puck has 3 in front (grey): right, middle, left.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators />
      <sensors>
        <ground implementation="rot_z_only" />
      </sensors>
      <params />
    </my_controller>
  </controllers>

with a floor:

  <arena size="10,10,2">
    <floor id="floor" source="image" path="floor.png" />
  </arena>

OPTIONAL XML

  <ground implementation="rot_z_only" noise_level="0.1" />

  noise_level  real number n >= 0, default 0: a number drawn evenly from [-n,n] is added to what
               each sensor sees in each tick, before it is clamped to [0,1] or compared with 0.5.

Children <noise on="reading" model="uniform|gaussian|rayleigh" level|std_dev|sigma="..." bias="0" relative="false" />
add noise in the same place.
)",
    "Usable")

}  // namespace argos
