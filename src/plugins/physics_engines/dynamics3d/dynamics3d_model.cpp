#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/plugins/simulator/entities/turret_entity.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

namespace argos {

CDynamics3DModel::CDynamics3DModel(CDynamics3DEngine& engine, CEmbodiedEntity& entity,
                                   const Real* wheels)
    : CDescribedBodyModel(engine, entity), m_root(entity.GetRootEntity()), m_wheels(wheels) {
  // those that are made on demand, later, are told of
  if (const auto* const robot = dynamic_cast<CComposableEntity*>(&m_root)) {
    for (CEntity* component : robot->GetExistingComponents()) {
      SetComponent(*component, true);
    }
  }
}

CDynamics3DEngine& CDynamics3DModel::GetDynamics3DEngine() const {
  return static_cast<CDynamics3DEngine&>(m_cEngine);
}

void CDynamics3DModel::Replace() {
  GetDynamics3DEngine().MarkDisplaced(*this);
}

void CDynamics3DModel::ConfirmMove() {
  GetDynamics3DEngine().Replace(*this);
}

void CDynamics3DModel::ComponentAdded(CEntity& component) {
  SetComponent(component, true);
  GetDynamics3DEngine().UpdateManipulator(*this);
}

void CDynamics3DModel::ComponentRemoved(CEntity& component) {
  SetComponent(component, false);
  GetDynamics3DEngine().UpdateManipulator(*this);
}

void CDynamics3DModel::SetComponent(CEntity& component, bool isThere) {
  if (auto* const gripper = dynamic_cast<CGripperEquippedEntity*>(&component)) {
    m_gripper = isThere ? gripper : nullptr;
  } else if (auto* const turret = dynamic_cast<CTurretEntity*>(&component)) {
    m_turret = isThere ? turret : nullptr;
  }
}

CVector3 CDynamics3DModel::GetCentreOfMass() const {
  return m_body != nullptr && m_body->IsMovable() ? FromODE(dBodyGetPosition(m_body->Body))
                                                  : GetOriginPosition();
}

CQuaternion CDynamics3DModel::GetOrientation() const {
  return m_body != nullptr && m_body->IsMovable()
             ? QuaternionFromODE(dBodyGetQuaternion(m_body->Body))
             : m_cEmbodiedEntity.GetOriginAnchor().Orientation;
}

CVector3 CDynamics3DModel::GetVelocity() const {
  return m_body != nullptr && m_body->IsMovable() ? FromODE(dBodyGetLinearVel(m_body->Body))
                                                  : CVector3();
}

CVector3 CDynamics3DModel::GetAngularVelocity() const {
  return m_body != nullptr && m_body->IsMovable() ? FromODE(dBodyGetAngularVel(m_body->Body))
                                                  : CVector3();
}

CVector3 CDynamics3DModel::GetOriginPosition() const {
  return m_body != nullptr && m_body->IsMovable() ? GetRigidPose(*m_body).Position
                                                  : m_cEmbodiedEntity.GetOriginAnchor().Position;
}

void CDynamics3DModel::AddForce(const CVector3& force, const CVector3& point) {
  if (m_body == nullptr || !m_body->IsMovable() || force == CVector3()) {
    return;
  }
  WakeRigidBody(*m_body);
  dBodyAddForceAtPos(m_body->Body, force.GetX(), force.GetY(), force.GetZ(), point.GetX(),
                     point.GetY(), point.GetZ());
}

void CDynamics3DModel::AddTorque(const CVector3& torque) {
  if (m_body == nullptr || !m_body->IsMovable() || torque == CVector3()) {
    return;
  }
  WakeRigidBody(*m_body);
  dBodyAddTorque(m_body->Body, torque.GetX(), torque.GetY(), torque.GetZ());
}

}  // namespace argos
