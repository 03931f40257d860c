#include <argos3/plugins/robots/generic/simulator/ground_rotzonly_sensor.h>

#include <argos3/plugins/robots/generic/simulator/offset_ground_sensor.h>

namespace argos {

void CGroundRotZOnlySensor::Update() {
  CFloorReader::CView view = m_reader.ViewFloor();
  m_tReadings.resize(m_reader.GetNumSensors());
  for (size_t i = 0; i < m_tReadings.size(); ++i) {
    m_tReadings[i] = view.Read(i);
  }
}

REGISTER_SENSOR(
    CGroundRotZOnlySensor, "ground", "rot_z_only", "the authors of this project", "1.0",
    "The ground sensors of any robot.",
    R"(Every ground sensor of the robot reads the colour of the floor straight below it, as the grey level
(0.299 red + 0.587 green + 0.114 blue) / 255: 0 is black, 1 is white. Black-and-white sensors read 0 below 0.5,
otherwise 1. Bodies do not occlude the floor. The foot-bot has 12: the 4 of footbot_motor_ground (grey), then the 8 of
footbot_base_ground (black or white). The e-puck has 3 in front (grey): right, middle, left.
)" + GroundSensorManual("ground", "it is clamped to [0,1] or compared with 0.5"),
    "Usable")

}  // namespace argos
