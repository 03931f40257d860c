#include <argos3/core/simulator/space/space.h>

#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/context/simulation_context.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/entity/entity_type.h>
#include <argos3/core/simulator/entity/floor_entity.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/geometry/pose_check.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/physics_engine/engine_assignment.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/space/entity_views.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/robot_records.h>
#include <argos3/core/simulator/space/root_places.h>
#include <argos3/core/utility/datatypes/digest.h>
#include <argos3/core/utility/datatypes/while_true.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/running_code.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_order.h>
#include <argos3/core/utility/plugins/unknown_label.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace argos {

namespace {

// outside of ticks a record that cannot be used is an error of the caller
void TakeRecords(CMetrics& metrics, const std::function<const CEntity&(size_t)>& getRobot) {
  const std::vector<CMetrics::SFailure>& failures = metrics.TakeRobotRecords();
  if (!failures.empty()) {
    try {
      std::rethrow_exception(failures.front().Error);
    } catch (...) {
      ThrowWithCause("robot \"" + getRobot(failures.front().Robot).GetId() + "\" failed");
    }
  }
}

// gives those items of a list whose roots have places the order of these
template <typename ITEM, typename ROOT_OF>
void Reorder(std::vector<ITEM*>& list, const CRootPlaces& places, ROOT_OF&& rootOf) {
  struct SMoved {
    size_t Place;
    ITEM* Item;
  };
  std::vector<SMoved> moved;
  std::vector<size_t> slots;  // places in the list
  for (size_t i = 0; i < list.size(); ++i) {
    const size_t place = places.Find(rootOf(*list[i]));
    if (place < places.GetSize()) {
      moved.push_back({place, list[i]});
      slots.push_back(i);
    }
  }
  std::ranges::stable_sort(moved, {}, &SMoved::Place);
  for (size_t i = 0; i < moved.size(); ++i) {
    list[slots[i]] = moved[i].Item;
  }
}

// which sides of the arena are joined, from an attribute such as "x,y"
SPeriodicity ReadPeriodicity(TConfigurationNode& tree, const SArena& arena) {
  SPeriodicity period;
  std::string axes;
  GetNodeAttributeOrDefault(tree, "periodic", axes, std::string("false"));
  if (axes == "false") {
    return period;
  }
  const bool isBoth = axes == "true" || axes == "x,y" || axes == "y,x";
  if (!isBoth && axes != "x" && axes != "y") {
    THROW_ARGOSEXCEPTION(tree.GetLocation()
                         << ": <arena>: \"periodic\" must be \"true\", \"false\", \"x\", \"y\" or "
                            "\"x,y\", found \""
                         << axes << '"');
  }
  if (axes != "y") {
    period.X = {arena.Limits.GetMin().GetX(), arena.Size.GetX()};
  }
  if (axes != "x") {
    period.Y = {arena.Limits.GetMin().GetY(), arena.Size.GetY()};
  }
  return period;
}

}  // namespace

CSpace::CSpace(SSimulationContext& context)
    : m_context(context),
      m_views(std::make_unique<CEntityViews>(m_roots)),
      m_bodyIndex(std::make_unique<CBodyIndex>()) {
  m_context.Index = m_bodyIndex.get();
  m_context.Clock = &m_simulationClock;
}

CSpace::~CSpace() = default;

