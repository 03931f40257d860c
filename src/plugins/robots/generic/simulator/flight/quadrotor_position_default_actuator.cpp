#include <argos3/plugins/robots/generic/simulator/quadrotor_position_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>

namespace argos {

namespace {

// quantities of the noise
constexpr size_t kPosition = 0;
constexpr size_t kYaw = 1;

}  // namespace

void CQuadRotorPositionDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_control.Take(robot, CQuadRotorEntity::POSITION_CONTROL, "quadrotor_position");
  StayHere();
}

void CQuadRotorPositionDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_QuadRotorPositionActuator::Init(tree);
  m_noise.Init(tree, m_control.GetRobot(), {"position", "yaw"});
}

void CQuadRotorPositionDefaultActuator::StayHere() {
  m_target.Position = m_control.GetBody().GetOriginAnchor().Position;
  m_target.Yaw = m_control.ComputeYaw();
}

void CQuadRotorPositionDefaultActuator::Update() {
  m_control.GetQuadRotor().SetPositionControlData(m_target);
}

void CQuadRotorPositionDefaultActuator::Reset() {
  StayHere();
  m_noise.Reset();
}

void CQuadRotorPositionDefaultActuator::Set(const CQuadRotorEntity::SPositionControlData& target) {
  m_control.GetQuadRotor().Check(target);
  m_target = target;
}

void CQuadRotorPositionDefaultActuator::SetAbsolutePosition(const CVector3& position) {
  Set({ApplyNoise(m_noise, kPosition, position), m_target.Yaw});
}

void CQuadRotorPositionDefaultActuator::SetRelativePosition(const CVector3& position) {
  const SAnchor& origin = m_control.GetBody().GetOriginAnchor();
  CVector3 offset = position;
  offset.Rotate(origin.Orientation);
  SetAbsolutePosition(origin.Position + offset);
}

void CQuadRotorPositionDefaultActuator::SetAbsoluteYaw(const CRadians& yaw) {
  Set({m_target.Position, CRadians(m_noise.Apply(kYaw, yaw.GetValue()))});
}

void CQuadRotorPositionDefaultActuator::SetRelativeYaw(const CRadians& yaw) {
  SetAbsoluteYaw(m_control.ComputeYaw() + yaw);
}

REGISTER_ACTUATOR(
    CQuadRotorPositionDefaultActuator, "quadrotor_position", "default",
    "the authors of this project", "1.0", "Sends a flying robot to a position.",
    R"(The controller orders a position (m, world frame, or from where the robot is and as it looks) and a
yaw; the robot's own controllers bring it there from the next tick on. Orders hold until they are replaced. At the
start and after a reset the robot stays where it is. A robot may have this actuator or quadrotor_speed, not both.

REQUIRED XML

  <controllers>
    <my_controller id="c1">
      <actuators>
        <quadrotor_position implementation="default" />
      </actuators>
      <sensors />
      <params />
    </my_controller>
  </controllers>

OPTIONAL XML

Noise on the targets "position" (m, each coordinate takes a draw) and "yaw" (rad), drawn once for each order:

  <quadrotor_position implementation="default">
    <noise on="position" model="gaussian" std_dev="0.02" />
  </quadrotor_position>

  noise@on     "position" or "yaw"; without it, both.
  noise@model  "uniform" (level), "gaussian" (std_dev) or "rayleigh" (sigma); also bias and relative.
)",
    "Usable")

}  // namespace argos
