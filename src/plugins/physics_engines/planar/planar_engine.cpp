#include <argos3/plugins/simulator/physics_engines/planar/planar_engine.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/simulator/physics_engines/planar/planar_body.h>

namespace argos {

void CPlanarEngine::Init(TConfigurationNode& tree) {
  CDescribedBodyEngine::Init(tree);
  GetNodeAttributeOrDefault(tree, "elevation", m_elevation, 0.0);
  m_velocityLag = ReadVelocityLag(tree, GetIterations());
  if (NodeExists(tree, "spatial_hash")) {
    // tunes a broad phase that these engines do not have
    MarkSubtreeRead(GetNode(tree, "spatial_hash"));
  }
}

bool CPlanarEngine::IsTouchedBy(const CEmbodiedEntity& body) {
  return IsOnPlane(body, m_elevation) && CDescribedBodyEngine::IsTouchedBy(body);
}

std::string CPlanarEngine::ExplainRefusal(CEntity& entity) const {
  return ExplainPlanarRefusal(entity, m_elevation);
}

bool CPlanarEngine::Accepts(const CEmbodiedEntity& body) const {
  const SBodyDescription& description = *body.GetBodyDescription();
  return !description.Propellers && !description.Articulation && IsOnPlane(body, m_elevation);
}

void CPlanarEngine::CheckBody(CEmbodiedEntity& body) const {
  CheckPlanarBody(body);
}

void CPlanarEngine::Adopt(CDescribedBodyModel& model) {
  const CEmbodiedEntity& body = model.GetEmbodiedEntity();
  SBodyMotion motion;
  const bool hasMotion = model.GetEngine().GetMotion(body, motion);
  CDescribedBodyEngine::Adopt(model);
  if (hasMotion) {
    SetMotion(model.GetEmbodiedEntity(), motion);
  }
}

void CPlanarEngine::CountTurns(CEmbodiedEntity& body, const SPlanarPose& pose) const {
  body.CountTurns(CVector3(pose.X, pose.Y, m_elevation), GetContext().Arena.Period);
}

SPeriodicity CPlanarEngine::GetPeriod() const {
  SPeriodicity period = GetContext().Arena.Period;
  period.X.Min -= GetFrameOrigin().GetX();
  period.Y.Min -= GetFrameOrigin().GetY();
  return period;
}

const std::vector<SGhostDisc>& CPlanarEngine::ListGhosts() {
  ListGhostDiscs(*this, m_elevation, m_ghostDiscs);
  for (SGhostDisc& disc : m_ghostDiscs) {
    disc.X -= GetFrameOrigin().GetX();
    disc.Y -= GetFrameOrigin().GetY();
  }
  return m_ghostDiscs;
}

}  // namespace argos
