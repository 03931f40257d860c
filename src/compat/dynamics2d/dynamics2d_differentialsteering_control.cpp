#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_differentialsteering_control.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

namespace argos {

CDynamics2DDifferentialSteeringControl::CDynamics2DDifferentialSteeringControl(
    CDynamics2DEngine& engine, Real maxForce, Real maxTorque, Real interwheelDistance,
    TConfigurationNode* node)
    : CDynamics2DVelocityControl(engine, maxForce, maxTorque, node, "differential_steering"),
      m_interwheelDistance(RequirePositive(interwheelDistance,
                                           "CDynamics2DDifferentialSteeringControl",
                                           "distance between the wheels (m)")) {}

void CDynamics2DDifferentialSteeringControl::SetWheelVelocity(Real left, Real right) {
  m_wheels = {left, right};
  const Real speed = 0.5 * (left + right);
  const cpVect heading = m_ptControlledBody != nullptr ? m_ptControlledBody->rot : cpv(1.0, 0.0);
  m_velocityOfWheels = {speed * heading.x, speed * heading.y};
  m_yawRateOfWheels = (right - left) / m_interwheelDistance;
  m_ptControlBody->v = m_velocityOfWheels;
  m_ptControlBody->w = m_yawRateOfWheels;
}

void CDynamics2DDifferentialSteeringControl::Reset() {
  SetWheelVelocity(0.0, 0.0);
}

void CDynamics2DDifferentialSteeringControl::Describe(SBodyDescription& description) const {
  SDifferentialDriveDescription drive;
  drive.InterwheelDistance = m_interwheelDistance;
  drive.MaxForce = m_ptLinearConstraint->maxForce;
  drive.MaxTorque = m_ptAngularConstraint->maxForce;
  description.Drive = drive;
}

// The functions of the base class may have ordered something else: wheels do not move sideways.
void CDynamics2DDifferentialSteeringControl::UpdateCommand(Real /*tick*/) {
  if (m_ptControlledBody == nullptr) {
    m_wheels = {};
    return;
  }
  const cpVect& velocity = m_ptControlBody->v;
  const Real yawRate = m_ptControlBody->w;
  if (velocity.x == m_velocityOfWheels.x && velocity.y == m_velocityOfWheels.y &&
      yawRate == m_yawRateOfWheels) {
    return;
  }
  const cpVect& heading = m_ptControlledBody->rot;
  const Real speed = velocity.x * heading.x + velocity.y * heading.y;
  const Real turn = 0.5 * m_interwheelDistance * yawRate;
  m_wheels = {speed - turn, speed + turn};
}

}  // namespace argos
