#include <argos3/core/simulator/entity/physics_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/engine_assignment.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

namespace argos {

CPhysicsModel::CPhysicsModel(CPhysicsEngine& engine, CEmbodiedEntity& entity)
    : m_cEngine(engine), m_cEmbodiedEntity(entity), m_engine(&engine) {}

void CPhysicsModel::UpdateEntityStatus() {
  CalculateAnchors();
  CalculateBoundingBox();
  // informs the index of the pose that an anchor method may have written
  const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
  m_cEmbodiedEntity.SetOriginPose(origin.Position, origin.Orientation);
  m_cEmbodiedEntity.GetRootEntity().Update();
  if (m_cEmbodiedEntity.IsMovable() && m_engine->IsEntityTransferActive() &&
      !m_engine->IsPointContained(origin.Position)) {
    m_engine->ScheduleEntityForTransfer(m_cEmbodiedEntity);
  }
}

void CPhysicsModel::ChangeEngines() {
  if (!m_cEmbodiedEntity.IsMovable()) {
    m_engine->GetAssignment().ReassignImmovable(m_cEmbodiedEntity);
  } else if (m_engine->GetAssignment().BelongsToAnother(m_cEmbodiedEntity, *m_engine)) {
    m_engine->TransferEntity(m_cEmbodiedEntity);
  }
}

void CPhysicsModel::CalculateAnchors() {
  for (SAnchor* anchor : m_cEmbodiedEntity.GetEnabledAnchors()) {
    if (m_anchorMethods != nullptr && anchor->Index < m_anchorMethods->size() &&
        (*m_anchorMethods)[anchor->Index]) {
      (*m_anchorMethods)[anchor->Index](*anchor);
    } else if (anchor->Index != 0) {
      anchor->FollowOrigin();
    }
  }
}

void CPhysicsModel::RegisterAnchorMethod(UInt32 anchorIndex, std::function<void(SAnchor&)> method) {
  if (m_anchorMethods == nullptr) {
    m_anchorMethods = std::make_unique<std::vector<std::function<void(SAnchor&)>>>();
  }
  if (m_anchorMethods->size() <= anchorIndex) {
    m_anchorMethods->resize(anchorIndex + 1);
  }
  (*m_anchorMethods)[anchorIndex] = std::move(method);
}

}  // namespace argos