void CSpace::Init(TConfigurationNode& tree) {
  SArena& arena = m_context.Arena;
  GetNodeAttribute(tree, "size", arena.Size);
  GetNodeAttributeOrDefault(tree, "center", arena.Center, CVector3());
  for (UInt32 axis = 0; axis < 3; ++axis) {
    // files for robots on the ground have arenas without a height
    const bool isFlat = axis == 2 && arena.Size.GetZ() == 0.0;
    if (!isFlat && !(arena.Size[axis] > 0.0 && arena.Size[axis] <= kMaxCoordinate)) {
      THROW_ARGOSEXCEPTION(tree.GetLocation()
                           << ": <arena>: \"size\" must be positive along both axes of the ground, "
                              "not negative along Z, and at most "
                           << kMaxCoordinate << " m, found \"" << arena.Size << "\"");
    }
    if (!(std::abs(arena.Center[axis]) <= kMaxCoordinate)) {
      THROW_ARGOSEXCEPTION(tree.GetLocation()
                           << ": <arena>: \"center\" must be at most " << kMaxCoordinate
                           << " m from the origin, found \"" << arena.Center << "\"");
    }
  }
  // attributes of older versions of the file format: accepted, without effect
  for (const char* attribute : {"positional_index", "positional_grid_size"}) {
    if (NodeAttributeExists(tree, attribute)) {
      LOGERR << "[WARNING] " << tree.GetLocation() << ": <arena>: attribute \"" << attribute
             << "\" has no effect: bodies have an index that needs no parameters, and each medium "
                "has its own attributes \"index\" and \"grid_size\""
             << std::endl;
    }
  }
  arena.Limits.Set(arena.Center - arena.Size * 0.5, arena.Center + arena.Size * 0.5);
  arena.Period = ReadPeriodicity(tree, arena);
  m_bodyIndex->SetArea(arena.Limits, arena.Period);
}

void CSpace::SetSimulationClock(UInt32 ticks) {
  CRobotsCode::CheckShared("CSpace::SetSimulationClock()");
  m_simulationClock = ticks;
}

const CVector3& CSpace::GetArenaSize() const {
  return m_context.Arena.Size;
}

void CSpace::SetArenaSize(const CVector3& size) {
  CRobotsCode::CheckShared("CSpace::SetArenaSize()");
  m_context.Arena.Size = size;
}

const CVector3& CSpace::GetArenaCenter() const {
  return m_context.Arena.Center;
}

void CSpace::SetArenaCenter(const CVector3& center) {
  CRobotsCode::CheckShared("CSpace::SetArenaCenter()");
  m_context.Arena.Center = center;
}

const CRange<CVector3>& CSpace::GetArenaLimits() const {
  return m_context.Arena.Limits;
}

CSimulator& CSpace::GetSimulator() {
  return m_context.Simulator;
}

void CSpace::AddEntityType(const std::string& tag, std::unique_ptr<CEntityType> type) {
  CheckMayChange();
  if (HasEntityType(tag) || tag == "distribute") {
    THROW_ARGOSEXCEPTION("there are already entities <" << tag << ">: another id is needed");
  }
  ARGOS_ASSERT(type != nullptr, "<" << tag << "> has no type of entities");
  m_entityTypes[tag] = std::move(type);
}

bool CSpace::HasEntityType(const std::string& tag) const {
  return m_entityTypes.count(tag) > 0 || CFactory<CEntity>::Exists(tag);
}

std::vector<std::string> CSpace::GetEntityTypes() const {
  std::vector<std::string> tags = CFactory<CEntity>::GetLabels();
  for (const auto& [tag, type] : m_entityTypes) {
    tags.push_back(tag);
  }
  return tags;
}

std::unique_ptr<CEntity> CSpace::MakeEntity(const std::string& tag) const {
  const auto found = m_entityTypes.find(tag);
  if (found != m_entityTypes.end()) {
    return found->second->New();
  }
  if (!m_entityTypes.empty() && !CFactory<CEntity>::Exists(tag)) {
    THROW_ARGOSEXCEPTION("there is no entity \"" << tag << '"'
                                                 << DescribeUnknownLabel(tag, GetEntityTypes()));
  }
  return std::unique_ptr<CEntity>(CFactory<CEntity>::New(tag));
}

