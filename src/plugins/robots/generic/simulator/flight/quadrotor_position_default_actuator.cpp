#include <argos3/plugins/robots/generic/simulator/quadrotor_position_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

namespace {

enum : size_t { kPosition, kYaw };  // quantities of the noise

}  // namespace

void CQuadRotorPositionDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_control.Acquire(robot, CQuadRotorEntity::POSITION_CONTROL, "quadrotor_position");
  m_target = MakeStartTarget();
}

void CQuadRotorPositionDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_QuadRotorPositionActuator::Init(tree);
  m_noise.Init(tree, m_control.GetRobot(), {"position", "yaw"});
}

CQuadRotorEntity::SPositionControlData CQuadRotorPositionDefaultActuator::MakeStartTarget() const {
  return {m_control.GetBody().GetOriginAnchor().Position, m_control.ComputeYaw()};
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
    "the authors of this project", "1.0", "Controls the position and the yaw of a flying robot.",
    R"(The controller sets a target position (m, in the world frame or in the frame of the robot) and a target yaw;
the flight control of the robot moves it there from the next tick on. Targets hold until they are replaced. At the start
and after a reset the robot holds its position. A robot may have this actuator or quadrotor_speed, not both.
)" + RequiredActuatorXML(R"(<quadrotor_position implementation="default" />)") +
        OptionalNoiseXML("quadrotor_position", R"(on="position" model="gaussian" std_dev="0.02")") +
        NoiseManual(
            "position|yaw",
            R"(the targets, once for each command: "position" (m, a draw for each coordinate) and "yaw" (rad).)"),
    "Usable")

}  // namespace argos
