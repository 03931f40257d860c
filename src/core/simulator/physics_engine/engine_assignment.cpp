#include <argos3/core/simulator/physics_engine/engine_assignment.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/region_geometry.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/text/classic_locale.h>
#include <argos3/core/utility/text/lists.h>

#include <algorithm>
#include <sstream>

namespace argos {

namespace {

// describes the region nearest to a position outside of all of them
std::string DescribeNearest(const CPhysicsEngine::TVector& engines, const CVector3& position) {
  const auto nearest = *std::min_element(
      engines.begin(), engines.end(), [&position](CPhysicsEngine* a, CPhysicsEngine* b) {
        return a->GetVolume().ComputeDistance(position) < b->GetVolume().ComputeDistance(position);
      });
  const SVolume& region = nearest->GetVolume();
  CTextOutput text;
  text << (engines.size() > 1 ? "; the nearest is that of \"" + nearest->GetId() + "\"," : ",")
       << " " << region.ComputeDistance(position) << " m away";
  const TPolygon corners = region.GetCorners();
  if (!corners.empty()) {
    text << ", with the corners " << ListCorners(corners);
  }
  if (region.BottomFace != nullptr || region.TopFace != nullptr) {
    text << ", from z = " << region.GetLowest() << " to " << region.GetHighest() << " m";
  }
  return text.str();
}

bool IsIn(CEmbodiedEntity& body, const CPhysicsEngine& engine) {
  for (UInt32 i = 0; i < body.GetPhysicsModelsNum(); ++i) {
    if (&body.GetPhysicsModel(size_t(i)).GetEngine() == &engine) {
      return true;
    }
  }
  return false;
}

}  // namespace

void CEngineAssignment::Add(CEmbodiedEntity& body, CPhysicsEngine* first) const {
  body.WrapIntoArena();
  const CVector3& position = body.GetOriginAnchor().Position;
  CEntity& root = body.GetRootEntity();
  bool added = first != nullptr && first->AddEntity(root);
  for (CPhysicsEngine* engine : m_context.Engines) {
    if (added && body.IsMovable()) {
      break;
    }
    if (engine != first &&
        (body.IsMovable() ? engine->IsPointContained(position) : engine->IsTouchedBy(body))) {
      added = engine->AddEntity(root) || added;
    }
  }
  if (!added) {
    ThrowNoEngine(body);
  }
  if (body.GetBodyDescription() != nullptr && body.GetBodyNumber() == CBodyIndex::kNoBody) {
    body.EnterIndex(*m_context.Index);
  }
}

void CEngineAssignment::Remove(CEmbodiedEntity& body) const {
  while (body.GetPhysicsModelsNum() > 0) {
    CPhysicsEngine& engine = body.GetPhysicsModel(body.GetPhysicsModelsNum() - 1).GetEngine();
    if (!engine.RemoveEntity(body.GetRootEntity())) {
      break;
    }
  }
  body.LeaveIndex();
}

void CEngineAssignment::ReassignImmovable(CEmbodiedEntity& body) const {
  const CPhysicsEngine::TVector& engines = m_context.Engines;
  const auto touches = [&body](CPhysicsEngine* engine) { return engine->IsTouchedBy(body); };
  // a body outside all regions stays in its engines
  if (engines.size() < 2 || std::none_of(engines.begin(), engines.end(), touches)) {
    return;
  }
  // added before it is removed: the body is always in some engine
  CEntity& root = body.GetRootEntity();
  for (CPhysicsEngine* engine : engines) {
    if (touches(engine) && !IsIn(body, *engine)) {
      engine->AddEntity(root);
    }
  }
  for (CPhysicsEngine* engine : engines) {
    if (!touches(engine) && IsIn(body, *engine) && body.GetPhysicsModelsNum() > 1) {
      engine->RemoveEntity(root);
    }
  }
}

bool CEngineAssignment::BelongsToAnother(const CEmbodiedEntity& body,
                                         CPhysicsEngine& engine) const {
  const CVector3& position = body.GetOriginAnchor().Position;
  const CPhysicsEngine::TVector& engines = m_context.Engines;
  return engine.IsEntityTransferActive() && !engine.IsPointContained(position) &&
         std::any_of(engines.begin(), engines.end(), [&position](CPhysicsEngine* other) {
           return other->IsPointContained(position);
         });
}

void CEngineAssignment::ReturnAll() const {
  if (m_context.Engines.size() < 2) {
    return;
  }
  m_context.Index->ForEachBody([this](CEmbodiedEntity& body) {
    if (body.GetPhysicsModelsNum() > 0) {
      Return(body);
    }
  });
}

void CEngineAssignment::Return(CEmbodiedEntity& body) const {
  if (!body.IsMovable()) {
    ReassignImmovable(body);
    return;
  }
  CPhysicsEngine& now = body.GetPhysicsModel(size_t(0)).GetEngine();
  const CVector3& position = body.GetOriginAnchor().Position;
  const CPhysicsEngine::TVector& engines = m_context.Engines;
  const auto first = std::ranges::find_if(
      engines, [&position](CPhysicsEngine* engine) { return engine->IsPointContained(position); });
  if (first != engines.end() && *first != &now) {
    // it is no transfer, which may lead through a gate
    now.RemoveEntity(body.GetRootEntity());
    Add(body);
  }
}

void CEngineAssignment::ThrowNoEngine(CEmbodiedEntity& body) const {
  m_context.Loading.ThrowIfBroken("physics_engines");
  const CVector3& position = body.GetOriginAnchor().Position;
  CEntity& root = body.GetRootEntity();
  std::string reasons;
  std::string elsewhere;
  CPhysicsEngine::TVector others;
  for (CPhysicsEngine* engine : m_context.Engines) {
    const std::string id = "\"" + engine->GetId() + "\"";
    if (engine->IsPointContained(position)) {
      reasons += "; " + id + " " + engine->ExplainRefusal(root);
    } else {
      AppendItem(elsewhere, id);
      others.push_back(engine);
    }
  }
  if (!elsewhere.empty()) {
    reasons += "; it is outside the region (<boundaries>) of " + elsewhere +
               DescribeNearest(others, position);
  }
  THROW_ARGOSEXCEPTION("no physics engine accepts \""
                       << root.GetId() << "\" (<" << root.GetTypeDescription() << ">) at ("
                       << position << ")"
                       << (reasons.empty() ? "; there is none in <physics_engines>" : reasons));
}

}  // namespace argos
