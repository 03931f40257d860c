#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/region_geometry.h>
#include <argos3/core/simulator/physics_engine/engine_assignment.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m; immovable bodies this near to a region are added to its engine, because its bodies reach over
// the border by their radius and by their path in a tick
constexpr Real kReachOverBorder = CBodyIndex::kMaxSmallRadius;

}  // namespace

// Factories create engines without arguments, so the base class takes the thread's simulator.
CPhysicsEngine::CPhysicsEngine()
    : m_cSimulator(CurrentSimulator()), m_cSpace(CurrentSpace()), m_context(CurrentContext()) {
  SetIterations(m_iterations);
}

void CPhysicsEngine::Init(TConfigurationNode& tree) {
  GetNodeAttribute(tree, "id", m_id);
  m_origin = tree.GetLocation() + ": <" + tree.Value() + " id=\"" + m_id + "\">";
  UInt32 iterations = m_iterations;
  GetNodeAttributeOrDefault(tree, "iterations", iterations, m_iterations);
  if (iterations == 0) {
    THROW_ARGOSEXCEPTION(m_origin << ": \"iterations\" must be at least 1, found 0");
  }
  SetIterations(iterations);
  if (NodeExists(tree, "boundaries")) {
    m_volume.Init(GetNode(tree, "boundaries"));
    if (m_volume.HasWalls() && !StopsAtWalls()) {
      THROW_ARGOSEXCEPTION(m_origin << ": an engine of this type cannot stop bodies at a face with "
                                       "wall=\"true\"; put an immovable <box> there");
    }
  }
  m_feelsGhosts = CanFeelGhosts();
  if (m_feelsGhosts) {
    GetNodeAttributeOrDefault(tree, "ghosts", m_feelsGhosts, m_feelsGhosts);
  }
}

void CPhysicsEngine::SetIterations(UInt32 iterations) {
  m_iterations = iterations;
  m_physicsClockTick = m_context.TickLength / m_iterations;
}

CEngineAssignment CPhysicsEngine::GetAssignment() const {
  return CEngineAssignment(m_context);
}

bool CPhysicsEngine::IsPointContained(const CVector3& point) {
  return m_volume.Contains(point);
}

bool CPhysicsEngine::IsTouchedBy(const CEmbodiedEntity& body) {
  const SAnchor& origin = body.GetOriginAnchor();
  if (IsPointContained(origin.Position)) {
    return true;
  }
  return body.GetBodyDescription() != nullptr &&
         m_volume.IsTouchedBy(*body.GetBodyDescription(), origin.Position, origin.Orientation,
                              kReachOverBorder);
}

std::pair<Real, Real> CPhysicsEngine::GetHeightSpan() const {
  return {m_volume.GetLowest(), m_volume.GetHighest()};
}

std::string CPhysicsEngine::ExplainRefusal(CEntity& entity) const {
  return "does not accept a <" + entity.GetTypeDescription() + ">";
}

void CPhysicsEngine::ScheduleEntityForTransfer(CEmbodiedEntity& entity) {
  if (m_transfers.capacity() == 0) {
    // more transfers in one tick are rare
    m_transfers.reserve(64 + GetNumPhysicsModels() / 4);
  }
  m_transfers.push_back(&entity);
}

void CPhysicsEngine::TransferEntities() {
  std::sort(m_transfers.begin(), m_transfers.end(), SEntityComparator());
  for (CEmbodiedEntity* body : m_transfers) {
    TransferEntity(*body);
  }
  m_transfers.clear();
}

void CPhysicsEngine::TransferEntity(CEmbodiedEntity& body) {
  SBodyMotion motion;
  const bool hasMotion = GetMotion(body, motion);
  CPhysicsEngine* const behindGate = FindEngineBehindGate(body);
  if (!RemoveEntity(body.GetRootEntity())) {
    return;
  }
  GetAssignment().Add(body, behindGate);
  if (hasMotion) {
    body.GetPhysicsModel(size_t(0)).GetEngine().SetMotion(body, motion);
  }
}

CPhysicsEngine* CPhysicsEngine::FindEngineBehindGate(const CEmbodiedEntity& body) const {
  const CVector3& position = body.GetOriginAnchor().Position;
  const SFace* const exit = m_volume.FindExit(position);
  if (exit == nullptr || exit->Gate.empty()) {
    return nullptr;
  }
  for (CPhysicsEngine* engine : m_context.Engines) {
    if (engine->GetId() == exit->Gate) {
      return engine->IsPointContained(position) ? engine : nullptr;
    }
  }
  return nullptr;
}

const CPhysicsEngine::TVector& CPhysicsEngine::GetAllEngines() const {
  return m_context.Engines;
}

bool CPhysicsEngine::ContainsOriginOf(const CEmbodiedEntity& body) {
  return IsPointContained(body.GetOriginAnchor().Position);
}

// The index has the poses of all bodies at the end of the last tick, so at the start of this one.
void CPhysicsEngine::CollectGhosts() {
  const Real reach = GetGhostReach();
  const CBodyIndex& index = *m_context.Index;
  m_nearBorder.clear();
  ListNearBorders(reach);
  ListNearStrays(reach);
  // a body may be near two borders, and have several solids
  std::sort(m_nearBorder.begin(), m_nearBorder.end());
  m_nearBorder.erase(std::unique(m_nearBorder.begin(), m_nearBorder.end()), m_nearBorder.end());
  m_ghosts.clear();
  for (const UInt32 number : m_nearBorder) {
    CEmbodiedEntity& body = index.GetBody(number);
    if (body.IsMovable() && body.GetPhysicsModelsNum() > 0 &&
        &body.GetPhysicsModel(size_t(0)).GetEngine() != this) {
      const SAnchor& origin = body.GetOriginAnchor();
      const SBodyDescription& description = *body.GetBodyDescription();
      m_ghosts.push_back({&body, origin.Position, origin.Orientation,
                          !description.HasDrive() && !description.Propellers});
    }
  }
}

