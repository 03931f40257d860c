// Loading of an experiment: the parts of the file, in the order of their initialisation. A failed
// part is recorded and loading continues, so that one run reports all errors.

#include <argos3/core/simulator/huge_pages.h>
#include <argos3/core/simulator/load_errors.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/space_partition.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/space/tick_times.h>
#include <argos3/core/simulator/visualization/default_visualization.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/string_utilities.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <chrono>

namespace argos {

namespace {

void LoadLibraryOf(TConfigurationNode& node) {
  if (NodeAttributeExists(node, "library")) {
    std::string library;
    GetNodeAttribute(node, "library", library);
    CDynamicLoading::LoadLibrary(library);
  }
}

// creates and initialises a part by the tag of its element
template <typename BASE>
std::unique_ptr<BASE> CreatePart(TConfigurationNode& node, const char* kind) {
  if (!CFactory<BASE>::Exists(node.Value())) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": there is no " << kind << " of type <" << node.Value() << ">"
                         << DidYouMean(node.Value(), CFactory<BASE>::GetLabels()));
  }
  try {
    std::unique_ptr<BASE> part(CFactory<BASE>::New(node.Value()));
    part->Init(node);
    return part;
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(node.GetLocation() << ": <" << node.Value() << ">: the " << kind
                                                   << " cannot be initialised",
                                error);
  }
}

// initialises every child of a section; ids must be unique
template <typename BASE>
void CreateParts(TConfigurationNode& section, const char* kind, CLoadErrors& errors,
                 const std::function<void(std::unique_ptr<BASE>)>& take,
                 const std::function<void(const std::string&)>& markBroken) {
  std::map<std::string, std::string> locations;
  TConfigurationNodeIterator it;
  for (it = it.begin(&section); it != it.end(); ++it) {
    const bool good = errors.Try("", [&] {
      std::unique_ptr<BASE> part = CreatePart<BASE>(*it, kind);
      const auto [other, inserted] = locations.emplace(part->GetId(), it->GetLocation());
      if (!inserted) {
        THROW_ARGOSEXCEPTION(it->GetLocation()
                             << ": there is already a " << kind << " with id \"" << part->GetId()
                             << "\" at " << other->second << "; ids must be unique");
      }
      take(std::move(part));
    });
    if (!good) {
      std::string id;
      GetNodeAttributeOrDefault(*it, "id", id, id);
      markBroken(id);
    }
  }
}

}  // namespace

void CSimulator::LoadExperiment(bool forceNoVisualization) {
  // check before the document of a loaded experiment would be replaced
  ThrowIfLoaded();
  auto document = std::make_unique<CConfigurationDocument>();
  document->LoadFile(m_experimentFileName);
  m_ownDocument = std::move(document);
  Load(*m_ownDocument, forceNoVisualization);
}

void CSimulator::ThrowIfLoaded() const {
  if (m_rng != nullptr) {
    THROW_ARGOSEXCEPTION("an experiment is loaded already: call Destroy() before loading another");
  }
}

void CSimulator::Load(CConfigurationDocument& document, bool forceNoVisualization) {
  ThrowIfLoaded();
  m_document = &document;
  m_forceNoVisualization = forceNoVisualization;
  try {
    Init();
  } catch (...) {
    // remove all partly created objects
    Destroy();
    throw;
  }
}

void CSimulator::Init() {
  const CScope scope(*this);
  CLoadErrors errors;
  m_loading = true;
  ApplyOverrides(errors);
  TConfigurationNode& root = GetConfigurationRoot();
  // a missing or invalid section is one error; the others are still checked
  const auto section = [&](const std::string& tag, auto&& init) {
    return errors.Try("", [&] { init(GetNode(root, tag)); });
  };
  section("framework", [&](TConfigurationNode& node) { InitFramework(node, errors); });
  if (m_rng == nullptr) {
    // nothing else can be checked without tick length and seed
    errors.ThrowIfAny();
  }
  section("controllers", [&](TConfigurationNode& node) { InitControllers(node, errors); });
  CreateLoopFunctions(root, errors);
  if (!section("physics_engines", [&](TConfigurationNode& node) { InitPhysics(node, errors); })) {
    MarkBroken("physics_engines");
  }
  section("media", [&](TConfigurationNode& node) { InitMedia(node, errors); });
  section("arena", [&](TConfigurationNode& node) { m_space->Init(node, errors); });
  InitLoopFunctions(root, errors);
  PostSpaceInit(errors);
  InitVisualization(root, errors);
  errors.ThrowIfAny();
  m_loading = false;
  m_space->MarkStart();
  BackHeapByHugePages();
  WarnOfUnreadParts();
  LOG.Flush();
  LOGERR.Flush();
}