void CSpace::TryEntity(TConfigurationNode& node) {
  CheckMayChange();
  // initialises robots without their controllers
  m_context.Loading.SetProbing(true);
  try {
    LoadLibraryOf(node);
    const std::unique_ptr<CEntity> entity = MakeEntity(node.Value());
    entity->Init(node);
    entity->Destroy();
    m_context.Loading.SetProbing(false);
  } catch (const CAlreadyReported&) {
    m_context.Loading.SetProbing(false);
    throw;
  } catch (...) {
    m_context.Loading.SetProbing(false);
    ThrowWithCause(node.GetLocation() + ": <" + node.Value() + "> cannot be put into the arena");
  }
}

CEntity& CSpace::CreateEntity(TConfigurationNode& node) {
  std::unique_ptr<CEntity> entity;
  try {
    LoadLibraryOf(node);
    entity = MakeEntity(node.Value());
    entity->Init(node);
    CEntity& added = *entity;
    Adopt(std::move(entity));
    return added;
  } catch (const CAlreadyReported&) {
    throw;
  } catch (...) {
    ThrowWithCause(node.GetLocation() + ": <" + node.Value() + "> cannot be put into the arena");
  }
}

void CSpace::OrderRoots(const std::vector<ssize_t>& indices) {
  CheckMayChange();
  const CRootPlaces places(indices);
  Reorder(m_roots, places, [](const CEntity& root) -> const CEntity& { return root; });
  Reorder(m_robots, places,
          [](CControllableEntity& robot) -> const CEntity& { return robot.GetRootEntity(); });
  ++m_robotsVersion;
  m_views->NoticeOrder();
}

void CSpace::ReserveRoots(size_t number) {
  CheckMayChange();
  const size_t size = m_roots.size() + number;
  m_roots.reserve(size);
  m_robots.reserve(size);
  m_rootById.reserve(size);
}

void CSpace::ForRootsAsCreated(const std::function<void(CEntity&, size_t)>& visit) const {
  struct SRoot {
    ssize_t Index;
    size_t Place;
    CEntity* Entity;
  };
  std::vector<SRoot> roots;
  roots.reserve(m_roots.size());
  for (CEntity* root : m_roots) {
    roots.push_back({root->GetIndex(), roots.size(), root});
  }
  if (!std::ranges::is_sorted(roots, {}, &SRoot::Index)) {
    std::ranges::sort(roots, {}, &SRoot::Index);
  }
  for (const SRoot& root : roots) {
    visit(*root.Entity, root.Place);
  }
}

void CSpace::InsertEntity(CEntity& entity) {
  if (!entity.HasParent()) {
    CheckMayChange();
    // the id is not taken yet: what follows must not fail for lack of memory
    if (m_roots.size() == m_roots.capacity()) {
      m_roots.reserve(2 * m_roots.size() + 1);
    }
    const auto [found, inserted] = m_rootById.try_emplace(entity.GetId(), nullptr);
    if (!inserted) {
      TConfigurationNode* other = found->second->GetConfigurationNode();
      THROW_ARGOSEXCEPTION("there is already an entity with id \""
                           << entity.GetId() << "\" (<" << found->second->GetTypeDescription()
                           << ">"
                           << (other != nullptr ? " at " + other->GetLocation() : std::string())
                           << "); ids must be unique");
    }
    ARGOS_ASSERT(m_roots.size() < m_roots.capacity(), "the list of entities would allocate here");
    m_roots.push_back(&entity);
    found->second.reset(&entity);
    entity.MarkStart();
  }
  entity.SetIndex(m_nextIndex++);
  m_views->Add(entity);
}

void CSpace::EraseEntity(CEntity& entity) {
  CheckMayChange();
  m_views->Remove(entity);
  std::unique_ptr<CEntity> owned;
  const auto byId = m_rootById.find(entity.GetId());
  if (!entity.HasParent() && byId != m_rootById.end() && byId->second.get() == &entity) {
    owned = std::move(byId->second);
    m_rootById.erase(byId);
    // searched from the end, because Destroy() removes the last entity first
    m_roots.erase(std::prev(std::find(m_roots.rbegin(), m_roots.rend(), &entity).base()));
  } else {
    // a component, which its parent releases, or a root that was rejected
    owned.reset(&entity);
    if (entity.HasParent()) {
      entity.GetParent().ForgetComponent(entity);
    }
  }
  if (m_floor == &entity) {
    m_floor = nullptr;
  }
  entity.Destroy();
}

