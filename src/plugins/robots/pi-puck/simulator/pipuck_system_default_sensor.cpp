#include <argos3/plugins/robots/pi-puck/simulator/pipuck_system_default_sensor.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

namespace argos {

void CPiPuckSystemDefaultSensor::SetRobot(CComposableEntity& robot) {
  // throws unless the robot is a Pi-Puck
  robot.GetComponent<CPiPuckDifferentialDriveEntity>("differential_drive");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  Enable();
}

void CPiPuckSystemDefaultSensor::Update() {
  m_fTime += m_robot->GetSimulator().GetTickLength();
}

void CPiPuckSystemDefaultSensor::Reset() {
  m_fTime = 0.0;
}

REGISTER_SENSOR(CPiPuckSystemDefaultSensor, "pipuck_system", "default",
                "the authors of this project", "1.0", "The clock of the Pi-Puck.",
                R"(Reads the time since the start, in s, for scripts. The temperature is always 0.
)" + RequiredSensorXML(R"(<pipuck_system implementation="default" />)"),
                "Usable")

}  // namespace argos