void CSimulator::ApplyOverrides(CLoadErrors& errors) {
  for (const auto& [path, value] : m_overrides) {
    errors.Try("--set " + path + "=" + value, [&, &path = path, &value = value] {
      const std::string done = m_document->SetByPath(path, value);
      LOG << "[INFO] " << done << std::endl;
    });
  }
}

void CSimulator::InitFramework(TConfigurationNode& node, CLoadErrors& errors) {
  errors.Try(node.GetLocation() + ": <framework>", [&] { InitSystem(node); });
  errors.Try("", [&] { InitExperiment(node); });
  if (NodeExists(node, "profiling")) {
    errors.Try("", [&] { InitProfiling(GetNode(node, "profiling")); });
  }
}

void CSimulator::InitSystem(TConfigurationNode& framework) {
  UInt32 threads = 0;
  std::string method = "balance_quantity";
  bool pinToCores = false;
  if (NodeExists(framework, "system")) {
    TConfigurationNode& system = GetNode(framework, "system");
    GetNodeAttributeOrDefault(system, "threads", threads, threads);
    GetNodeAttributeOrDefault(system, "method", method, method);
    GetNodeAttributeOrDefault(system, "pin_threads_to_cores", pinToCores, pinToCores);
  }
  if (!m_threadsSet) {
    m_numThreads = threads;
  }
  try {
    constexpr UInt32 kMostThreads = 4096;
    if (m_numThreads > kMostThreads) {
      THROW_ARGOSEXCEPTION("at most " << kMostThreads << " threads are possible, found "
                                      << m_numThreads);
    }
    m_pool =
        std::make_unique<CThreadPool>(m_numThreads, CreateSchedule(method), pinToCores, [this] {
          // workers serve this simulator during their lifetime
          CScope(*this).Keep();
        });
  } catch (std::exception& error) {
    const bool hasNode = NodeExists(framework, "system");
    THROW_ARGOSEXCEPTION_NESTED((hasNode ? GetNode(framework, "system") : framework).GetLocation()
                                    << ": <" << (hasNode ? "system" : "framework")
                                    << ">: the threads cannot be started",
                                error);
  }
  if (m_numThreads > 0) {
    LOG << "[INFO] Using " << m_numThreads << " threads (" << method << ")" << std::endl;
  } else {
    LOG << "[INFO] Not using threads" << std::endl;
  }
}

void CSimulator::InitExperiment(TConfigurationNode& framework) {
  TConfigurationNode& experiment = GetNode(framework, "experiment");
  UInt32 ticksPerSecond = 0;
  GetNodeAttribute(experiment, "ticks_per_second", ticksPerSecond);
  if (ticksPerSecond == 0) {
    THROW_ARGOSEXCEPTION(experiment.GetLocation()
                         << ": <experiment>: \"ticks_per_second\" must be at least 1, found 0");
  }
  m_tickLength = 1.0 / ticksPerSecond;
  Real length = 0.0;
  GetNodeAttributeOrDefault(experiment, "length", length, length);
  try {
    SetLength(m_lengthSet ? m_length : length);
    if (m_length > 0.0 && m_maxSimulationClock == 0) {
      THROW_ARGOSEXCEPTION("a length of " << m_length << " s is less than one tick, "
                                          << m_tickLength << " s; 0 means unlimited");
    }
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(experiment.GetLocation() << ": <experiment>: invalid \"length\"",
                                error);
  }
  GetNodeAttributeOrDefault(experiment, "real_time", m_realTimeClock, m_realTimeClock);
  InitRandom(experiment);
  LOG << "[INFO] Total experiment length in clock ticks = "
      << (m_maxSimulationClock > 0 ? ToString(m_maxSimulationClock) : "unlimited") << std::endl;
}