void CSpace::MarkStart() {
  ForRootsAsCreated([](CEntity& root, size_t) {
    root.MarkStart();
    root.MarkStartValues();
  });
}

void CSpace::Reset() {
  Reset({});
}

void CSpace::Reset(const std::function<void()>& place) {
  m_context.Run.CheckIsNotInPhase("CSpace::Reset()",
                                  "CSimulator::Reset() is possible between ticks");
  if (m_context.EndRun) {
    m_context.EndRun();
  }
  m_simulationClock = 0;
  {
    const CWhileTrue resetting(m_context.IsSpaceResetting);
    ResetEntities(place);
  }
  m_context.Run.ApplyChanges();
  m_context.RobotFailures.Report();
  TakeBackQuarantined();
  CEngineAssignment(m_context).ReturnAll();
  for (CPhysicsEngine* engine : m_context.Engines) {
    engine->Reset();
  }
  m_bodyIndex->Rebuild(*m_context.Pool);
}

void CSpace::ResetEntities(const std::function<void()>& place) {
  for (CEntity* root : m_roots) {
    root->ReturnToStart();
  }
  if (place) {
    place();
  }
  {
    // Reset() of users' controllers
    const CRunState::CScope scope(m_context.Run, CRunState::EActivity::Phase);
    CMetrics& metrics = GetExtension<CMetrics>();
    metrics.GetRobotRecords().Begin(m_roots.size(), 1);
    {
      CRobotRecords::CScope records(metrics.GetRobotRecords(), 0);
      for (size_t i = 0; i < m_roots.size(); ++i) {
        CARGoSLog::SetSequence(CARGoSLog::GetSequence() + 1);
        records.SetRobot(i);
        m_roots[i]->Reset();
      }
    }
    TakeRecords(metrics, [this](size_t root) -> const CEntity& { return *m_roots[root]; });
  }
}

void CSpace::Destroy() {
  m_context.Run.CheckIsNotInPhase("CSpace::Destroy()",
                                  "CSimulator::Terminate() ends the run after this tick");
  const CRunState::CScope scope(m_context.Run, CRunState::EActivity::Destroying);
  // limit for one root; a removal that has failed this often never succeeds
  constexpr size_t kMaxFailures = 1000;
  std::exception_ptr failure;
  size_t numFailures = 0;
  size_t numMore = 0;
  // reverse order of creation, in which engines and media find entities fastest
  std::sort(m_roots.begin(), m_roots.end(), SEntityComparator());
  std::sort(m_robots.begin(), m_robots.end(), SEntityComparator());
  while (!m_roots.empty()) {
    const size_t before = m_roots.size();
    try {
      RemoveLastRoot();
    } catch (...) {
      // the component whose Destroy() threw is gone; the next call removes the others
      numMore += failure == nullptr ? 0 : 1;
      failure = failure == nullptr ? std::current_exception() : failure;
      numFailures = m_roots.size() == before ? numFailures + 1 : 0;
      if (numFailures == kMaxFailures) {
        throw;
      }
    }
  }
  m_context.Run.DiscardChanges();
  m_context.RobotFailures.Report();
  m_views = std::make_unique<CEntityViews>(m_roots);
  *m_bodyIndex = CBodyIndex();
  m_context.Metrics = nullptr;
  m_extensions.clear();
  m_entityTypes.clear();
  m_nextIndex = 0;
  m_simulationClock = 0;
  if (numMore > 0) {
    LOGERR << "[WARNING] Destroy() of " << numMore
           << (numMore == 1 ? " more component" : " more components") << " of entities threw"
           << std::endl;
  }
  if (failure != nullptr) {
    std::rethrow_exception(failure);
  }
}

