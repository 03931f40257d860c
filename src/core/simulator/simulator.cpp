#include <argos3/core/simulator/simulator.h>

#include <argos3/core/simulator/current.h>
#include <argos3/core/simulator/load_errors.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/space/body_index.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/space/tick_times.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <dlfcn.h>

#include <cmath>
#include <exception>
#include <limits>

namespace argos {

namespace {

thread_local CSimulator* currentSimulator = nullptr;

std::vector<std::string> Ids(const std::map<std::string, TConfigurationNode*>& nodes) {
  std::vector<std::string> ids;
  for (const auto& entry : nodes) {
    ids.push_back(entry.first);
  }
  return ids;
}

// ids of engines or media, for messages
template <typename PART>
std::vector<std::string> Ids(const std::vector<PART*>& parts) {
  std::vector<std::string> ids;
  for (const PART* part : parts) {
    ids.push_back(part->GetId());
  }
  return ids;
}

// thread pool without workers, for a simulator without an experiment
std::unique_ptr<CThreadPool> MakeIdlePool() {
  return std::make_unique<CThreadPool>(0, CreateSchedule("balance_quantity"));
}

}  // namespace

// the default simulator shares the process-wide random registry with code outside any scope
CSimulator::CSimulator(SDefaultTag)
    : m_slabs(CObjectSlabs::Make()),
      m_registry(nullptr),
      m_pool(MakeIdlePool()),
      m_space(std::make_unique<CSpace>(*this)) {}

CSimulator::CSimulator()
    : m_slabs(CObjectSlabs::Make()),
      m_ownRegistry(std::make_unique<CRandom::CRegistry>()),
      m_registry(m_ownRegistry.get()),
      m_pool(MakeIdlePool()),
      m_space(std::make_unique<CSpace>(*this)) {}

CSimulator::~CSimulator() {
  try {
    Destroy();
  } catch (const std::exception& error) {
    // a user's Destroy() may throw, a destructor must not
    LOGERR << error.what() << std::endl;
    LOGERR.Flush();
  }
}

CSimulator& CSimulator::GetInstance() {
  if (currentSimulator != nullptr) {
    return *currentSimulator;
  }
  // never deleted: at the end of the process the code of plug-ins may already be unloaded
  static CSimulator* const instance =
      std::unique_ptr<CSimulator>(new CSimulator(SDefaultTag{})).release();
  return *instance;
}

CSimulator& CurrentSimulator() {
  return CSimulator::GetInstance();
}

CSpace& CurrentSpace() {
  return CSimulator::GetInstance().GetSpace();
}

CSimulator::CScope::CScope(CSimulator& simulator)
    : m_previous(currentSimulator),
      m_previousRegistry(&CRandom::GetCurrentRegistry()),
      m_previousSlabs(CObjectSlabs::SetCurrent(simulator.m_slabs.get())) {
  currentSimulator = &simulator;
  CRandom::SetCurrentRegistry(simulator.m_registry);
}

CSimulator::CScope::~CScope() {
  if (m_keep) {
    return;
  }
  currentSimulator = m_previous;
  CRandom::SetCurrentRegistry(m_previousRegistry);
  CObjectSlabs::SetCurrent(m_previousSlabs);
}

CSpace& CSimulator::GetSpace() const {
  return *m_space;
}

CPhysicsEngine& CSimulator::GetPhysicsEngine(const std::string& id) const {
  for (CPhysicsEngine* engine : m_engines) {
    if (engine->GetId() == id) {
      return *engine;
    }
  }
  THROW_ARGOSEXCEPTION("there is no physics engine \"" << id << "\""
                                                       << DidYouMean(id, Ids(m_engines)));
}

CMedium& CSimulator::GetMediumBase(const std::string& id) {
  for (CMedium* medium : m_media) {
    if (medium->GetId() == id) {
      return *medium;
    }
  }
  ThrowIfBroken(id);
  THROW_ARGOSEXCEPTION("there is no medium \"" << id << "\"" << DidYouMean(id, Ids(m_media)));
}

CVisualization& CSimulator::GetVisualization() {
  if (m_visualization == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is no visualization");
  }
  return *m_visualization;
}

TConfigurationNode& CSimulator::GetConfigurationRoot() {
  if (m_document == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is no configuration");
  }
  return m_document->GetRoot();
}

TConfigurationNode& CSimulator::GetConfigForController(const std::string& id) {
  ThrowIfBroken(id);
  const auto found = m_controllerNodes.find(id);
  if (found == m_controllerNodes.end()) {
    THROW_ARGOSEXCEPTION("there is no controller with id \""
                         << id << "\" in <controllers>" << DidYouMean(id, Ids(m_controllerNodes)));
  }
  return *found->second;
}

void CSimulator::MarkBroken(const std::string& id) {
  if (m_loading) {
    m_broken.insert(id);
  }
}

void CSimulator::ThrowIfBroken(const std::string& id) const {
  if (m_broken.count(id) > 0) {
    throw CAlreadyReported("\"" + id + "\" could not be loaded");
  }
}

CProfiler& CSimulator::GetProfiler() {
  if (m_profiler == nullptr) {
    THROW_ARGOSEXCEPTION("profiling is off; add <profiling> to <framework>");
  }
  return *m_profiler;
}

void CSimulator::FinishProfiling() {
  if (m_profiler == nullptr) {
    return;
  }
  const STickTimes& times = *m_profiledTicks;
  m_profiler->AddPhase("act", times.Act, times.Ticks);
  m_profiler->AddPhase("physics", times.Physics, times.Ticks);
  m_profiler->AddPhase("index", times.Index, times.Ticks);
  m_profiler->AddPhase("media", times.Media, times.Ticks);
  m_profiler->AddPhase("pre-step", times.PreStep, times.Ticks);
  m_profiler->AddPhase("sense+control", times.SenseAndControl, times.Ticks);
  m_profiler->AddPhase("post-step", times.PostStep, times.Ticks);
  m_profiler->Stop();
  m_profiler->Flush();
  m_space->SetTickTimes(nullptr);
  m_profiler.reset();
  m_profiledTicks.reset();
}

CLoopFunctions& CSimulator::GetLoopFunctions() {
  if (m_loopFunctions == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there are no loop functions");
  }
  return *m_loopFunctions;
}

void CSimulator::SetLoopFunctions(CLoopFunctions& loopFunctions) {
  m_ownLoopFunctions.reset();
  m_loopFunctions = &loopFunctions;
}

void CSimulator::SetRandomSeed(UInt32 seed) {
  m_randomSeed = seed;
  m_seedSet = true;
  m_seedFromClock = false;
}

void CSimulator::SetNumThreads(UInt32 threads) {
  m_numThreads = threads;
  m_threadsSet = true;
}

void CSimulator::SetLength(Real seconds) {
  if (!(seconds >= 0.0) || std::isinf(seconds)) {
    THROW_ARGOSEXCEPTION("the length of an experiment must be 0 (unlimited) or more seconds, got "
                         << seconds);
  }
  m_length = seconds;
  m_lengthSet = true;
  // tolerance for a whole number of ticks that the division rounds down
  const Real ticks = std::floor(seconds / m_tickLength + 1e-6);
  if (ticks > std::numeric_limits<UInt32>::max()) {
    THROW_ARGOSEXCEPTION("an experiment of " << seconds << " s has more ticks than can be counted");
  }
  m_maxSimulationClock = static_cast<UInt32>(ticks);
}

void CSimulator::AddOverride(const std::string& path, const std::string& value) {
  m_overrides.emplace_back(path, value);
}

std::string CSimulator::GetInstallationDirectory() const {
  // <prefix>/lib/argos3/libargos3core_simulator.so
  Dl_info info;
  if (dladdr(reinterpret_cast<const void*>(&CurrentSimulator), &info) == 0) {
    return ARGOS_INSTALL_PREFIX;
  }
  std::string path = info.dli_fname;
  for (int level = 0; level < 3; ++level) {
    path = path.substr(0, path.find_last_of('/'));
  }
  return path;
}

void CSimulator::Reset() {
  const CScope scope(*this);
  m_terminated = false;
  if (m_seedFromClock) {
    m_randomSeed = SeedFromClock();
    LOG << "[INFO] Using random seed = " << m_randomSeed << std::endl;
  }
  CRandom::GetCategory("argos").SetSeed(m_randomSeed);
  CRandom::GetCategory("argos").ResetRNGs();
  m_space->Reset();
  for (CPhysicsEngine* engine : m_engines) {
    engine->Reset();
  }
  // after the engines: media use the positions of bodies
  for (CMedium* medium : m_media) {
    medium->Reset();
  }
  m_loopFunctions->Reset();
  m_space->GetBodyIndex().Rebuild(*m_pool);
  LOG.Flush();
  LOGERR.Flush();
}

void CSimulator::Reset(UInt32 newRandomSeed) {
  SetRandomSeed(newRandomSeed);
  Reset();
}

void CSimulator::Destroy() {
  const CScope scope(*this);
  // users' Destroy() may rely on their Init()
  std::exception_ptr failure;
  if (m_loopFunctionsReady) {
    try {
      m_loopFunctions->Destroy();
    } catch (...) {
      // continue, and throw again at the end
      failure = std::current_exception();
    }
    m_loopFunctionsReady = false;
  }
  if (m_visualization != nullptr) {
    m_visualization->Destroy();
  }
  m_visualization.reset();
  m_space->Destroy();
  // after the entities, which may still request the floor's colour
  m_ownLoopFunctions.reset();
  m_loopFunctions = nullptr;
  for (CMedium* medium : m_media) {
    medium->Destroy();
  }
  m_media.clear();
  m_ownMedia.clear();
  for (CPhysicsEngine* engine : m_engines) {
    engine->Destroy();
  }
  m_engines.clear();
  m_ownEngines.clear();
  FinishProfiling();
  if (CRandom::ExistsCategory("argos")) {
    CRandom::RemoveCategory("argos");
  }
  // joins the workers, so that none is left at the end of the program
  m_pool = MakeIdlePool();
  m_rng = nullptr;
  m_controllerNodes.clear();
  m_broken.clear();
  m_checks.clear();
  m_loading = false;
  m_overrides.clear();
  m_document = nullptr;
  m_terminated = false;
  m_realTimeClock = false;
  m_seedSet = m_threadsSet = m_lengthSet = false;
  m_seedFromClock = true;
  LOG.Flush();
  LOGERR.Flush();
  if (failure != nullptr) {
    std::rethrow_exception(failure);
  }
}

void CSimulator::Execute() {
  const CScope scope(*this);
  GetVisualization().Execute();
}

void CSimulator::UpdateSpace() {
  const CScope scope(*this);
  m_space->Update();
  if (m_tickObserver) {
    m_tickObserver(*this);
  }
}

bool CSimulator::IsExperimentFinished() const {
  return m_terminated ||
         (m_maxSimulationClock > 0 && m_space->GetSimulationClock() >= m_maxSimulationClock) ||
         (m_loopFunctions != nullptr && m_loopFunctions->IsExperimentFinished());
}

}  // namespace argos
