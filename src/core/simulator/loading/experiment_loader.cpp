#include <argos3/core/simulator/loading/experiment_loader.h>

#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/context/load_errors.h>
#include <argos3/core/simulator/entity/entity_type.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/loading/experiment_parts.h>
#include <argos3/core/simulator/loading/load_warnings.h>
#include <argos3/core/simulator/loading/periodicity_check.h>
#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/simulator/loading/run_settings.h>
#include <argos3/core/simulator/loading/script_check.h>
#include <argos3/core/simulator/medium/medium.h>
#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/physics_engine/space_partition.h>
#include <argos3/core/simulator/placement/arena_filling.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/simulator/tick/tick.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/plugins/unknown_label.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/threads/thread_pool.h>

namespace argos {

namespace {

// creates and initialises a part by the tag of its element
template <typename BASE>
std::unique_ptr<BASE> CreatePart(TConfigurationNode& node, const char* kind) {
  LoadLibraryOf(node);
  if (!CFactory<BASE>::Exists(node.Value())) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": there is no " << kind << " of type <" << node.Value() << ">"
                         << DescribeUnknownLabel(node.Value(), CFactory<BASE>::GetLabels()));
  }
  try {
    std::unique_ptr<BASE> part(CFactory<BASE>::New(node.Value()));
    part->Init(node);
    return part;
  } catch (...) {
    ThrowWithCause(node.GetLocation() + ": <" + node.Value() + ">: the " + kind +
                   " cannot be initialised");
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
      errors.FindFurther([&] { CreatePart<BASE>(*it, kind); });
      std::string id;
      GetNodeAttributeOrDefault(*it, "id", id, id);
      markBroken(id);
    }
  }
}

void CheckRootTag(const TConfigurationNode& root) {
  const std::string expected = "argos-configuration";
  if (root.Value() != expected) {
    THROW_ARGOSEXCEPTION(root.GetLocation()
                         << ": the root element is <" << root.Value() << ">, expected <" << expected
                         << ">; is it an experiment file?");
  }
}

// reads how many robots a thread handles in a row; 0: by measured cost
size_t ReadGrain(TConfigurationNode& system) {
  std::string grain = "auto";
  GetNodeAttributeOrDefault(system, "grain", grain, grain);
  if (grain == "auto") {
    return 0;
  }
  try {
    UInt32 robots = 0;
    GetNodeAttribute(system, "grain", robots);
    if (robots >= 1) {
      return robots;
    }
  } catch (const CARGoSException&) {
    // the message below says more
  }
  THROW_ARGOSEXCEPTION(system.GetLocation()
                       << ": <system>: \"grain\" must be \"auto\" or a whole number >= 1, found \""
                       << grain << "\"");
}

}  // namespace

void CExperimentLoader::Load() {
  CLoadErrors errors;
  CDynamicLoading::LoadAllLibrariesOnDemand();
  m_context.Loading.Begin();
  AddOutputElements(errors);
  ApplyOverrides(errors);
  m_experiment.Document->SetLasting();
  TConfigurationNode& root = m_experiment.Document->GetRoot();
  errors.Try("", [&] { CheckRootTag(root); });
  errors.Try("", [&] { ReadLeniency(root); });
  // a missing or invalid section is one error; the others are still checked
  using TInit = void (CExperimentLoader::*)(TConfigurationNode&, CLoadErrors&);
  const auto section = [&](const std::string& tag, TInit init) {
    return errors.Try("", [&] { (this->*init)(GetNode(root, tag), errors); });
  };
  section("framework", &CExperimentLoader::InitFramework);
  if (!m_experiment.IsLoaded()) {
    ReplaceFramework();
  } else {
    LogLength();
  }
  if (NodeExists(root, "robot_types")) {
    section("robot_types", &CExperimentLoader::InitRobotTypes);
  }
  section("controllers", &CExperimentLoader::InitControllers);
  CreateLoopFunctions(root, errors);
  if (!section("physics_engines", &CExperimentLoader::InitPhysics)) {
    m_context.Loading.MarkBroken("physics_engines");
  }
  section("media", &CExperimentLoader::InitMedia);
  section("arena", &CExperimentLoader::InitArena);
  InitLoopFunctions(root, errors);
  PostSpaceInit(errors);
  InitViews(root, errors);
  InitOutputs(root, errors);
  CheckUnread(errors);
  if (CLoadingCheck::IsActive()) {
    CheckScripts(*m_context.Space, errors);
  }
  errors.ThrowIfAny();
  m_context.Loading.End();
  m_context.Space->MarkStart();
  m_experiment.ChecksControllersAtEnd = MayAddRobots() && !CLoadingCheck::IsActive();
  PrintWarnings(
      FindLoadWarnings(*m_experiment.Document, m_context, m_experiment.ChecksControllersAtEnd));
  LOG.Flush();
  LOGERR.Flush();
}

