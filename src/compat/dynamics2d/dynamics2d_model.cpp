#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_model.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/planar_motion.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/dynamics2d_engine.h>

namespace argos {

CDynamics2DModel::CDynamics2DModel(CDynamics2DEngine& engine, CEmbodiedEntity& entity)
    : CPhysicsModel(engine, entity), m_cDyn2DEngine(engine) {
  RegisterAnchorMethod(entity.GetOriginAnchor(), &CDynamics2DModel::UpdateOriginAnchor);
}

void CDynamics2DModel::AddPart(cpBody* body, const cpVect& offset, cpFloat angle, Real height) {
  if (body == nullptr) {
    THROW_ARGOSEXCEPTION("the body of a model must not be a null pointer");
  }
  if (!(height > 0.0)) {
    THROW_ARGOSEXCEPTION("the height of a body (m) must be a number > 0, found " << height);
  }
  m_parts.push_back({body, offset, angle, height});
}

void CDynamics2DModel::Reset() {
  const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
  MoveTo(origin.Position, origin.Orientation);
  for (const SPart& part : m_parts) {
    part.Body->v = cpvzero;
    part.Body->w = 0.0;
  }
}

void CDynamics2DModel::UpdateEntityStatus() {
  CalculateBoundingBox();
  CalculateAnchors();
  if (m_cEmbodiedEntity.GetEnabledAnchors().size() > 1 && m_cEmbodiedEntity.HasFollowers()) {
    m_cEmbodiedEntity.GetRootEntity().Update();
  }
}

void CDynamics2DModel::MoveTo(const CVector3& position, const CQuaternion& orientation) {
  CRobotsCode::CheckShared("CPhysicsModel::MoveTo()");
  PlaceParts(position, orientation);
  CalculateBoundingBox();
}

void CDynamics2DModel::CalculateBoundingBox() {
  if (const SBodyDescription* const description = m_cEmbodiedEntity.GetBodyDescription()) {
    const SAnchor& origin = m_cEmbodiedEntity.GetOriginAnchor();
    m_sBoundingBox = description->ComputeBoundingBox(origin.Position, origin.Orientation);
  }
}

bool CDynamics2DModel::IsCollidingWithSomething() const {
  return m_cEmbodiedEntity.IsCollidingWithSomething();
}

void CDynamics2DModel::PlaceParts(const CVector3& position, const CQuaternion& orientation) {
  const SPlanarPose pose = MakePlanarPose(position, orientation);
  const Real yaw = pose.ComputeYaw();
  const Real cosine = std::cos(yaw);
  const Real sine = std::sin(yaw);
  for (const SPart& part : m_parts) {
    part.Body->p = {pose.X + cosine * part.Offset.x - sine * part.Offset.y,
                    pose.Y + sine * part.Offset.x + cosine * part.Offset.y};
    cpBodySetAngle(part.Body, yaw + part.Angle);
  }
}

}  // namespace argos