UInt32 CSimulator::SeedFromClock() {
  using namespace std::chrono;
  const auto now = duration_cast<microseconds>(system_clock::now().time_since_epoch()).count();
  return static_cast<UInt32>(now);
}

void CSimulator::InitRandom(TConfigurationNode& experiment) {
  UInt32 seed = 0;
  GetNodeAttributeOrDefault(experiment, "random_seed", seed, seed);
  if (!m_seedSet) {
    m_seedFromClock = seed == 0;
    m_randomSeed = m_seedFromClock ? SeedFromClock() : seed;
  }
  LOG << "[INFO] Using random seed = " << m_randomSeed << std::endl;
  CRandom::CreateCategory("argos", m_randomSeed);
  m_rng = CRandom::CreateRNG("argos");
  LOG << "[INFO] Using simulation clock tick = " << m_tickLength << " s" << std::endl;
}

void CSimulator::InitProfiling(TConfigurationNode& node) {
  std::string file;
  std::string format;
  bool truncate = true;
  GetNodeAttribute(node, "file", file);
  GetNodeAttribute(node, "format", format);
  GetNodeAttributeOrDefault(node, "truncate_file", truncate, truncate);
  m_profiler = std::make_unique<CProfiler>(file, format, truncate);
  m_profiledTicks = std::make_unique<STickTimes>();
  m_space->SetTickTimes(m_profiledTicks.get());
  m_profiler->Start();
}

void CSimulator::InitControllers(TConfigurationNode& section, CLoadErrors& errors) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&section); it != it.end(); ++it) {
    errors.Try("", [&] { InitController(*it); });
  }
}

void CSimulator::InitController(TConfigurationNode& node) {
  std::string id;
  GetNodeAttribute(node, "id", id);
  if (id.empty()) {
    THROW_ARGOSEXCEPTION(
        node.GetLocation()
        << ": <" << node.Value()
        << ">: attribute \"id\" is empty; robots refer to their controller by id, as in "
           "<controller config=\"...\" />");
  }
  const auto [other, inserted] = m_controllerNodes.emplace(id, &node);
  if (!inserted) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": there is already a controller with id \"" << id << "\" at "
                         << other->second->GetLocation() << "; ids must be unique");
  }
  try {
    LoadLibraryOf(node);
  } catch (std::exception& error) {
    MarkBroken(id);
    THROW_ARGOSEXCEPTION_NESTED(
        node.GetLocation() << ": <" << node.Value() << " id=\"" << id << "\">", error);
  }
}

void CSimulator::CreateLoopFunctions(TConfigurationNode& root, CLoadErrors& errors) {
  if (NodeExists(root, "loop_functions")) {
    TConfigurationNode& node = GetNode(root, "loop_functions");
    errors.Try("", [&] {
      try {
        std::string label;
        GetNodeAttribute(node, "label", label);
        LoadLibraryOf(node);
        m_ownLoopFunctions.reset(CFactory<CLoopFunctions>::New(label));
        m_loopFunctions = m_ownLoopFunctions.get();
      } catch (std::exception& error) {
        THROW_ARGOSEXCEPTION_NESTED(node.GetLocation() << ": <loop_functions>", error);
      }
    });
  }
  if (m_loopFunctions == nullptr) {
    m_ownLoopFunctions = std::make_unique<CLoopFunctions>();
    m_loopFunctions = m_ownLoopFunctions.get();
  }
}

