#include <argos3/core/simulator/actuator.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/control_interface/ci_planar_drive_actuator.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/robots/generic/simulator/noise.h>
#include <argos3/plugins/simulator/entities/planar_drive_entity.h>

namespace argos {

namespace {

constexpr Real kMetresPerCentimetre = 0.01;

}  // namespace

/** Sets the command of a robot's "planar_drive", with optional noise. */
class CPlanarDriveDefaultActuator : public CSimulatedActuator, public CCI_PlanarDriveActuator {
 public:
  /** @throws CARGoSException if the robot has no "planar_drive". */
  void SetRobot(CComposableEntity& robot) override;
  /** Reads `<noise>` children. */
  void Init(TConfigurationNode& tree) override;
  void SetVelocity(Real ahead, Real left, const CRadians& yawRate) override;
  void Update() override;
  void Reset() override;

 private:
  CPlanarDriveEntity* m_drive = nullptr;
  CControllableEntity* m_robot = nullptr;
  SDriveCommand m_command;
  CDeviceNoise m_noise;
};

void CPlanarDriveDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_drive = &robot.GetComponent<CPlanarDriveEntity>("planar_drive");
}

void CPlanarDriveDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_PlanarDriveActuator::Init(tree);
  m_noise.Init(tree, *m_robot, {"ahead", "left", "yaw_rate"});
}

void CPlanarDriveDefaultActuator::SetVelocity(Real ahead, Real left, const CRadians& yawRate) {
  SDriveCommand command{kMetresPerCentimetre * ahead, kMetresPerCentimetre * left,
                        yawRate.GetValue()};
  if (!command.IsFinite()) {
    THROW_ARGOSEXCEPTION("robot \"" << m_robot->GetRootEntity().GetId()
                                    << "\": the velocity of a planar drive must be finite, got "
                                    << ahead << " cm/s ahead, " << left << " cm/s to the left, "
                                    << yawRate.GetValue() << " rad/s");
  }
  if (!(command == SDriveCommand())) {
    command = {m_noise.Apply(0, command.Ahead), m_noise.Apply(1, command.Left),
               m_noise.Apply(2, command.YawRate)};
  }
  m_command = command;
}

void CPlanarDriveDefaultActuator::Update() {
  m_drive->SetCommand(m_command);
}

void CPlanarDriveDefaultActuator::Reset() {
  m_command = SDriveCommand();
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CPlanarDriveDefaultActuator, "planar_drive", "default", "the authors of this project", "1.0",
    "Moves a robot that can drive to all sides.",
    R"(For robots with the component "planar_drive", such as those on omnidirectional wheels. The controller sets a velocity
in the frame of the robot: cm/s ahead, cm/s to the left, and a yaw rate in rad/s, counter-clockwise. A velocity holds
from the next tick on until it is changed; at the start and after a reset it is 0. The force and torque of the drive are
limited by the robot's body.
)" + RequiredActuatorXML(R"(<planar_drive implementation="default" />)") +
        NoiseManual("ahead|left|yaw_rate",
                    "the velocity (m/s, m/s and rad/s) each time the controller sets it, unless it "
                    "is set to 0."),
    "Usable")

}  // namespace argos
