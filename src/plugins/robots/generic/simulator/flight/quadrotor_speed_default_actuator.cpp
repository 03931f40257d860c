#include <argos3/plugins/robots/generic/simulator/quadrotor_speed_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>

namespace argos {

namespace {

// quantities of the noise
constexpr size_t kVelocity = 0;
constexpr size_t kRotationalSpeed = 1;

}  // namespace

void CQuadRotorSpeedDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_control.Take(robot, CQuadRotorEntity::SPEED_CONTROL, "quadrotor_speed");
}

void CQuadRotorSpeedDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_QuadRotorSpeedActuator::Init(tree);
  m_noise.Init(tree, m_control.GetRobot(), {"velocity", "rotational_speed"});
}

void CQuadRotorSpeedDefaultActuator::Update() {
  m_control.GetQuadRotor().SetSpeedControlData(m_target);
}

void CQuadRotorSpeedDefaultActuator::Reset() {
  m_target = CQuadRotorEntity::SSpeedControlData();
  m_noise.Reset();
}

void CQuadRotorSpeedDefaultActuator::Set(const CQuadRotorEntity::SSpeedControlData& target) {
  m_control.GetQuadRotor().Check(target);
  m_target = target;
}

void CQuadRotorSpeedDefaultActuator::SetLinearVelocity(const CVector3& velocity) {
  Set({ApplyNoise(m_noise, kVelocity, velocity), m_target.RotSpeed});
}

void CQuadRotorSpeedDefaultActuator::SetRotationalSpeed(const CRadians& speed) {
  Set({m_target.Velocity, CRadians(m_noise.Apply(kRotationalSpeed, speed.GetValue()))});
}

REGISTER_ACTUATOR(
    CQuadRotorSpeedDefaultActuator, "quadrotor_speed", "default", "the authors of this project",
    "1.0", "Lets a flying robot move at a velocity.",
    R"(The controller orders a velocity along the axes of the world (m/s) and a rate of turning about the
vertical (rad/s); the robot's own controllers bring it to these from the next tick on. Orders hold until they are
replaced; at the start and after a reset both are zero. A robot may have this actuator or quadrotor_position, not both.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <quadrotor_speed implementation="default" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

Noise on the targets "velocity" (m/s, each component takes a draw) and "rotational_speed" (rad/s), drawn once for each
order:

  <quadrotor_speed implementation="default">
    <noise on="velocity" model="gaussian" std_dev="0.02" />
  </quadrotor_speed>

  noise@on     "velocity" or "rotational_speed"; without it, both.
  noise@model  "uniform" (level), "gaussian" (std_dev) or "rayleigh" (sigma); also bias and relative.
)",
    "Usable")

}  // namespace argos
