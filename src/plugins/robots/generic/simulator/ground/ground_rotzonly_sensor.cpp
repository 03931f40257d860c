#include <argos3/plugins/robots/generic/simulator/ground_rotzonly_sensor.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/plugins/robots/generic/simulator/offset_ground_sensor.h>

#include <typeinfo>

namespace argos {

CGroundRotZOnlySensor::CGroundRotZOnlySensor()
    : m_pcGroundSensorEntity(m_reader.AccessSensors()), m_cSpace(CurrentSpace()) {
  m_reader.SetSpace(m_cSpace);
}

void CGroundRotZOnlySensor::SetRobot(CComposableEntity& robot) {
  CPlainReadingsSensor::SetRobot(robot);
  if (robot.HasComponent("body")) {
    m_pcEmbodiedEntity = &robot.GetComponent<CEmbodiedEntity>("body");
  }
  if (m_cSpace.HasFloorEntity()) {
    m_pcFloorEntity = &m_cSpace.GetFloorEntity();
  }
}

void CGroundRotZOnlySensor::Init(TConfigurationNode& tree) {
  if (typeid(*this) != typeid(CGroundRotZOnlySensor)) {
    m_reader.LeaveNoiseLevel();
    InitNoise(tree);
  }
  CPlainReadingsSensor::Init(tree);
}

void CGroundRotZOnlySensor::Update() {
  CFloorReader::CView view = m_reader.ViewFloor();
  m_pcFloorEntity = &view.GetFloor();
  m_tReadings.resize(m_reader.GetNumSensors());
  for (size_t i = 0; i < m_tReadings.size(); ++i) {
    m_tReadings[i] = m_bAddNoise ? view.Read(i, DrawNoise()) : view.Read(i);
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
