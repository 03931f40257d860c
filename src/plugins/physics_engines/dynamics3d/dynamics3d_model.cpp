#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

namespace argos {

CDynamics3DModel::CDynamics3DModel(CDynamics3DEngine& engine, CEmbodiedEntity& entity,
                                   const Real* wheels)
    : CRobotBodyModel(engine, entity, wheels) {}

SRigidBody& CDynamics3DModel::GetBody() const {
  ARGOS_ASSERT(m_body != nullptr && m_body->Source.Owner == this,
               "the rigid body of \"" << m_cEmbodiedEntity.GetId() << "\" is gone");
  return *m_body;
}

void CDynamics3DModel::ManipulatorChanged() {
  static_cast<CDynamics3DEngine&>(GetEngine()).UpdateManipulator(*this);
}

CVector3 CDynamics3DModel::GetCentreOfMass() const {
  return m_body != nullptr && GetBody().IsMovable() ? FromODE(dBodyGetPosition(GetBody().Body))
                                                    : GetOriginPosition();
}

CQuaternion CDynamics3DModel::GetOrientation() const {
  return m_body != nullptr && GetBody().IsMovable()
             ? QuaternionFromODE(dBodyGetQuaternion(GetBody().Body))
             : m_cEmbodiedEntity.GetOriginAnchor().Orientation;
}

CVector3 CDynamics3DModel::GetVelocity() const {
  return m_body != nullptr && GetBody().IsMovable() ? FromODE(dBodyGetLinearVel(GetBody().Body))
                                                    : CVector3();
}

CVector3 CDynamics3DModel::GetAngularVelocity() const {
  return m_body != nullptr && GetBody().IsMovable() ? FromODE(dBodyGetAngularVel(GetBody().Body))
                                                    : CVector3();
}

CVector3 CDynamics3DModel::GetOriginPosition() const {
  return m_body != nullptr && GetBody().IsMovable() ? GetRigidPose(GetBody()).Position
                                                    : m_cEmbodiedEntity.GetOriginAnchor().Position;
}

void CDynamics3DModel::AddForce(const CVector3& force, const CVector3& point) {
  if (m_body == nullptr || !GetBody().IsMovable() || force == CVector3()) {
    return;
  }
  WakeRigidBody(GetBody());
  dBodyAddForceAtPos(GetBody().Body, force.GetX(), force.GetY(), force.GetZ(), point.GetX(),
                     point.GetY(), point.GetZ());
}

void CDynamics3DModel::AddTorque(const CVector3& torque) {
  if (m_body == nullptr || !GetBody().IsMovable() || torque == CVector3()) {
    return;
  }
  WakeRigidBody(GetBody());
  dBodyAddTorque(GetBody().Body, torque.GetX(), torque.GetY(), torque.GetZ());
}

}  // namespace argos
