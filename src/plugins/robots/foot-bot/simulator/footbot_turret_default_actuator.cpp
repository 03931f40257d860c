#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>

#include <cmath>

namespace argos {

namespace {

// rad/s of one turn per minute
constexpr Real kRadiansPerSecond = ARGOS_PI / 30.0;

// numbers of the quantities that <noise> may be on
enum : size_t { QUANTITY_ROTATION, QUANTITY_ROTATION_SPEED };

CTurretEntity::EMode ToEntityMode(CCI_FootBotTurretActuator::ETurretModes mode) {
  switch (mode) {
    case CCI_FootBotTurretActuator::MODE_PASSIVE:
      return CTurretEntity::MODE_PASSIVE;
    case CCI_FootBotTurretActuator::MODE_SPEED_CONTROL:
      return CTurretEntity::MODE_SPEED_CONTROL;
    case CCI_FootBotTurretActuator::MODE_POSITION_CONTROL:
      return CTurretEntity::MODE_POSITION_CONTROL;
    default:
      return CTurretEntity::MODE_OFF;
  }
}

}  // namespace

void CFootBotTurretDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_turret = &robot.GetComponent<CTurretEntity>("turret");
  m_robot = &robot.GetComponent<CControllableEntity>("controller");
}

void CFootBotTurretDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_FootBotTurretActuator::Init(tree);
  m_noise.Init(tree, *m_robot, {"rotation", "rotation_speed"});
}

void CFootBotTurretDefaultActuator::SetRotation(const CRadians& angle) {
  if (!std::isfinite(angle.GetValue())) {
    THROW_ARGOSEXCEPTION("footbot_turret: the rotation must be a finite angle, got "
                         << angle.GetValue() << " rad");
  }
  m_rotation = CRadians(m_noise.Apply(QUANTITY_ROTATION, angle.GetValue()));
}

void CFootBotTurretDefaultActuator::SetRotationSpeed(SInt32 pulses) {
  m_speed = kRadiansPerSecond * m_noise.Apply(QUANTITY_ROTATION_SPEED, pulses);
}

void CFootBotTurretDefaultActuator::SetMode(ETurretModes mode) {
  m_mode = mode;
}

void CFootBotTurretDefaultActuator::Update() {
  m_turret->SetMode(ToEntityMode(m_mode));
  m_turret->SetDesiredRotation(m_rotation);
  m_turret->SetDesiredRotationSpeed(m_speed);
}

void CFootBotTurretDefaultActuator::Reset() {
  m_mode = MODE_OFF;
  m_rotation = CRadians::ZERO;
  m_speed = 0.0;
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CFootBotTurretDefaultActuator, "footbot_turret", "default", "the authors of this project",
    "1.0", "Rotates the turret of the foot-bot.",
    R"(The turret carries the gripper and the LEDs. Its motor rotates it relative to the base; rotations are in rad,
counter-clockwise from straight ahead. Modes:

  off                at the start and after a reset: the turret keeps its rotation on the base. While the gripper
                     holds a body, it rotates freely instead, so that the base can rotate under it.
  passive            the same.
  speed control      the turret rotates at the target speed: whole turns per minute, counter-clockwise. Real
                     turrets reach 4; this is not enforced.
  position control   once per tick, with the error e = target - actual rotation, in (-pi,pi], the speed is
                     0.4 e + 0.2 (change of e in the last tick) / tick, in rad/s: the error falls by a factor of
                     2.7 in about 3 s.

The torque of the motor is at most 150 N m while the gripper holds a body. Modes and targets are independent: a target is
kept while another mode is active. A command takes effect in the next tick.
)" + RequiredActuatorXML(R"(<footbot_turret implementation="default" />)") +
        OptionalNoiseXML("footbot_turret", R"(on="rotation" model="gaussian" std_dev="0.02")") +
        NoiseManual(
            "rotation|rotation_speed",
            "the targets, once for each command: rotation (rad) and speed (turns per minute)."),
    "Usable")

}  // namespace argos
