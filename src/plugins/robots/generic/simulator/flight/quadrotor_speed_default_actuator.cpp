#include <argos3/plugins/robots/generic/simulator/quadrotor_speed_default_actuator.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/plugins/robots/generic/simulator/device_manual.h>

namespace argos {

namespace {

enum : size_t { kVelocity, kRotationalSpeed };  // quantities of the noise

}  // namespace

void CQuadRotorSpeedDefaultActuator::SetRobot(CComposableEntity& robot) {
  m_control.Acquire(robot, CQuadRotorEntity::SPEED_CONTROL, "quadrotor_speed");
}

void CQuadRotorSpeedDefaultActuator::Init(TConfigurationNode& tree) {
  CCI_QuadRotorSpeedActuator::Init(tree);
  m_noise.Init(tree, m_control.GetRobot(), {"velocity", "rotational_speed"});
}

CQuadRotorEntity::SSpeedControlData CQuadRotorSpeedDefaultActuator::MakeStartTarget() const {
  return {};
}

void CQuadRotorSpeedDefaultActuator::SetLinearVelocity(const CVector3& velocity) {
  Set({ApplyNoise(m_noise, kVelocity, velocity), m_target.RotSpeed});
}

void CQuadRotorSpeedDefaultActuator::SetRotationalSpeed(const CRadians& speed) {
  Set({m_target.Velocity, CRadians(m_noise.Apply(kRotationalSpeed, speed.GetValue()))});
}

REGISTER_ACTUATOR(
    CQuadRotorSpeedDefaultActuator, "quadrotor_speed", "default", "the authors of this project",
    "1.0", "Controls the velocity of a flying robot.",
    R"(The controller sets a target velocity in the world frame (m/s) and a rotational speed about the vertical
(rad/s); the flight control of the robot follows them from the next tick on. Targets hold until they are replaced; at
the start and after a reset both are zero. A robot may have this actuator or quadrotor_position, not both.
)" + RequiredActuatorXML(R"(<quadrotor_speed implementation="default" />)") +
        OptionalNoiseXML("quadrotor_speed", R"(on="velocity" model="gaussian" std_dev="0.02")") +
        NoiseManual(
            "velocity|rotational_speed",
            R"(the targets, once for each command: "velocity" (m/s, a draw for each component) and "rotational_speed"
(rad/s).)"),
    "Usable")

}  // namespace argos