// Appends the numbers of bodies near the borders to m_nearBorder.
void CPhysicsEngine::ListNearBorders(Real reach) {
  for (const CRay2& border : m_borders) {
    const CVector2& start = border.GetStart();
    const CVector2& end = border.GetEnd();
    const CRay3 ray(CVector3(start.GetX(), start.GetY(), 0.0),
                    CVector3(end.GetX(), end.GetY(), 0.0));
    const Real length = border.GetLength();
    CVector2 along;
    border.GetDirection(along);
    m_context.Index->ForShapesAlongRay(ray, {reach, HUGE_VAL}, [&](const SIndexedShape& shape) {
      const CVector2 offset(shape.X - start.GetX(), shape.Y - start.GetY());
      const Real far = reach + shape.Radius;
      const Real place = along.DotProduct(offset);
      const bool isNear =
          std::abs(along.CrossProduct(offset)) <= far && place >= -far && place <= length + far;
      // a large shape may be visited several times in a row
      if (isNear && (m_nearBorder.empty() || m_nearBorder.back() != shape.Body)) {
        m_nearBorder.push_back(shape.Body);
      }
    });
  }
}

// The same for bodies near those of this engine that are outside of its region, and for bodies of
// other engines that are outside of theirs. A body may have been moved back since it was listed.
void CPhysicsEngine::ListNearStrays(Real reach) {
  for (const CEmbodiedEntity* stray : m_strays) {
    if (ContainsOriginOf(*stray)) {
      continue;
    }
    const SBoundingBox& box = stray->GetBoundingBox();
    m_context.Index->ForShapesInArea(
        {box.MinCorner.GetX() - reach, box.MinCorner.GetY() - reach, box.MaxCorner.GetX() + reach,
         box.MaxCorner.GetY() + reach},
        [this](const SIndexedShape& shape) { m_nearBorder.push_back(shape.Body); });
  }
  for (CPhysicsEngine* other : m_context.Engines) {
    for (const CEmbodiedEntity* stray : other->m_strays) {
      if (other != this && !other->ContainsOriginOf(*stray)) {
        m_nearBorder.push_back(stray->GetBodyNumber());
      }
    }
  }
}

Real CPhysicsEngine::GetSimulationClockTick() {
  return CurrentContext().TickLength;
}

Real CPhysicsEngine::GetInverseSimulationClockTick() {
  return 1.0 / GetSimulationClockTick();
}

void CPhysicsEngine::SetSimulationClockTick(Real seconds) {
  if (!(seconds > 0.0)) {
    THROW_ARGOSEXCEPTION("the length of a tick must be positive, got " << seconds << " s");
  }
  CurrentContext().TickLength = seconds;
}

namespace {

// Bodies that are known to their engine only, if any engine has such bodies.
void AppendHitsOutsideIndex(TEmbodiedEntityIntersectionData& data, const CRay3& ray) {
  size_t numKept = data.size();
  for (const CPhysicsEngine* engine : CurrentContext().Engines) {
    if (engine->HasBodiesOutsideIndex()) {
      engine->CheckIntersectionWithRay(data, ray);
    }
  }
  // an engine may also report a body that the index has found, or that is in several engines
  for (size_t i = numKept; i < data.size(); ++i) {
    const CEmbodiedEntity* const body = data[i].IntersectedEntity;
    const bool isKnown =
        body->GetBodyNumber() != CBodyIndex::kNoBody ||
        std::any_of(data.begin(), data.begin() + static_cast<std::ptrdiff_t>(numKept),
                    [body](const auto& hit) { return hit.IntersectedEntity == body; });
    if (!isKnown) {
      data[numKept++] = data[i];
    }
  }
  data.resize(numKept);
}

bool FindClosest(SEmbodiedEntityIntersectionItem& item, const CRay3& ray,
                 const CEmbodiedEntity* ignored) {
  bool found = CurrentContext().Index->FindClosestHit(item, ray, ignored);
  TEmbodiedEntityIntersectionData others;
  AppendHitsOutsideIndex(others, ray);
  for (const SEmbodiedEntityIntersectionItem& other : others) {
    if (other.IntersectedEntity != ignored && (!found || other.TOnRay < item.TOnRay)) {
      item = other;
      found = true;
    }
  }
  return found;
}

}  // namespace

bool GetEmbodiedEntitiesIntersectedByRay(TEmbodiedEntityIntersectionData& data, const CRay3& ray) {
  data.clear();
  CurrentContext().Index->FindAllHits(data, ray);
  AppendHitsOutsideIndex(data, ray);
  return !data.empty();
}

bool GetClosestEmbodiedEntityIntersectedByRay(SEmbodiedEntityIntersectionItem& item,
                                              const CRay3& ray) {
  return FindClosest(item, ray, nullptr);
}

bool GetClosestEmbodiedEntityIntersectedByRay(SEmbodiedEntityIntersectionItem& item,
                                              const CRay3& ray, CEmbodiedEntity& ignored) {
  return FindClosest(item, ray, &ignored);
}

}  // namespace argos
