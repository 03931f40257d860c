#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_model.h>

#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>

namespace argos {

CPointMass3DModel::CPointMass3DModel(CPointMass3DEngine& engine, CEmbodiedEntity& body)
    : CPhysicsModel(engine, body),
      m_cPM3DEngine(engine),
      m_cPosition(body.GetOriginAnchor().Position) {
  RegisterAnchorMethod(body.GetOriginAnchor(), &CPointMass3DModel::UpdateOriginAnchor);
}

void CPointMass3DModel::MoveTo(const CVector3& position, const CQuaternion&) {
  CRobotsCode::CheckShared("CPhysicsModel::MoveTo()");
  m_cPosition = position;
  m_cVelocity = CVector3();
  m_cAcceleration = CVector3();
  CalculateAnchors();
  CalculateBoundingBox();
}

void CPointMass3DModel::Reset() {
  m_cPosition = m_cEmbodiedEntity.GetInitPosition();
  m_cVelocity = CVector3();
  m_cAcceleration = CVector3();
  CalculateBoundingBox();
}

bool CPointMass3DModel::IsCollidingWithSomething() const {
  return m_cPM3DEngine.HasOverlap(*this);
}

void CPointMass3DModel::UpdateOriginAnchor(SAnchor& anchor) {
  anchor.Position = m_cPosition;
}

}  // namespace argos
