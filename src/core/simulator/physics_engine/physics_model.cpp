#include <argos3/core/simulator/physics_engine/physics_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <algorithm>

namespace argos {

SAnchor::SAnchor(CEmbodiedEntity& body, const std::string& id, UInt32 index,
                 const CVector3& offsetPosition, const CQuaternion& offsetOrientation,
                 const CVector3& position, const CQuaternion& orientation)
    : Body(body),
      Id(id),
      Index(index),
      OffsetPosition(offsetPosition),
      OffsetOrientation(offsetOrientation),
      Position(position),
      Orientation(orientation) {}

void SAnchor::Enable() {
  if (InUseCount++ == 0) {
    auto& enabled = Body.m_vecEnabledAnchors;
    enabled.push_back(this);
    // sorted by index, independent of the order of Enable() calls
    std::sort(enabled.begin(), enabled.end(),
              [](const SAnchor* a, const SAnchor* b) { return a->Index < b->Index; });
    // the pose was not kept current so far
    if (Index != 0) {
      FollowOrigin();
    }
  }
}

void SAnchor::Disable() {
  if (InUseCount == 0) {
    return;
  }
  if (Index == 0 && InUseCount == 1) {
    THROW_ARGOSEXCEPTION("the origin anchor of body \"" << Body.GetContext() << Body.GetId()
                                                        << "\" cannot be disabled");
  }
  if (--InUseCount == 0) {
    auto& enabled = Body.m_vecEnabledAnchors;
    enabled.erase(std::find(enabled.begin(), enabled.end(), this));
  }
}

void SAnchor::ReturnToStart() {
  while (InUseCount < InUseCountAtStart) {
    Enable();
  }
  // the body itself always uses its origin
  const UInt32 least = Index == 0 ? std::max<UInt32>(InUseCountAtStart, 1) : InUseCountAtStart;
  while (InUseCount > least) {
    Disable();
  }
}

void SAnchor::FollowOrigin() {
  const SAnchor& origin = Body.GetOriginAnchor();
  Position = OffsetPosition;
  Position.Rotate(origin.Orientation);
  Position += origin.Position;
  Orientation = origin.Orientation * OffsetOrientation;
}

bool SBoundingBox::Intersects(const SBoundingBox& other) const {
  return MinCorner <= other.MaxCorner && other.MinCorner <= MaxCorner;
}

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
