#include <argos3/plugins/robots/foot-bot/simulator/footbot_distance_scanner_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>

#include <cmath>

namespace argos {

namespace {

enum : size_t { ANGLE, SPEED };
constexpr Real kRadiansPerSecondPerRPM = ARGOS_PI / 30.0;

}  // namespace

void CFootBotDistanceScannerDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_scanner = &robot.GetComponent<TScanner>("distance_scanner");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
  m_scanner->Enable();
}

void CFootBotDistanceScannerDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_FootBotDistanceScannerActuator::Init(tree);
  m_noise.Init(tree, *m_robot, {"angle", "rpm"});
}

void CFootBotDistanceScannerDefaultActuator::RequireFinite(Real value, const char* what) const {
  if (!std::isfinite(value)) {
    THROW_ARGOSEXCEPTION("robot \"" << m_robot->GetRootEntity().GetId()
                                    << "\": the distance scanner's " << what
                                    << " must be finite, got " << value);
  }
}

void CFootBotDistanceScannerDefaultActuator::SetAngle(const CRadians& angle) {
  RequireFinite(angle.GetValue(), "angle (rad)");
  m_mode = TScanner::MODE_POSITION_CONTROL;
  m_angle = CRadians(m_noise.Apply(ANGLE, angle.GetValue()));
}

void CFootBotDistanceScannerDefaultActuator::SetRPM(Real rpm) {
  RequireFinite(rpm, "speed (rpm)");
  m_mode = TScanner::MODE_SPEED_CONTROL;
  m_angle.reset();
  m_speed = kRadiansPerSecondPerRPM * m_noise.Apply(SPEED, rpm);
}

void CFootBotDistanceScannerDefaultActuator::Enable() {
  m_mode = TScanner::MODE_POSITION_CONTROL;
}

void CFootBotDistanceScannerDefaultActuator::Disable() {
  m_mode = TScanner::MODE_OFF;
}

void CFootBotDistanceScannerDefaultActuator::Update() {
  m_scanner->SetMode(m_mode);
  m_scanner->SetRotationSpeed(m_speed);
  if (m_angle.has_value()) {
    m_scanner->SetRotation(*m_angle);
    m_angle.reset();
  }
}

void CFootBotDistanceScannerDefaultActuator::Reset() {
  m_mode = TScanner::MODE_OFF;
  m_angle.reset();
  m_speed = 0.0;
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CFootBotDistanceScannerDefaultActuator, "footbot_distance_scanner", "default",
    "the authors of this project", "1.0",
    "The motor of the distance scanner of foot-bots and eye-bots.",
    R"(The scanner is off at the start and after a reset. The controller rotates it to an angle, which it reaches at
once and keeps; or sets a rotational speed, in turns per minute; or switches it on, so that it holds its angle, or off. A
command takes effect in the next tick.
)" +
        RequiredActuatorXML(R"(<footbot_distance_scanner implementation="default" />)",
                            R"(<footbot_distance_scanner implementation="rot_z_only" />)") +
        OptionalNoiseXML("footbot_distance_scanner",
                         R"(on="angle" model="gaussian" std_dev="0.01")") +
        NoiseManual("angle|rpm",
                    "each angle (rad) and each speed (turns per minute) that the controller sets."),
    "Usable")

}  // namespace argos
