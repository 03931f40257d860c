#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/articulation.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/articulated_body.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/body_builder.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

namespace argos {

CDynamics3DModel::CDynamics3DModel(CDynamics3DEngine& engine, CEmbodiedEntity& entity,
                                   const CDriveSource& drive)
    : CRobotBodyModel(engine, entity, drive) {}

SRigidBody& CDynamics3DModel::GetBody() const {
  ARGOS_ASSERT(m_body != nullptr && m_body->Source.Owner == this,
               "the rigid body of \"" << m_cEmbodiedEntity.GetId() << "\" is gone");
  return *m_body;
}

void CDynamics3DModel::ManipulatorChanged() {
  static_cast<CDynamics3DEngine&>(GetEngine()).UpdateManipulator(*this);
}

bool CDynamics3DModel::IsMoved() const {
  return m_body != nullptr && GetBody().IsMovable();
}

const CVector3& CDynamics3DModel::GetFrameOrigin() const {
  return static_cast<const CDynamics3DEngine&>(GetEngine()).GetFrameOrigin();
}

CVector3 CDynamics3DModel::GetCentreOfMass() const {
  if (!IsMoved()) {
    return GetOriginPosition();
  }
  const SRigidPose pose = GetRigidPose(GetBody());
  const CVector3 centre = GetBody().IsFree
                              ? pose.Position + Rotated(GetBody().CentreOfMass, pose.Orientation)
                              : FromODE(dBodyGetPosition(GetBody().Body));
  return centre + GetFrameOrigin();
}

CQuaternion CDynamics3DModel::GetOrientation() const {
  return IsMoved() ? GetRigidPose(GetBody()).Orientation
                   : m_cEmbodiedEntity.GetOriginAnchor().Orientation;
}

CVector3 CDynamics3DModel::GetVelocity() const {
  return IsMoved() ? GetRigidVelocity(GetBody()) : CVector3();
}

CVector3 CDynamics3DModel::GetAngularVelocity() const {
  return IsMoved() ? GetRigidAngularVelocity(GetBody()) : CVector3();
}

CVector3 CDynamics3DModel::GetOriginPosition() const {
  return IsMoved() ? GetRigidPose(GetBody()).Position + GetFrameOrigin()
                   : m_cEmbodiedEntity.GetOriginAnchor().Position;
}

dxBody* CDynamics3DModel::WakeLink(const CVector3& push, UInt32 link) {
  if (!IsMoved() || push == CVector3()) {
    return nullptr;
  }
  static_cast<CDynamics3DEngine&>(GetEngine()).ActivateBody(GetBody());
  WakeRigidBody(GetBody());
  return link == 0 ? GetBody().Body : GetBody().Links[link - 1].Part;
}

void CDynamics3DModel::AddForce(const CVector3& force, const CVector3& point, UInt32 link) {
  if (const dBodyID part = WakeLink(force, link)) {
    const CVector3 own = point - GetFrameOrigin();
    dBodyAddForceAtPos(part, force.GetX(), force.GetY(), force.GetZ(), own.GetX(), own.GetY(),
                       own.GetZ());
  }
}

void CDynamics3DModel::AddTorque(const CVector3& torque, UInt32 link) {
  if (const dBodyID part = WakeLink(torque, link)) {
    dBodyAddTorque(part, torque.GetX(), torque.GetY(), torque.GetZ());
  }
}

bool CDynamics3DModel::IsFree() const {
  return m_body != nullptr && GetBody().IsFree;
}

bool CDynamics3DModel::IsUpright() const {
  return m_body != nullptr && GetBody().IsUpright;
}

UInt32 CDynamics3DModel::FindLink(const SAnchor& anchor) const {
  const auto& articulation = m_cEmbodiedEntity.GetBodyDescription()->Articulation;
  if (articulation == nullptr) {
    return 0;
  }
  const auto found = articulation->Anchors.find(anchor.Id);
  return found != articulation->Anchors.end() ? found->second : 0;
}

SBodyPose CDynamics3DModel::ComputePose(const SAnchor& anchor, UInt32 link) const {
  SBodyPose frame{GetOriginPosition(), GetOrientation()};
  if (link > 0 && m_body != nullptr) {
    // the offset of an anchor on a link is that of the last tick
    frame = Compose(GetLinkFrame(GetBody(), link), Invert(m_cEmbodiedEntity.GetLinkPoses()[link]));
    frame.Position += GetFrameOrigin();
  }
  return Compose(frame, {anchor.OffsetPosition, anchor.OffsetOrientation});
}

}  // namespace argos
