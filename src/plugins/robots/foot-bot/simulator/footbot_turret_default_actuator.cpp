#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>

#include <cmath>

namespace argos {

namespace {

// rad/s of one turn per minute
constexpr Real kRadiansPerSecond = ARGOS_PI / 30.0;

// numbers of the quantities that <noise> may be on
enum EQuantity : size_t { QUANTITY_ROTATION, QUANTITY_ROTATION_SPEED };

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
  m_speed = CRadians(kRadiansPerSecond * m_noise.Apply(QUANTITY_ROTATION_SPEED, pulses));
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
  m_speed = CRadians::ZERO;
  m_noise.Reset();
}

REGISTER_ACTUATOR(
    CFootBotTurretDefaultActuator, "footbot_turret", "default", "the authors of this project",
    "1.0", "Turns the turret of the foot-bot.",
    R"(The turret carries the gripper and the LEDs. Its motor turns it against the base; rotations are in rad,
counter-clockwise from straight ahead. Modes:

  off                at the start and after a reset: the turret stays as it is on the base. While the gripper
                     holds something, it turns freely instead, so that the base may turn under it.
  passive            the same.
  speed control      the turret turns at the speed that is set: whole turns per minute, counter-clockwise. Real
                     turrets reach 4; this is not enforced.
  position control   once a tick, with the error e = desired - actual rotation, the short way round, the speed is
                     0.4 e + 0.2 (change of e in the last tick) / tick, in rad/s: the error falls to 1/e of it in
                     some 3 s.

The motor has at most 150 N m, when something is held. Modes and targets are independent: each is kept while another mode
is on. An order given in one step is followed in the next tick.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <footbot_turret implementation="default" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

Noise on the targets "rotation" (rad) and "rotation_speed" (turns per minute), drawn once for each order:

  <footbot_turret implementation="default">
    <noise on="rotation" model="gaussian" std_dev="0.02" />
  </footbot_turret>

  noise@on     "rotation" or "rotation_speed"; without it, both.
  noise@model  "uniform" (level), "gaussian" (std_dev) or "rayleigh" (sigma); also bias and relative.
)",
    "Usable")

}  // namespace argos