// in the run
bool CExperimentLoader::MayAddRobots() const {
  return NodeExists(m_experiment.Document->GetRoot(), "loop_functions") && !m_context.IsReplay;
}

// after an error in <framework>: what the checks of the other sections need
void CExperimentLoader::ReplaceFramework() {
  constexpr Real kTickLength = 0.1;  // s
  if (!(m_context.TickLength > 0.0)) {
    m_context.TickLength = kTickLength;
  }
  CRandom::CreateCategory("argos", 1);
  m_experiment.Rng = CRandom::CreateRNG("argos");
}

void CExperimentLoader::LogLength() const {
  LOG << "[INFO] Total experiment length in clock ticks = "
      << (m_settings.MaxClock > 0 ? ToString(m_settings.MaxClock) : "unlimited") << std::endl;
}

namespace {

TConfigurationNode MakeOutputElement(const SRunSettings::SOutput& output,
                                     TConfigurationNode& root) {
  TConfigurationNode element(output.Tag);
  if (output.IsCopy && NodeExists(root, "visualization") &&
      NodeExists(GetNode(root, "visualization"), output.Tag)) {
    element = *GetNode(GetNode(root, "visualization"), output.Tag).Clone();
  }
  for (const std::string& name : output.NotCopied) {
    element.RemoveAttribute(name);
  }
  for (const auto& [name, value] : output.Attributes) {
    element.SetAttribute(name, value);
  }
  return element;
}

}  // namespace

// before overrides, which may change them
void CExperimentLoader::AddOutputElements(CLoadErrors& errors) {
  for (const SRunSettings::SOutput& output : m_settings.Outputs) {
    errors.Try("<" + output.Tag + ">", [&] {
      TConfigurationNode& root = GetViewsDocument().GetRoot();
      if (!NodeExists(root, "outputs")) {
        TConfigurationNode section("outputs");
        AddChildNode(root, section);
      }
      TConfigurationNode element = MakeOutputElement(output, root);
      AddChildNode(GetNode(root, "outputs"), element);
    });
  }
}

void CExperimentLoader::ApplyOverrides(CLoadErrors& errors) {
  for (const auto& [path, value] : m_settings.Overrides) {
    errors.Try("--set " + path + "=" + value, [&, &path = path, &value = value] {
      const std::string done = GetViewsDocument().SetByPath(path, value);
      LOG << "[INFO] " << done << std::endl;
    });
  }
}

// Before any other value is read. Whether there are such elements is checked later.
void CExperimentLoader::ReadLeniency(TConfigurationNode& root) {
  if (NodeExists(root, "framework") && NodeExists(GetNode(root, "framework"), "experiment")) {
    bool lenient = false;
    GetNodeAttributeOrDefault(GetNode(GetNode(root, "framework"), "experiment"), "lenient", lenient,
                              lenient);
    if (lenient) {
      m_experiment.Document->SetLenient();
    }
  }
}

void CExperimentLoader::InitFramework(TConfigurationNode& node, CLoadErrors& errors) {
  errors.Try(node.GetLocation() + ": <framework>", [&] { InitSystem(node); });
  errors.Try("", [&] { InitExperiment(node); });
  if (NodeExists(node, "profiling")) {
    errors.Try("", [&] { InitProfiling(GetNode(node, "profiling")); });
  }
}

void CExperimentLoader::InitSystem(TConfigurationNode& framework) {
  UInt32 threads = 0;
  std::string method = "balance_quantity";
  bool pinToCores = false;
  size_t grain = 0;
  if (NodeExists(framework, "system")) {
    TConfigurationNode& system = GetNode(framework, "system");
    LoadLibraryOf(system);
    grain = ReadGrain(system);
    GetNodeAttributeOrDefault(system, "threads", threads, threads);
    GetNodeAttributeOrDefault(system, "method", method, method);
    GetNodeAttributeOrDefault(system, "pin_threads_to_cores", pinToCores, pinToCores);
  }
  if (!m_settings.AreThreadsSet) {
    m_settings.NumThreads = threads;
  }
  try {
    if (m_settings.NumThreads > SRunSettings::kMaxThreads) {
      THROW_ARGOSEXCEPTION("at most " << SRunSettings::kMaxThreads
                                      << " threads are possible, found " << m_settings.NumThreads);
    }
    m_experiment.Pool = std::make_unique<CThreadPool>(m_settings.NumThreads, CreateSchedule(method),
                                                      pinToCores, m_startWorker);
    m_context.Pool = m_experiment.Pool.get();
    m_tick.SetGrain(grain);
    m_experiment.Pool->SetSharesAlways(grain > 0);
  } catch (std::exception& error) {
    const bool hasNode = NodeExists(framework, "system");
    THROW_ARGOSEXCEPTION_NESTED((hasNode ? GetNode(framework, "system") : framework).GetLocation()
                                    << ": <" << (hasNode ? "system" : "framework")
                                    << ">: the threads cannot be started",
                                error);
  }
  if (m_settings.NumThreads > 0) {
    LOG << "[INFO] Using " << m_settings.NumThreads << " threads (" << method
        << (grain > 0 ? ", grain " + ToString(grain) : std::string()) << ")" << std::endl;
  } else {
    LOG << "[INFO] Not using threads" << std::endl;
  }
}