void CSpace::RemoveLastRoot() {
  ARGOS_ASSERT(!m_roots.empty(), "there is no entity to remove");
  const CEntity* const root = m_roots.back();
  CallEntityOperation<CSpaceOperationRemoveEntity, CSpace, void>(*this, *m_roots.back());
  if (!m_roots.empty() && m_roots.back() == root) {
    // its class has an operation for adding but none for removing
    EraseEntity(*m_roots.back());
  }
}

void CSpace::AddControllableEntity(CControllableEntity& entity) {
  CheckMayChange();
  m_robots.push_back(&entity);
  ++m_robotsVersion;
}

void CSpace::RemoveControllableEntity(CControllableEntity& entity) {
  CheckMayChange();
  const auto found = std::find(m_robots.rbegin(), m_robots.rend(), &entity);
  if (found != m_robots.rend()) {
    m_robots.erase(std::prev(found.base()));
    ++m_robotsVersion;
  }
}

void CSpace::AddEntityToPhysicsEngine(CEmbodiedEntity& body) {
  CheckMayChange();
  CEngineAssignment(m_context).Add(body);
}

void CSpace::RemoveEntityFromPhysicsEngines(CEmbodiedEntity& body) {
  CheckMayChange();
  CEngineAssignment(m_context).Remove(body);
}

void CSpace::IterateOverControllableEntities(const TControllableEntityIterCBType& callback) {
  m_context.Run.CheckIsNotInPhase("IterateOverControllableEntities()",
                                  "it is possible in PreStep() and PostStep()");
  constexpr char kCallback[] = "a callback of IterateOverControllableEntities()";
  const bool isOutermost = !m_context.Run.DefersChanges();
  const CRobotsCode::CLoop loop;
  std::optional<CRunState::CScope> scope(std::in_place, m_context.Run, CRunState::EActivity::Phase);
  CMetrics& metrics = GetExtension<CMetrics>();
  metrics.GetRobotRecords().Begin(m_robots.size(), m_context.Pool->GetNumThreads());
  InLogOrder(m_robots.size(), [&](UInt64 firstPlace) {
    const size_t grain =
        DivideIntoChunks(m_robots.size(), m_context.Pool->GetNumThreads(), kRobotsPerChunk);
    m_context.Pool->ParallelFor(
        m_robots.size(), grain, [&](size_t begin, size_t end, UInt32 thread) {
          CRobotRecords::CScope records(metrics.GetRobotRecords(), thread);
          CRunningCodeScope running(
              {kCallback, &CControllableEntity::Describe, nullptr, &m_simulationClock, true});
          for (size_t i = begin; i < end; ++i) {
            CARGoSLog::SetSequence(firstPlace + i);
            running.SetSubject(m_robots[i]);
            records.SetRobot(i);
            callback(m_robots[i]);
          }
        });
  });
  TakeRecords(metrics,
              [this](size_t robot) -> const CEntity& { return m_robots[robot]->GetRootEntity(); });
  m_context.Run.ApplyComponentChanges();
  scope.reset();
  if (isOutermost) {
    m_context.Run.ApplyChanges();
  }
}

UInt32 SSimulationContext::GetClock() const {
  return Space->GetSimulationClock();
}

void CSpace::Update() {
  m_context.RunTick();
}

UInt64 CSpace::ComputeDigest() const {
  CDigest digest;
  digest.Add(m_simulationClock);
  for (const CEntity* root : m_roots) {
    digest.Add(root->GetId());
    root->UpdateDigest(digest);
  }
  for (const CMedium* medium : m_context.Media) {
    medium->UpdateDigest(digest);
  }
  return digest.GetValue();
}

}  // namespace argos
