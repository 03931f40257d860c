#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

namespace argos {

void CPiPuckDifferentialDriveDefaultSensor::SetRobot(CComposableEntity& robot) {
  m_drive = &robot.GetComponent<CPiPuckDifferentialDriveEntity>("differential_drive");
  Enable();
}

void CPiPuckDifferentialDriveDefaultSensor::Update() {
  m_left = m_drive->GetVelocityLeft();
  m_right = m_drive->GetVelocityRight();
}

void CPiPuckDifferentialDriveDefaultSensor::Reset() {
  m_left = 0.0;
  m_right = 0.0;
}

REGISTER_SENSOR(
    CPiPuckDifferentialDriveDefaultSensor, "pipuck_differential_drive", "default",
    "the authors of this project", "1.0", "The speeds of the wheels of the Pi-Puck.",
    R"(Reads the speeds of both wheels over the ground in the last tick, in m/s, positive ahead, from the motion of the body:
a robot that pushes against a wall reads 0.
)" + RequiredSensorXML(R"(<pipuck_differential_drive implementation="default" />)"),
    "Usable")

}  // namespace argos
