#include <argos3/core/simulator/space/space.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/load_errors.h>
#include <argos3/core/simulator/physics_engine/region_geometry.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/core/simulator/space/distribution.h>
#include <argos3/core/simulator/space/entity_views.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/string_utilities.h>

#include <algorithm>

namespace argos {

namespace {

// where the region is that a body is outside of, if it is the nearest of several
std::string DescribeNearest(const CPhysicsEngine::TVector& engines, const CVector3& position) {
  const auto nearest = *std::min_element(
      engines.begin(), engines.end(), [&position](CPhysicsEngine* a, CPhysicsEngine* b) {
        return a->GetVolume().ComputeDistance(position) < b->GetVolume().ComputeDistance(position);
      });
  const SVolume& region = nearest->GetVolume();
  std::ostringstream text;
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

}  // namespace

CSpace::CSpace(CSimulator& simulator)
    : m_cSimulator(simulator),
      m_views(std::make_unique<CEntityViews>(m_roots)),
      m_bodyIndex(std::make_unique<CBodyIndex>()) {}

CSpace::~CSpace() {
  Destroy();
}

void CSpace::Init(TConfigurationNode& tree) {
  CLoadErrors errors;
  Init(tree, errors);
  errors.ThrowIfAny();
}

void CSpace::Init(TConfigurationNode& tree, CLoadErrors& errors) {
  // the second generator of its category, after the simulator's own
  m_rng = CRandom::CreateRNG("argos");
  if (errors.Try("the arena", [&] { InitArena(tree); })) {
    FillArena(tree, errors);
  }
  m_bodyIndex->Rebuild(m_cSimulator.GetThreadPool());
}

void CSpace::InitArena(TConfigurationNode& tree) {
  GetNodeAttribute(tree, "size", m_arenaSize);
  GetNodeAttributeOrDefault(tree, "center", m_arenaCenter, CVector3());
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (!(m_arenaSize[axis] > 0.0)) {
      THROW_ARGOSEXCEPTION(tree.GetLocation()
                           << ": <arena>: \"size\" must be positive along every axis, found \""
                           << m_arenaSize << "\"");
    }
  }
  // left over from older versions of the file format; files in use have them
  NodeAttributeExists(tree, "positional_index");
  NodeAttributeExists(tree, "positional_grid_size");
  m_arenaLimits.Set(m_arenaCenter - m_arenaSize * 0.5, m_arenaCenter + m_arenaSize * 0.5);
  m_bodyIndex->SetArea(m_arenaLimits);
}

void CSpace::FillArena(TConfigurationNode& tree, CLoadErrors& errors) {
  const std::string distribute = "distribute";
  TConfigurationNodeIterator it;
  for (it = it.begin(&tree); it != it.end(); ++it) {
    if (it->Value() != distribute) {
      errors.Try("", [&] { CreateEntity(*it); });
    }
  }
  for (it = it.begin(&tree); it != it.end(); ++it) {
    if (it->Value() == distribute) {
      errors.Try("", [&] { CDistribution(*this, *it).Place(); });
    }
  }
}

void CSpace::TakeOver(std::unique_ptr<CEntity> entity) {
  try {
    CallEntityOperation<CSpaceOperationAddEntity, CSpace, void>(*this, *entity);
  } catch (...) {
    // the removal forgives what was not added yet, and deletes
    CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(*this, *entity.release());
    throw;
  }
  if (entity->GetIndex() < 0) {
    THROW_ARGOSEXCEPTION("the class of \"" << entity->GetId() << "\" (<"
                                           << entity->GetTypeDescription()
                                           << ">) has no space operations; its source needs a "
                                              "REGISTER_STANDARD_SPACE_OPERATIONS_ON_... line");
  }
  static_cast<void>(entity.release());
}

CEntity& CSpace::CreateEntity(TConfigurationNode& node) {
  std::unique_ptr<CEntity> entity;
  try {
    entity.reset(CFactory<CEntity>::New(node.Value()));
    entity->Init(node);
    CEntity& added = *entity;
    TakeOver(std::move(entity));
    return added;
  } catch (const CAlreadyReported&) {
    throw;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        node.GetLocation() << ": <" << node.Value() << "> cannot be put into the arena", error);
  }
}

