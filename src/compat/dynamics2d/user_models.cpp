// What users' models of bodies call of the engine; nothing here runs in a tick.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/plugins/simulator/entities/value_checks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_settings.h>

namespace argos {

cpFloat CDynamics2DEngine::GetBoxLinearFriction() const {
  return m_settings->BoxFriction.Force;
}

cpFloat CDynamics2DEngine::GetBoxAngularFriction() const {
  return m_settings->BoxFriction.Torque;
}

cpFloat CDynamics2DEngine::GetCylinderLinearFriction() const {
  return m_settings->CylinderFriction.Force;
}

cpFloat CDynamics2DEngine::GetCylinderAngularFriction() const {
  return m_settings->CylinderFriction.Torque;
}

void CDynamics2DEngine::SetGrippingRigidity(Real rigidity) {
  m_grippingRigidity = RequireNotNegative(rigidity, "SetGrippingRigidity()", "rigidity (N/m)");
  m_settings->GrippingRigidity = rigidity;
}

void CDynamics2DEngine::SetDamping(Real damping) {
  if (damping != 1.0) {
    THROW_ARGOSEXCEPTION("SetDamping(): dynamics2d has no damping, so it must be 1, found "
                         << damping);
  }
}

void CDynamics2DEngine::SetGravity(const CVector2& gravity) {
  if (gravity != CVector2()) {
    THROW_ARGOSEXCEPTION(
        "SetGravity(): the plane of dynamics2d is horizontal, so gravity along it "
        "must be 0, found "
        << gravity);
  }
}

void CDynamics2DEngine::PositionPhysicsToSpace(CVector3& position, const CVector3& original,
                                               const cpBody* body) {
  position.Set(body->p.x, body->p.y, original.GetZ());
}

void CDynamics2DEngine::OrientationPhysicsToSpace(CQuaternion& orientation, const cpBody* body) {
  orientation.FromAngleAxis(CRadians(body->a), CVector3::Z);
}

void CDynamics2DEngine::AddPhysicsModel(const std::string& id, CDynamics2DModel& model) {
  std::unique_ptr<CDynamics2DModel> owned(&model);
  if (m_handedOver != nullptr) {
    THROW_ARGOSEXCEPTION("AddPhysicsModel(): an operation has added a second model, for \""
                         << id << "\"");
  }
  m_handedOver = std::move(owned);
}

void CDynamics2DEngine::RemovePhysicsModel(const std::string& id) {
  for (const auto& model : GetModels()) {
    CEntity& root = model->GetEmbodiedEntity().GetRootEntity();
    if (model->GetRecordedBody() != nullptr && root.GetId() == id) {
      RemoveEntity(root);
      return;
    }
  }
  THROW_ARGOSEXCEPTION("the physics engine \"" << GetId() << "\" has no user's model of \"" << id
                                               << "\"");
}

bool CDynamics2DEngine::HasUserModel(CEntity& root) {
  using THolder = CEntityOperationInstanceHolder<CDynamics2DOperationAddEntity, CDynamics2DEngine,
                                                 SOperationOutcome>;
  return GetVTable<CDynamics2DOperationAddEntity, CEntity, THolder*>()[root.GetTag()] != nullptr;
}

std::unique_ptr<CDynamics2DModel> CDynamics2DEngine::MakeUserModel(CEntity& root) {
  m_handedOver.reset();
  try {
    CallEntityOperation<CDynamics2DOperationAddEntity, CDynamics2DEngine, SOperationOutcome>(*this,
                                                                                             root);
  } catch (std::exception& error) {
    m_handedOver.reset();
    THROW_ARGOSEXCEPTION_NESTED("the user's model of <" << root.GetTypeDescription() << " id=\""
                                                        << root.GetId()
                                                        << "\"> for dynamics2d failed",
                                error);
  }
  if (m_handedOver == nullptr) {
    THROW_ARGOSEXCEPTION("the operation that adds <" << root.GetTypeDescription() << " id=\""
                                                     << root.GetId()
                                                     << "\"> to dynamics2d does not call "
                                                        "AddPhysicsModel()");
  }
  // operations that users write add the model to the body, too; the engine adds its own one
  CEmbodiedEntity& body = m_handedOver->GetEmbodiedEntity();
  for (UInt32 i = 0; i < body.GetPhysicsModelsNum(); ++i) {
    if (&body.GetPhysicsModel(size_t(i)) == m_handedOver.get()) {
      body.RemovePhysicsModel(GetId());
      break;
    }
  }
  return std::move(m_handedOver);
}

}  // namespace argos