void CExperimentLoader::InitExperiment(TConfigurationNode& framework) {
  TConfigurationNode& experiment = GetNode(framework, "experiment");
  UInt32 ticksPerSecond = 0;
  GetNodeAttribute(experiment, "ticks_per_second", ticksPerSecond);
  if (ticksPerSecond == 0) {
    THROW_ARGOSEXCEPTION(experiment.GetLocation()
                         << ": <experiment>: \"ticks_per_second\" must be at least 1, found 0");
  }
  m_context.TickLength = 1.0 / ticksPerSecond;
  Real length = 0.0;
  GetNodeAttributeOrDefault(experiment, "length", length, length);
  try {
    m_settings.SetLength(m_settings.IsLengthSet ? m_settings.Length : length, m_context.TickLength);
    if (m_settings.Length > 0.0 && m_settings.MaxClock == 0) {
      THROW_ARGOSEXCEPTION("a length of " << m_settings.Length << " s is less than one tick, "
                                          << m_context.TickLength << " s; 0 means unlimited");
    }
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(experiment.GetLocation() << ": <experiment>: invalid \"length\"",
                                error);
  }
  GetNodeAttributeOrDefault(experiment, "real_time", m_settings.IsRealTime, m_settings.IsRealTime);
  m_context.Loading.SetOnError(ReadOnError(experiment));
  InitRandom(experiment);
}

void CExperimentLoader::InitRandom(TConfigurationNode& experiment) {
  UInt32 seed = 0;
  GetNodeAttributeOrDefault(experiment, "random_seed", seed, seed);
  if (!m_settings.IsSeedSet) {
    m_settings.IsSeedFromClock = seed == 0;
    m_settings.Seed = seed;
    if (m_settings.IsSeedFromClock) {
      m_settings.DrawSeedFromClock();
    }
    if (m_settings.IsSeedFromClock && NodeAttributeExists(experiment, "random_seed")) {
      LOGERR
          << "[WARNING] " << experiment.GetLocation()
          << ": <experiment>: random_seed=\"0\" is not a seed: one is drawn from the clock, and "
             "the run cannot be repeated without it. This run can be repeated with random_seed=\""
          << m_settings.Seed << "\"" << std::endl;
    }
  } else if (m_settings.Seed == 0) {
    LOGERR << "[WARNING] the seed 0 that the program or --seed sets is used as it is; "
              "random_seed=\"0\" in an experiment file draws one from the clock"
           << std::endl;
  }
  CreateRandomCategory();
}

void CExperimentLoader::CreateRandomCategory() {
  LOG << "[INFO] Using random seed = " << m_settings.Seed << std::endl;
  CRandom::CreateCategory("argos", m_settings.Seed);
  m_experiment.Rng = CRandom::CreateRNG("argos");
  LOG << "[INFO] Using simulation clock tick = " << m_context.TickLength << " s" << std::endl;
}

void CExperimentLoader::InitProfiling(TConfigurationNode& node) {
  std::string file;
  std::string format;
  bool truncate = true;
  GetNodeAttribute(node, "file", file);
  GetNodeAttribute(node, "format", format);
  GetNodeAttributeOrDefault(node, "truncate_file", truncate, truncate);
  try {
    if (CLoadingCheck::IsActive()) {
      CProfiler::Check(file, format);
      return;
    }
    m_experiment.StartProfiling(std::make_unique<CProfiler>(file, format, truncate), m_tick);
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(node.GetLocation() << ": <profiling> cannot be used", error);
  }
}

void CExperimentLoader::InitChildren(TConfigurationNode& section, CLoadErrors& errors,
                                     TInitChild init) {
  TConfigurationNodeIterator it;
  for (it = it.begin(&section); it != it.end(); ++it) {
    errors.Try("", [&] { (this->*init)(*it); });
  }
}