void CSpace::InsertEntity(CEntity& entity) {
  if (!entity.HasParent()) {
    const auto [found, inserted] = m_rootById.emplace(entity.GetId(), &entity);
    if (!inserted) {
      TConfigurationNode* other = found->second->GetConfigurationNode();
      THROW_ARGOSEXCEPTION("there is already an entity with id \""
                           << entity.GetId() << "\" (<" << found->second->GetTypeDescription()
                           << ">"
                           << (other != nullptr ? " at " + other->GetLocation() : std::string())
                           << "); ids must be unique");
    }
    m_roots.push_back(&entity);
    entity.MarkStart();
  }
  entity.SetIndex(m_nextIndex++);
  m_views->Add(entity);
}

void CSpace::EraseEntity(CEntity& entity) {
  const std::unique_ptr<CEntity> owned(&entity);
  m_views->Remove(entity);
  if (entity.HasParent()) {
    entity.GetParent().ForgetComponent(entity);
  } else {
    const auto byId = m_rootById.find(entity.GetId());
    if (byId != m_rootById.end() && byId->second == &entity) {
      m_rootById.erase(byId);
      // the last ones go first when everything goes
      m_roots.erase(std::prev(std::find(m_roots.rbegin(), m_roots.rend(), &entity).base()));
    }
  }
  if (m_floor == &entity) {
    m_floor = nullptr;
  }
  entity.Destroy();
}

void CSpace::MarkStart() {
  for (CEntity* root : m_roots) {
    root->MarkStart();
  }
}

void CSpace::Reset() {
  m_simulationClock = 0;
  for (CEntity* root : m_roots) {
    root->ReturnToStart();
  }
  for (CEntity* root : m_roots) {
    root->Reset();
  }
  ReturnBodiesToEngines();
  m_bodyIndex->Rebuild(m_cSimulator.GetThreadPool());
}

// after a Reset() of the entities: as when they were added, each movable body belongs to the first
// engine whose region contains it
void CSpace::ReturnBodiesToEngines() {
  CPhysicsEngine::TVector& engines = m_cSimulator.GetPhysicsEngines();
  if (engines.size() < 2) {
    return;
  }
  m_bodyIndex->ForEachBody([&engines, this](CEmbodiedEntity& body) {
    if (body.GetPhysicsModelsNum() == 0) {
      return;
    }
    if (!body.IsMovable()) {
      RehouseImmovable(body);
      return;
    }
    CPhysicsEngine& now = body.GetPhysicsModel(size_t(0)).GetEngine();
    const CVector3& position = body.GetOriginAnchor().Position;
    const auto first = std::find_if(
        engines.begin(), engines.end(),
        [&position](CPhysicsEngine* engine) { return engine->IsPointContained(position); });
    if (first != engines.end() && *first != &now) {
      // not by a transfer, which may lead through a gate
      now.RemoveEntity(body.GetRootEntity());
      AddEntityToPhysicsEngine(body);
    }
  });
}

void CSpace::Destroy() {
  while (!m_roots.empty()) {
    const size_t before = m_roots.size();
    CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(*this, *m_roots.back());
    if (m_roots.size() == before) {
      // of a class that can be added but not removed
      EraseEntity(*m_roots.back());
    }
  }
  m_views = std::make_unique<CEntityViews>(m_roots);
  m_bodyIndex = std::make_unique<CBodyIndex>();
  m_extensions.clear();
  m_rng = nullptr;
  m_nextIndex = 0;
  m_simulationClock = 0;
}

void CSpace::AddControllableEntity(CControllableEntity& entity) {
  m_robots.push_back(&entity);
}

void CSpace::RemoveControllableEntity(CControllableEntity& entity) {
  const auto found = std::find(m_robots.rbegin(), m_robots.rend(), &entity);
  if (found != m_robots.rend()) {
    m_robots.erase(std::prev(found.base()));
  }
}

