#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/pi-puck/simulator/pipuck_differential_drive_entity.h>

#include <cmath>

namespace argos {

void CPiPuckDifferentialDriveDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_drive = &robot.GetComponent<CPiPuckDifferentialDriveEntity>("differential_drive");
}

void CPiPuckDifferentialDriveDefaultActuator::SetLinearVelocity(Real left, Real right) {
  if (!std::isfinite(left) || !std::isfinite(right)) {
    THROW_ARGOSEXCEPTION("pipuck_differential_drive: wheel speeds must be finite, got "
                         << left << " and " << right << " m/s");
  }
  m_left = left;
  m_right = right;
}

void CPiPuckDifferentialDriveDefaultActuator::Update() {
  m_drive->SetTargetVelocityLeft(m_left);
  m_drive->SetTargetVelocityRight(m_right);
}

void CPiPuckDifferentialDriveDefaultActuator::Reset() {
  m_left = 0.0;
  m_right = 0.0;
}

REGISTER_ACTUATOR(
    CPiPuckDifferentialDriveDefaultActuator, "pipuck_differential_drive", "default",
    "the authors of this project", "1.0", "The wheels of the Pi-Puck.",
    R"(Sets the speeds of the two wheels over the ground, in m/s, positive ahead. They take effect in the next tick.
)" + RequiredActuatorXML(R"(<pipuck_differential_drive implementation="default" />)"),
    "Usable")

}  // namespace argos