void CExperimentLoader::InitRobotTypes(TConfigurationNode& section, CLoadErrors& errors) {
  InitChildren(section, errors, &CExperimentLoader::InitRobotType);
}

void CExperimentLoader::InitRobotType(TConfigurationNode& node) {
  std::string id;
  GetNodeAttribute(node, "id", id);
  try {
    m_context.Space->AddEntityType(id, CreatePart<CEntityType>(node, "robot type"));
  } catch (std::exception& error) {
    THROW_ARGOSEXCEPTION_NESTED(
        node.GetLocation() << ": <" << node.Value() << " id=\"" << id << "\">", error);
  }
}

void CExperimentLoader::InitControllers(TConfigurationNode& section, CLoadErrors& errors) {
  InitChildren(section, errors, &CExperimentLoader::InitController);
}

void CExperimentLoader::InitController(TConfigurationNode& node) {
  std::string id;
  GetNodeAttribute(node, "id", id);
  if (id.empty()) {
    THROW_ARGOSEXCEPTION(
        node.GetLocation()
        << ": <" << node.Value()
        << ">: attribute \"id\" is empty; robots refer to their controller by id, as in "
           "<controller config=\"...\" />");
  }
  m_context.Loading.AddController(id, node);
  try {
    LoadLibraryOf(node);
  } catch (...) {
    m_context.Loading.MarkBroken(id);
    throw;
  }
}

void CExperimentLoader::CreateLoopFunctions(TConfigurationNode& root, CLoadErrors& errors) {
  if (NodeExists(root, "loop_functions")) {
    errors.Try("", [&] { CreateLoopFunctionsOf(GetNode(root, "loop_functions")); });
  }
  if (m_context.LoopFunctions == nullptr) {
    AdoptLoopFunctions(std::make_unique<CLoopFunctions>());
  }
}

void CExperimentLoader::CreateLoopFunctionsOf(TConfigurationNode& node) {
  std::string label;
  GetNodeAttribute(node, "label", label);
  LoadLibraryOf(node);
  try {
    AdoptLoopFunctions(std::unique_ptr<CLoopFunctions>(CFactory<CLoopFunctions>::New(label)));
  } catch (...) {
    ThrowWithCause(node.GetLocation() + ": <loop_functions>");
  }
}

void CExperimentLoader::AdoptLoopFunctions(std::unique_ptr<CLoopFunctions> loopFunctions) {
  m_experiment.OwnLoopFunctions = std::move(loopFunctions);
  m_experiment.SetLoopFunctions(m_experiment.OwnLoopFunctions.get());
}

void CExperimentLoader::InitArena(TConfigurationNode& node, CLoadErrors& errors) {
  CSpace& space = *m_context.Space;
  if (errors.Try("", [&] { space.Init(node); })) {
    m_experiment.Filling = std::make_unique<CArenaFilling>(space, node, errors);
  }
  space.GetBodyIndex().Rebuild(*m_context.Pool);
}

void CExperimentLoader::InitPhysics(TConfigurationNode& section, CLoadErrors& errors) {
  // a missing arena is reported by its own section
  if (NodeExists(m_experiment.Document->GetRoot(), "arena") &&
      !ExpandAutoPartitions(section, GetNode(m_experiment.Document->GetRoot(), "arena"), errors)) {
    m_context.Loading.MarkBroken("physics_engines");
  }
  CreateParts<CPhysicsEngine>(
      section, "physics engine", errors,
      [this](std::unique_ptr<CPhysicsEngine> engine) {
        LOG << "[INFO] The physics engine \"" << engine->GetId() << "\" will perform "
            << engine->GetIterations()
            << " iterations per tick (dt = " << engine->GetPhysicsClockTick() << " s)" << std::endl;
        // owned first: the context must not list what a lack of memory destroys
        m_experiment.Engines.push_back(std::move(engine));
        m_context.Engines.push_back(m_experiment.Engines.back().get());
      },
      [this](const std::string&) { m_context.Loading.MarkBroken("physics_engines"); });
  CheckPartition(m_context.Engines, errors);
}

void CExperimentLoader::InitMedia(TConfigurationNode& section, CLoadErrors& errors) {
  CreateParts<CMedium>(
      section, "medium", errors,
      [this](std::unique_ptr<CMedium> medium) {
        m_experiment.Media.push_back(std::move(medium));
        m_context.Media.push_back(m_experiment.Media.back().get());
      },
      [this](const std::string& id) { m_context.Loading.MarkBroken(id); });
}

