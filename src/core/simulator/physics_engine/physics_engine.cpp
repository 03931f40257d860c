#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <argos3/core/simulator/current.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/body_index.h>

#include <algorithm>

namespace argos {

// engines are made by zero-argument factories: the base picks up the thread's simulator once
CPhysicsEngine::CPhysicsEngine()
    : m_cSimulator(CurrentSimulator()), m_cSpace(m_cSimulator.GetSpace()) {
  SetIterations(m_iterations);
}

void CPhysicsEngine::Init(TConfigurationNode& tree) {
  GetNodeAttribute(tree, "id", m_id);
  UInt32 iterations = m_iterations;
  GetNodeAttributeOrDefault(tree, "iterations", iterations, m_iterations);
  if (iterations == 0) {
    THROW_ARGOSEXCEPTION(tree.GetLocation() << ": <" << tree.Value() << " id=\"" << m_id
                                            << "\">: \"iterations\" must be at least 1, found 0");
  }
  SetIterations(iterations);
  if (NodeExists(tree, "boundaries")) {
    m_volume.Init(GetNode(tree, "boundaries"));
  }
}

void CPhysicsEngine::SetIterations(UInt32 iterations) {
  m_iterations = iterations;
  m_physicsClockTick = m_cSimulator.GetTickLength() / m_iterations;
}

bool CPhysicsEngine::IsPointContained(const CVector3& point) {
  return m_volume.Contains(point);
}

std::string CPhysicsEngine::ExplainRefusal(CEntity& entity) const {
  return "cannot house a <" + entity.GetTypeDescription() + ">";
}

void CPhysicsEngine::ScheduleEntityForTransfer(CEmbodiedEntity& entity) {
  if (m_transfers.capacity() == 0) {
    // more than that in one tick are rare
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
  if (RemoveEntity(body.GetRootEntity())) {
    m_cSpace.AddEntityToPhysicsEngine(body);
  }
}

Real CPhysicsEngine::GetSimulationClockTick() {
  return CurrentSimulator().GetTickLength();
}

Real CPhysicsEngine::GetInverseSimulationClockTick() {
  return 1.0 / GetSimulationClockTick();
}

void CPhysicsEngine::SetSimulationClockTick(Real seconds) {
  if (!(seconds > 0.0)) {
    THROW_ARGOSEXCEPTION("the length of a tick must be positive, got " << seconds << " s");
  }
  CurrentSimulator().m_tickLength = seconds;
}

namespace {

// bodies that only their engine knows, if any engine has such
void AppendHitsOutsideIndex(TEmbodiedEntityIntersectionData& data, const CRay3& ray) {
  size_t numKept = data.size();
  for (const CPhysicsEngine* engine : CurrentSimulator().GetPhysicsEngines()) {
    if (engine->HasBodiesOutsideIndex()) {
      engine->CheckIntersectionWithRay(data, ray);
    }
  }
  // an engine may also report what the index has found, or a body that several engines house
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
  bool found = CurrentSpace().GetBodyIndex().FindClosestHit(item, ray, ignored);
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
  CurrentSpace().GetBodyIndex().FindAllHits(data, ray);
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