void CSimulator::InitPhysics(TConfigurationNode& section, CLoadErrors& errors) {
  // a missing arena is reported by its own section
  if (NodeExists(GetConfigurationRoot(), "arena") &&
      !ExpandAutoPartitions(section, GetNode(GetConfigurationRoot(), "arena"), errors)) {
    MarkBroken("physics_engines");
  }
  CreateParts<CPhysicsEngine>(
      section, "physics engine", errors,
      [this](std::unique_ptr<CPhysicsEngine> engine) {
        LOG << "[INFO] The physics engine \"" << engine->GetId() << "\" will perform "
            << engine->GetIterations()
            << " iterations per tick (dt = " << engine->GetPhysicsClockTick() << " s)" << std::endl;
        m_engines.push_back(engine.get());
        m_ownEngines.push_back(std::move(engine));
      },
      [this](const std::string&) { MarkBroken("physics_engines"); });
  CheckPartition(m_engines, errors);
}

void CSimulator::InitMedia(TConfigurationNode& section, CLoadErrors& errors) {
  CreateParts<CMedium>(
      section, "medium", errors,
      [this](std::unique_ptr<CMedium> medium) {
        m_media.push_back(medium.get());
        m_ownMedia.push_back(std::move(medium));
      },
      [this](const std::string& id) { MarkBroken(id); });
}

void CSimulator::InitLoopFunctions(TConfigurationNode& root, CLoadErrors& errors) {
  // loop functions may use every entity, and would fail as a consequence of reported errors
  if (!errors.IsEmpty()) {
    return;
  }
  if (!NodeExists(root, "loop_functions")) {
    m_loopFunctionsReady = true;
    return;
  }
  TConfigurationNode& node = GetNode(root, "loop_functions");
  m_loopFunctionsReady = errors.Try(node.GetLocation() + ": <loop_functions> cannot be initialised",
                                    [&] { m_loopFunctions->Init(node); });
}

void CSimulator::PostSpaceInit(CLoadErrors& errors) {
  if (!errors.IsEmpty()) {
    return;
  }
  FindBorders(m_engines, m_space->GetArenaLimits());
  for (CPhysicsEngine* engine : m_engines) {
    errors.Try("physics engine \"" + engine->GetId() + "\"", [&] { engine->PostSpaceInit(); });
  }
  for (CMedium* medium : m_media) {
    errors.Try("medium \"" + medium->GetId() + "\"", [&] { medium->PostSpaceInit(); });
  }
  for (const std::function<void()>& check : m_checks) {
    errors.Try("", check);
  }
  m_checks.clear();
}

void CSimulator::CheckWhenLoaded(std::function<void()> check) {
  if (m_loading) {
    m_checks.push_back(std::move(check));
  } else {
    check();
  }
}

void CSimulator::InitVisualization(TConfigurationNode& root, CLoadErrors& errors) {
  TConfigurationNodeIterator it;
  if (NodeExists(root, "visualization")) {
    TConfigurationNode& section = GetNode(root, "visualization");
    if (m_forceNoVisualization) {
      MarkSubtreeRead(section);
    } else {
      it = it.begin(&section);
    }
  }
  if (it != it.end() && !CFactory<CVisualization>::Exists(it->Value())) {
    LOGERR << "[WARNING] " << it->GetLocation() << ": there is no visualization <" << it->Value()
           << ">" << DidYouMean(it->Value(), CFactory<CVisualization>::GetLabels())
           << "; running without one" << std::endl;
    MarkSubtreeRead(*it);
  } else if (it != it.end()) {
    errors.Try("", [&] { m_visualization = CreatePart<CVisualization>(*it, "visualization"); });
    return;
  }
  LOG << "[INFO] Running without visualization" << std::endl;
  m_visualization = std::make_unique<CDefaultVisualization>();
}

void CSimulator::WarnOfUnreadParts() const {
  m_document->ForEachUnread([](const CConfigurationNode& node, const std::string& attribute) {
    LOGERR << "[WARNING] " << node.GetLocation() << ": <" << node.Value() << ">";
    if (!attribute.empty()) {
      LOGERR << ": attribute \"" << attribute << "\"";
    }
    LOGERR << " is not used by anything" << std::endl;
  });
}

}  // namespace argos