void CExperimentLoader::InitLoopFunctions(TConfigurationNode& root, CLoadErrors& errors) {
  // loop functions may use every entity, and would fail as a consequence of reported errors
  if (!errors.IsEmpty()) {
    return;
  }
  if (!NodeExists(root, "loop_functions")) {
    m_experiment.AreLoopFunctionsReady = true;
    return;
  }
  TConfigurationNode& node = GetNode(root, "loop_functions");
  m_experiment.AreLoopFunctionsReady = errors.Try(
      node.GetLocation() + ": <loop_functions> cannot be initialised",
      [&] { CallHook(m_context, "Init()", [&] { m_context.LoopFunctions->Init(node); }); });
}

void CExperimentLoader::PostSpaceInit(CLoadErrors& errors) {
  if (!errors.IsEmpty()) {
    return;
  }
  CheckPeriodicity(m_context, m_experiment.Document->GetRoot(), errors);
  FindBorders(m_context.Engines, m_context.Arena.Limits);
  for (CPhysicsEngine* engine : m_context.Engines) {
    errors.Try("physics engine \"" + engine->GetId() + "\"", [&] { engine->PostSpaceInit(); });
  }
  for (CMedium* medium : m_context.Media) {
    errors.Try("medium \"" + medium->GetId() + "\"", [&] { medium->PostSpaceInit(); });
  }
  m_context.Loading.RunChecks(errors);
}

void CExperimentLoader::InitViews(TConfigurationNode& root, CLoadErrors& errors) {
  if (m_settings.Visualization) {
    errors.Try("", [&] { InitSetView(root); });
  }
  if (NodeExists(root, "visualization")) {
    TConfigurationNode& section = GetNode(root, "visualization");
    if (m_settings.Visualization || m_settings.ForceNoVisualization) {
      MarkSubtreeRead(section);
    } else {
      InitChildren(section, errors, &CExperimentLoader::InitView);
    }
  }
  if (m_experiment.Visualization == nullptr) {
    if (m_experiment.Outputs.IsEmpty()) {
      LOG << "[INFO] Running without visualization" << std::endl;
    }
    m_experiment.Visualization = m_makeDefaultVisualization();
  }
}

// a child of <visualization>: an output, or what runs the experiment
void CExperimentLoader::InitView(TConfigurationNode& node) {
  LoadLibraryOf(node);
  if (CFactory<CRunOutput>::Exists(node.Value())) {
    m_experiment.Outputs.Add(CreatePart<CRunOutput>(node, "visualization"));
  } else if (!CFactory<CVisualization>::Exists(node.Value())) {
    std::vector<std::string> labels = CFactory<CVisualization>::GetLabels();
    for (const std::string& label : CFactory<CRunOutput>::GetLabels()) {
      labels.push_back(label);
    }
    LOGERR << "[WARNING] " << node.GetLocation() << ": there is no visualization <" << node.Value()
           << ">" << DidYouMean(node.Value(), labels) << "; running without it" << std::endl;
    MarkSubtreeRead(node);
  } else if (m_experiment.Visualization != nullptr) {
    THROW_ARGOSEXCEPTION(node.GetLocation()
                         << ": <" << node.Value()
                         << "> runs the experiment itself, as another visualization does that "
                            "<visualization> has before it; only one such is possible");
  } else {
    m_experiment.Visualization = CreatePart<CVisualization>(node, "visualization");
  }
}

void CExperimentLoader::InitOutputs(TConfigurationNode& root, CLoadErrors& errors) {
  if (!NodeExists(root, "outputs")) {
    return;
  }
  TConfigurationNodeIterator it;
  for (it = it.begin(&GetNode(root, "outputs")); it != it.end(); ++it) {
    errors.Try("", [&] { m_experiment.Outputs.Add(CreatePart<CRunOutput>(*it, "output")); });
  }
}

// checked at the end, because parts and users' code read attributes until then
void CExperimentLoader::CheckUnread(CLoadErrors& errors) const {
  // a part that could not be loaded has not read all its attributes
  if (!errors.IsEmpty()) {
    return;
  }
  for (const std::string& repeated : GetViewsDocument().DescribeRepeated()) {
    errors.Add("", CARGoSException(repeated));
  }
  // robots that are added in the run may read them
  std::vector<const TConfigurationNode*> pending;
  if (MayAddRobots()) {
    for (const SControllerSetup* setup : m_context.Loading.ListUnusedControllers()) {
      pending.push_back(setup->Node);
    }
  }
  for (const std::string& unread : GetViewsDocument().DescribeUnreadSettings(pending)) {
    errors.Add("", CARGoSException(unread));
  }
}

}  // namespace argos
