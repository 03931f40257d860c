#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_velocity_control.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/simulator/entities/value_checks.h>

#include <cmath>

namespace argos {

namespace {

void ReadLimits(TConfigurationNode& node, Real& force, Real& torque) {
  ReadOptionalPositive(node, "max_force", "N", force);
  ReadOptionalPositive(node, "max_torque", "N m", torque);
}

}  // namespace

CDynamics2DVelocityControl::CDynamics2DVelocityControl(CDynamics2DEngine& engine, Real maxForce,
                                                       Real maxTorque, TConfigurationNode* node)
    : CDynamics2DVelocityControl(engine, maxForce, maxTorque, node, "velocity_control") {}

CDynamics2DVelocityControl::CDynamics2DVelocityControl(CDynamics2DEngine& engine, Real maxForce,
                                                       Real maxTorque, TConfigurationNode* node,
                                                       const char* element)
    : m_cDyn2DEngine(engine), m_fMaxForce(maxForce), m_fMaxTorque(maxTorque) {
  if (node == nullptr) {
    return;
  }
  ReadLimits(*node, m_fMaxForce, m_fMaxTorque);
  if (NodeExists(*node, "dynamics2d") && NodeExists(GetNode(*node, "dynamics2d"), element)) {
    ReadLimits(GetNode(GetNode(*node, "dynamics2d"), element), m_fMaxForce, m_fMaxTorque);
  }
}

CDynamics2DVelocityControl::~CDynamics2DVelocityControl() {
  // not Detach(): the body may be gone
}

void CDynamics2DVelocityControl::AttachTo(cpBody* body) {
  if (body == nullptr) {
    THROW_ARGOSEXCEPTION("AttachTo(): the body is a null pointer");
  }
  if (body->Control != nullptr && body->Control != this) {
    THROW_ARGOSEXCEPTION("AttachTo(): the body has a control already");
  }
  if (body->IsDescribed && body->Drive != this) {
    THROW_ARGOSEXCEPTION(
        "AttachTo() is called after the constructor of the model: the engine has "
        "built the body without this drive");
  }
  Detach();
  m_ptControlledBody = body;
  body->Control = this;
  m_linearConstraint.a = m_angularConstraint.a = body;
  m_linearConstraint.b = m_angularConstraint.b = m_ptControlBody;
  m_linearConstraint.maxForce = m_fMaxForce;
  m_angularConstraint.maxForce = m_fMaxTorque;
  m_ptLinearConstraint = &m_linearConstraint;
  m_ptAngularConstraint = &m_angularConstraint;
}

void CDynamics2DVelocityControl::Detach() {
  if (m_ptControlledBody != nullptr) {
    m_ptControlledBody->Control = nullptr;
    m_ptControlledBody = nullptr;
  }
  m_ptLinearConstraint = m_ptAngularConstraint = nullptr;
}

void CDynamics2DVelocityControl::Reset() {
  m_ptControlBody->v = cpvzero;
  m_ptControlBody->w = 0.0;
}

void CDynamics2DVelocityControl::Describe(SBodyDescription& description) const {
  description.PlanarDrive =
      SPlanarDriveDescription{m_linearConstraint.maxForce, m_angularConstraint.maxForce};
}

// A drive follows an arc: its chord has the angle of the heading half-way, and is shorter than the
// arc. So the command is such that the chord is the straight way in the world frame.
void CDynamics2DVelocityControl::UpdateCommand(Real tick) {
  if (m_ptControlledBody == nullptr) {
    m_command = SDriveCommand();
    return;
  }
  const Real yawRate = m_ptControlBody->w;
  const Real halfTurn = 0.5 * yawRate * tick;
  CVector2 velocity = GetLinearVelocity();
  // beyond half a rotation in a tick there is no such arc of about the same length
  if (halfTurn != 0.0 && std::abs(halfTurn) < 0.5 * ARGOS_PI) {
    velocity *= halfTurn / std::sin(halfTurn);
    velocity.Rotate(CRadians(-halfTurn));
  }
  velocity.Rotate(CRadians(-m_ptControlledBody->a));
  m_command = {velocity.GetX(), velocity.GetY(), yawRate};
}

}  // namespace argos
