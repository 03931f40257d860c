#include <argos3/plugins/simulator/media/line_of_sight.h>

#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/space.h>

#include <algorithm>

namespace argos {

CLineOfSight::CLineOfSight(CSpace& space) : m_index(space.GetBodyIndex()) {
  for (const CPhysicsEngine* engine : space.GetContext().Engines) {
    if (engine->HasBodiesOutsideIndex()) {
      m_engines.push_back(engine);
    }
  }
}

CLineOfSight::SEnd CLineOfSight::MakeEnd(const CEmbodiedEntity& body) {
  return {&body, body.GetBodyNumber()};
}

bool CLineOfSight::IsClear(const CRay3& segment, const SEnd& start, const SEnd& end) const {
  if (start.Body == end.Body) {
    return true;
  }
  return !m_index.IsBlocked(segment, start.Number, end.Number) &&
         (m_engines.empty() || IsClearOutsideIndex(segment, start.Body, end.Body));
}

// hits are where the ray enters a body: those before the body at the end occlude it
bool CLineOfSight::IsClearOutsideIndex(const CRay3& segment, const CEmbodiedEntity* start,
                                       const CEmbodiedEntity* end) const {
  TEmbodiedEntityIntersectionData hits;
  for (const CPhysicsEngine* engine : m_engines) {
    engine->CheckIntersectionWithRay(hits, segment);
  }
  Real last = 1.0;
  for (const SEmbodiedEntityIntersectionItem& hit : hits) {
    if (hit.IntersectedEntity == end) {
      last = std::min(last, hit.TOnRay);
    }
  }
  return std::none_of(hits.begin(), hits.end(), [&](const SEmbodiedEntityIntersectionItem& hit) {
    const CEmbodiedEntity* const body = hit.IntersectedEntity;
    return body != start && body != end && body->GetBodyNumber() == CBodyIndex::kNoBody &&
           hit.TOnRay <= last;
  });
}

}  // namespace argos
