#include <argos3/core/simulator/physics_engine/described_body_model.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/grown_body.h>
#include <argos3/core/simulator/physics_engine/described_body_engine.h>
#include <argos3/core/simulator/physics_engine/recorded_body.h>

#include <cmath>

namespace argos {

CEmbodiedEntity* FindEmbodiedEntity(CEntity& root) {
  auto* const composable = dynamic_cast<CComposableEntity*>(&root);
  return composable != nullptr && composable->HasComponent("body")
             ? &composable->GetComponent<CEmbodiedEntity>("body")
             : nullptr;
}

CEmbodiedEntity* FindDescribedBody(CEntity& root) {
  CEmbodiedEntity* const body = FindEmbodiedEntity(root);
  const SBodyDescription* const description =
      body != nullptr ? body->GetBodyDescription() : nullptr;
  return description != nullptr && !description->Shapes.empty() ? body : nullptr;
}

CDescribedBodyModel::CDescribedBodyModel(CDescribedBodyEngine& engine, CEmbodiedEntity& entity)
    : CPhysicsModel(engine, entity), m_root(entity.GetRootEntity()) {}

CDescribedBodyModel::~CDescribedBodyModel() = default;

CDescribedBodyEngine& CDescribedBodyModel::GetDescribedBodyEngine() {
  return static_cast<CDescribedBodyEngine&>(GetEngine());
}

void CDescribedBodyModel::MoveTo(const CVector3& position, const CQuaternion& orientation) {
  CRobotsCode::CheckShared("CPhysicsModel::MoveTo()");
  if (!std::isfinite(position.Length()) || !std::isfinite(orientation.SquareLength())) {
    THROW_ARGOSEXCEPTION("\"" << m_cEmbodiedEntity.GetRootEntity().GetId()
                              << "\" cannot be moved to (" << position << "), turned by ("
                              << orientation << "): all numbers must be finite");
  }
  GetDescribedBodyEngine().NoticeMove(*this);
  CalculateAnchors();
  CalculateBoundingBox();
  if (m_recordedBody != nullptr) {
    m_recordedBody->MoveTo(position, orientation);
  }
}

void CDescribedBodyModel::ConfirmMove() {
  GetDescribedBodyEngine().NoticeConfirmedMove(*this);
}

void CDescribedBodyModel::CalculateBoundingBox() {
  const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
  m_sBoundingBox = m_cEmbodiedEntity.GetBodyDescription()->ComputeBoundingBox(
      origin.Position, origin.Orientation, m_cEmbodiedEntity.GetLinkPoses());
}

bool CDescribedBodyModel::IsCollidingWithSomething() const {
  return Overlaps(GrowBody(*m_cEmbodiedEntity.GetBodyDescription(), kTouchDistance));
}

bool CDescribedBodyModel::IsOverlappingSomething() const {
  return Overlaps(*m_cEmbodiedEntity.GetBodyDescription());
}

bool CDescribedBodyModel::Overlaps(const SBodyDescription& description) const {
  const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
  return GetEngine().GetContext().Index->FindOverlap(
             description, origin.Position, origin.Orientation, m_cEmbodiedEntity.GetBodyNumber(),
             m_cEmbodiedEntity.GetLinkPoses()) != CBodyIndex::kNoBody;
}

}  // namespace argos