void CSpace::AddEntityToPhysicsEngine(CEmbodiedEntity& body) {
  AddEntityToPhysicsEngine(body, nullptr);
}

void CSpace::AddEntityToPhysicsEngine(CEmbodiedEntity& body, CPhysicsEngine* first) {
  const CVector3& position = body.GetOriginAnchor().Position;
  CEntity& root = body.GetRootEntity();
  bool added = first != nullptr && first->AddEntity(root);
  for (CPhysicsEngine* engine : m_cSimulator.GetPhysicsEngines()) {
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
    m_bodyIndex->Add(body);
  }
}

void CSpace::RehouseImmovable(CEmbodiedEntity& body) {
  const CPhysicsEngine::TVector& engines = m_cSimulator.GetPhysicsEngines();
  const auto touches = [&body](CPhysicsEngine* engine) { return engine->IsTouchedBy(body); };
  // one that is put outside all regions stays with its engines
  if (engines.size() < 2 || std::none_of(engines.begin(), engines.end(), touches)) {
    return;
  }
  const auto houses = [&body](const CPhysicsEngine* engine) {
    for (UInt32 i = 0; i < body.GetPhysicsModelsNum(); ++i) {
      if (&body.GetPhysicsModel(size_t(i)).GetEngine() == engine) {
        return true;
      }
    }
    return false;
  };
  // first in, then out: it is always somewhere
  CEntity& root = body.GetRootEntity();
  for (CPhysicsEngine* engine : engines) {
    if (touches(engine) && !houses(engine)) {
      engine->AddEntity(root);
    }
  }
  for (CPhysicsEngine* engine : engines) {
    if (!touches(engine) && houses(engine) && body.GetPhysicsModelsNum() > 1) {
      engine->RemoveEntity(root);
    }
  }
}

void CSpace::ThrowNoEngine(CEmbodiedEntity& body) {
  m_cSimulator.ThrowIfBroken("physics_engines");
  const CVector3& position = body.GetOriginAnchor().Position;
  CEntity& root = body.GetRootEntity();
  std::string reasons;
  std::string elsewhere;
  CPhysicsEngine::TVector others;
  for (CPhysicsEngine* engine : m_cSimulator.GetPhysicsEngines()) {
    const std::string id = "\"" + engine->GetId() + "\"";
    if (engine->IsPointContained(position)) {
      reasons += "; " + id + " " + engine->ExplainRefusal(root);
    } else {
      elsewhere += (elsewhere.empty() ? "" : ", ") + id;
      others.push_back(engine);
    }
  }
  if (!elsewhere.empty()) {
    reasons += "; it is outside the region (<boundaries>) of " + elsewhere +
               DescribeNearest(others, position);
  }
  THROW_ARGOSEXCEPTION("no physics engine takes \""
                       << root.GetId() << "\" (<" << root.GetTypeDescription() << ">) at ("
                       << position << ")"
                       << (reasons.empty() ? "; there is none in <physics_engines>" : reasons));
}

void CSpace::RemoveEntityFromPhysicsEngines(CEmbodiedEntity& body) {
  while (body.GetPhysicsModelsNum() > 0) {
    CPhysicsEngine& engine = body.GetPhysicsModel(body.GetPhysicsModelsNum() - 1).GetEngine();
    if (!engine.RemoveEntity(body.GetRootEntity())) {
      break;
    }
  }
  if (body.GetBodyNumber() != CBodyIndex::kNoBody) {
    m_bodyIndex->Remove(body.GetBodyNumber());
  }
}

CRandom::CRNG& CSpace::GetRNG() {
  if (m_rng == nullptr) {
    THROW_ARGOSEXCEPTION("the space has no random generator before the arena is initialised");
  }
  return *m_rng;
}

UInt64 CSpace::ComputeDigest() const {
  CDigest digest;
  digest.Add(m_simulationClock);
  for (const CEntity* root : m_roots) {
    digest.Add(root->GetId());
    root->UpdateDigest(digest);
  }
  for (const CMedium* medium : m_cSimulator.GetMedia()) {
    medium->UpdateDigest(digest);
  }
  return digest.GetValue();
}

}  // namespace argos
