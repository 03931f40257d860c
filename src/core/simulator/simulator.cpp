#include <argos3/core/simulator/simulator.h>

#include <argos3/core/control_interface/metric_recorder.h>
#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/default_visualization.h>
#include <argos3/core/simulator/entity/robots_code.h>
#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/loaded_simulators.h>
#include <argos3/core/simulator/loading/experiment_loader.h>
#include <argos3/core/simulator/loading/experiment_parts.h>
#include <argos3/core/simulator/placement/arena_filling.h>
#include <argos3/core/simulator/replay/replay.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/simulator/tick/tick.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/core/utility/text/string_utilities.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <dlfcn.h>

#include <cstdio>
#include <exception>
#include <utility>

namespace argos {

namespace {

thread_local CSimulator* currentSimulator = nullptr;

// the names of parts in messages
std::vector<std::string> Ids(const std::vector<CMedium*>& parts) {
  std::vector<std::string> ids;
  for (const CMedium* part : parts) {
    ids.push_back(part->GetId());
  }
  return ids;
}

// lets controllers that do not know the simulator, such as Lua scripts, record metrics
const bool kIsMetricRecorderSet =
    (SetMetricRecorder([](std::string_view name, Real value, std::string_view unit) {
       CurrentSimulator().GetMetrics().Record(name, value, unit);
     }),
     true);

}  // namespace

// the default simulator shares the process-wide random registry with code outside any scope
CSimulator::CSimulator(SDefaultTag) : CSimulator(std::unique_ptr<CRandom::CRegistry>()) {}

CSimulator::CSimulator() : CSimulator(std::make_unique<CRandom::CRegistry>()) {}

CSimulator::CSimulator(std::unique_ptr<CRandom::CRegistry> registry)
    : m_slabs(CObjectSlabs::Make()),
      m_ownRegistry(std::move(registry)),
      m_context(*this),
      m_space(std::make_unique<CSpace>(m_context)),
      m_tick(std::make_unique<CTick>(m_context)),
      m_experiment(std::make_unique<SExperimentParts>(m_context)) {
  m_context.Space = m_space.get();
  m_context.EndRun = [this] { m_experiment->Outputs.EndRun(*this); };
  m_context.RunTick = [this] {
    if (m_experiment->Replay != nullptr) {
      m_experiment->Replay->Advance(*m_space);
      m_context.Metrics->EndTick();
    } else {
      m_tick->Run();
    }
  };
}

CSimulator::~CSimulator() {
  // a user's Destroy() may throw, a destructor must not; not even if there is no memory for a line
  try {
    try {
      Destroy();
    } catch (const std::exception& error) {
      LOGERR << MarkLines(error.what()) << std::endl;
      LOGERR.Flush();
    }
  } catch (...) {
    static_cast<void>(std::fputs("[FATAL] a simulation was not destroyed in full\n", stderr));
  }
  CLoadedSimulators::Remove(*this);
}

CSimulator& CSimulator::GetInstance() {
  if (currentSimulator != nullptr) {
    return *currentSimulator;
  }
  if (CSimulator* const loaded = CLoadedSimulators::FindForThisThread(); loaded != nullptr) {
    return *loaded;
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

SSimulationContext& CurrentContext() {
  return CSimulator::GetInstance().m_context;
}

CSimulator::CScope::CScope(CSimulator& simulator)
    : m_previous(std::exchange(currentSimulator, &simulator)),
      m_previousRegistry(CRandom::SetCurrentRegistry(&simulator.GetRegistry())),
      m_previousSlabs(CObjectSlabs::SetCurrent(simulator.m_slabs.get())) {}

CSimulator::CScope::~CScope() {
  if (m_keep) {
    return;
  }
  currentSimulator = m_previous;
  CRandom::SetCurrentRegistry(m_previousRegistry);
  CObjectSlabs::SetCurrent(m_previousSlabs);
}

CRandom::CRegistry& CSimulator::GetRegistry() const {
  return m_ownRegistry != nullptr ? *m_ownRegistry : CRandom::GetProcessRegistry();
}

CSpace& CSimulator::GetSpace() const {
  return *m_space;
}

CPhysicsEngine& CSimulator::GetPhysicsEngine(const std::string& id) const {
  const CScope scope(m_context.Simulator);
  return m_experiment->EngineLookup.Get(id);
}

CMedium& CSimulator::GetMediumBase(const std::string& id) {
  for (CMedium* medium : m_context.Media) {
    if (medium->GetId() == id) {
      return *medium;
    }
  }
  ThrowIfBroken(id);
  THROW_ARGOSEXCEPTION("there is no medium \"" << id << "\""
                                               << DidYouMean(id, Ids(m_context.Media)));
}

CVisualization& CSimulator::GetVisualization() {
  if (m_experiment->Visualization == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is no visualization");
  }
  return *m_experiment->Visualization;
}

TConfigurationNode& CSimulator::GetConfigurationRoot() {
  if (m_experiment->Document == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is no configuration");
  }
  return m_experiment->Document->GetRoot();
}

TConfigurationNode& CSimulator::GetConfigForController(const std::string& id) {
  return m_context.Loading.GetController(id);
}

void CSimulator::MarkBroken(const std::string& id) {
  m_context.Loading.MarkBroken(id);
}

void CSimulator::ThrowIfBroken(const std::string& id) const {
  m_context.Loading.ThrowIfBroken(id);
}

void CSimulator::CheckWhenLoaded(std::function<void()> check) {
  m_context.Loading.CheckWhenLoaded(std::move(check));
}

CProfiler& CSimulator::GetProfiler() {
  if (!IsProfiling()) {
    THROW_ARGOSEXCEPTION("profiling is off; add <profiling> to <framework>");
  }
  return *m_experiment->Profiler;
}

bool CSimulator::IsProfiling() const {
  return m_experiment->Profiler != nullptr;
}

CMetrics& CSimulator::GetMetrics() {
  if (m_context.Metrics == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there are no metrics");
  }
  return *m_context.Metrics;
}

const CRobotFailures& CSimulator::GetRobotFailures() const {
  return m_context.RobotFailures;
}

void CSimulator::SetTickTimes(STickTimes* times) {
  m_tick->SetTimes(times);
}

CRandom::CRNG* CSimulator::GetRNG() {
  CRobotsCode::CheckShared("CSimulator::GetRNG()",
                           "CRandom::CreateRNG(\"argos\") makes a generator of the robot's own");
  return m_experiment->Rng;
}

// here, because the space is below the simulator
CRandom::CRNG& CSpace::GetRNG() {
  CRobotsCode::CheckShared("CSpace::GetRNG()",
                           "CRandom::CreateRNG(\"argos\") makes a generator of the robot's own");
  return *GetSimulator().GetRNG();
}

CThreadPool& CSimulator::GetThreadPool() {
  return *m_experiment->Pool;
}

CLoopFunctions& CSimulator::GetLoopFunctions() {
  if (m_context.LoopFunctions == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there are no loop functions");
  }
  return *m_context.LoopFunctions;
}

void CSimulator::SetLoopFunctions(CLoopFunctions& loopFunctions) {
  m_context.Run.CheckIsIdle("CSimulator::SetLoopFunctions()");
  m_experiment->OwnLoopFunctions.reset();
  m_experiment->SetLoopFunctions(&loopFunctions);
}

void CSimulator::SetRandomSeed(UInt32 seed) {
  CRobotsCode::CheckShared("CSimulator::SetRandomSeed()");
  m_settings.Seed = seed;
  m_settings.IsSeedSet = true;
  m_settings.IsSeedFromClock = false;
}

void CSimulator::SetNumThreads(UInt32 threads) {
  m_settings.NumThreads = threads;
  m_settings.AreThreadsSet = true;
}

void CSimulator::SetLength(Real seconds) {
  CRobotsCode::CheckShared("CSimulator::SetLength()");
  m_settings.SetLength(seconds, m_context.TickLength);
  m_settings.IsLengthSet = true;
}

void CSimulator::AddOverride(const std::string& path, const std::string& value) {
  m_settings.Overrides.emplace_back(path, value);
}

void CSimulator::AddOutput(const std::string& tag,
                           const std::vector<std::pair<std::string, std::string>>& attributes) {
  m_settings.Outputs.push_back({tag, attributes, false, {}});
}

void CSimulator::AddOutput(std::unique_ptr<CRunOutput> output) {
  if (!m_experiment->IsLoaded()) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is nothing of which to write an output");
  }
  m_experiment->Outputs.Add(std::move(output));
}

void CSimulator::AddVideo(const std::string& file, const std::string& speed) {
  SRunSettings::SOutput output;
  output.Tag = "offscreen";
  output.Attributes = {{"file", file}};
  if (!speed.empty()) {
    output.Attributes.emplace_back("speed", speed);
  }
  output.IsCopy = true;
  // the choice of frames and their files suit pictures
  output.NotCopied = {"directory", "base_name", "format", "quality", "every", "ticks"};
  m_settings.Outputs.push_back(output);
}

void CSimulator::SetVisualization(
    const std::string& tag, const std::vector<std::pair<std::string, std::string>>& attributes) {
  m_settings.Visualization = SRunSettings::SOutput{tag, attributes, false, {}};
}

std::string CSimulator::GetExperimentText() const {
  if (m_experiment->Document == nullptr) {
    THROW_ARGOSEXCEPTION("no experiment is loaded: there is no text of it");
  }
  return m_experiment->Document->ToText();
}

const CRunOutputs& CSimulator::GetOutputs() const {
  return m_experiment->Outputs;
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

void CSimulator::LoadExperiment(bool forceNoVisualization) {
  // checks before the document of a loaded experiment would be replaced
  m_context.Run.CheckIsIdleAndNotExecuting("CSimulator::LoadExperiment()");
  ThrowIfLoaded();
  auto document = std::make_unique<CConfigurationDocument>();
  document->LoadFile(m_experimentFileName);
  m_experiment->OwnDocument = std::move(document);
  Load(*m_experiment->OwnDocument, forceNoVisualization);
}

void CSimulator::LoadReplay(const SReplayRequest& request, bool forceNoVisualization) {
  m_context.Run.CheckIsIdleAndNotExecuting("CSimulator::LoadReplay()");
  ThrowIfLoaded();
  const CScope scope(*this);
  CDynamicLoading::LoadAllLibrariesOnDemand();
  std::unique_ptr<CReplay> replay(CFactory<CReplay>::New("recording"));
  replay->Open(request);
  auto document = std::make_unique<CConfigurationDocument>();
  document->Parse(replay->GetExperiment(), request.File);
  std::unique_ptr<CConfigurationDocument> views;
  if (!request.ViewsFile.empty()) {
    views = std::make_unique<CConfigurationDocument>();
    views->LoadFile(request.ViewsFile);
  }
  m_experimentFileName = replay->GetExperimentFile();
  m_experiment->Replay = std::move(replay);
  m_experiment->OwnDocument = std::move(document);
  m_experiment->ViewsDocument = std::move(views);
  SetRandomSeed(m_experiment->Replay->GetSeed());
  Load(*m_experiment->OwnDocument, forceNoVisualization);
}

void CSimulator::ThrowIfLoaded() const {
  if (m_experiment->IsLoaded()) {
    THROW_ARGOSEXCEPTION("an experiment is loaded already: call Destroy() before loading another");
  }
}

void CSimulator::Load(CConfigurationDocument& document, bool forceNoVisualization) {
  m_context.Run.CheckIsIdleAndNotExecuting("CSimulator::Load()");
  ThrowIfLoaded();
  m_experiment->Document = &document;
  m_settings.ForceNoVisualization = forceNoVisualization;
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
  GetConfigurationRoot();
  CLoadedSimulators::Add(*this, GetRegistry());
  CExperimentLoader loader(m_context, *m_tick, *m_experiment, m_settings);
  loader.SetWorkerStart([this, label = CLogControl::GetThreadLabel()] {
    CLogControl::SetThreadLabel(label);
    // workers serve this simulator during their lifetime
    CScope(*this).Keep();
  });
  loader.SetDefaultVisualization([] { return std::make_unique<CDefaultVisualization>(); });
  m_context.RobotFailures.Clear();
  m_context.Metrics = &m_space->GetExtension<CMetrics>();
  m_context.Metrics->Attach(m_context);
  const CRunState::CScope loading(m_context.Run, CRunState::EActivity::Loading);
  if (m_experiment->Replay != nullptr) {
    loader.LoadReplay();
  } else {
    loader.Load();
  }
  m_context.Metrics->UpdateBuiltIns();
}

void CSimulator::Reset() {
  ResetRun(m_experiment->Filling != nullptr && m_experiment->Filling->IsRedistributedByReset());
}

void CSimulator::ResetRun(bool redistributes) {
  m_context.Run.CheckAllowsReset();
  const CScope scope(*this);
  ShowUnseenTick();
  m_experiment->Outputs.Reset(*this);
  const CRunState::CScope resetting(m_context.Run, CRunState::EActivity::Resetting);
  m_context.Run.DiscardChanges();
  m_terminated = false;
  if (m_settings.IsSeedFromClock) {
    m_settings.DrawSeedFromClock();
    LOG << "[INFO] Using random seed = " << m_settings.Seed << std::endl;
  }
  CRandom::GetCategory("argos").SetSeed(m_settings.Seed);
  CRandom::GetCategory("argos").ResetRNGs();
  if (m_context.Metrics != nullptr) {
    m_context.Metrics->ForgetValues();
  }
  if (redistributes && m_experiment->Filling != nullptr) {
    m_space->Reset([this] { m_experiment->Filling->Redistribute(); });
  } else {
    m_space->Reset();
  }
  // media are reset after the engines, which the space resets: they use the positions of bodies
  for (CMedium* medium : m_context.Media) {
    medium->Reset();
  }
  CallHook(m_context, "Reset()", [this] { GetLoopFunctions().Reset(); });
  if (m_experiment->Replay != nullptr) {
    m_experiment->Replay->Begin(*m_space);
  }
  m_space->GetBodyIndex().Rebuild(*m_context.Pool);
  if (m_context.Metrics != nullptr) {
    m_context.Metrics->UpdateBuiltIns();
  }
  LOG.Flush();
  LOGERR.Flush();
}

// a hook that ends the run in a tick
void CSimulator::ShowUnseenTick() {
  if (m_experiment->Outputs.HasUnseenTick()) {
    {
      const CRunState::CScope scope(m_context.Run, CRunState::EActivity::Phase);
      m_context.Metrics->UpdateBuiltIns();
    }
    m_experiment->Outputs.Observe(*this);
  }
}

void CSimulator::CompleteOutputs() {
  const CScope scope(*this);
  std::exception_ptr failure;
  const auto guard = [&failure](const std::function<void()>& step) {
    try {
      step();
    } catch (...) {
      failure = failure != nullptr ? failure : std::current_exception();
    }
  };
  CRunOutputs& outputs = m_experiment->Outputs;
  if (!m_context.Run.IsInPhase() && !outputs.IsBusy()) {
    guard([&] {
      ShowUnseenTick();
      outputs.Finish(*this);
    });
  }
  outputs.Destroy(guard);
  if (failure != nullptr) {
    std::rethrow_exception(failure);
  }
}

void CSimulator::Reset(UInt32 newRandomSeed) {
  SetRandomSeed(newRandomSeed);
  Reset();
}

void CSimulator::Redistribute() {
  ResetRun(true);
}

void CSimulator::Redistribute(UInt32 newRandomSeed) {
  SetRandomSeed(newRandomSeed);
  Redistribute();
}

void CSimulator::Destroy() {
  m_context.Run.CheckIsIdleAndNotExecuting("CSimulator::Destroy()");
  const CScope scope(*this);
  const CRunState::CScope destroying(m_context.Run, CRunState::EActivity::Destroying);
  const std::exception_ptr failure = m_experiment->Destroy();
  CLoadedSimulators::Remove(*this);
  if (m_space->GetRootEntityVector().empty()) {
    // if there is no memory for it, what is destroyed stays and can be destroyed again
    auto next = std::make_unique<SExperimentParts>(m_context);
    m_experiment = std::move(next);
  }
  m_settings.ForgetWhatWasSet();
  m_terminated = false;
  m_isStopped = false;
  LOG.Flush();
  LOGERR.Flush();
  if (failure != nullptr) {
    std::rethrow_exception(failure);
  }
}

void CSimulator::Execute() {
  m_context.Run.CheckIsIdleAndNotExecuting("CSimulator::Execute()");
  const CScope scope(*this);
  const CRunState::CExecution execution(m_context.Run);
  CRunOutputs& outputs = m_experiment->Outputs;
  try {
    outputs.Begin(*this);
    GetVisualization().Execute();
    outputs.Finish(*this);
  } catch (...) {
    outputs.Abandon();
    throw;
  }
}

void CSimulator::UpdateSpace() {
  m_context.Run.CheckIsIdle("CSimulator::UpdateSpace()");
  const CScope scope(*this);
  CRunOutputs& outputs = m_experiment->Outputs;
  try {
    outputs.Begin(*this);
    m_space->Update();
    outputs.Observe(*this);
  } catch (...) {
    outputs.Abandon();
    throw;
  }
  CallTickObserver();
}

void CSimulator::CallTickObserver() {
  if (m_tickObserver) {
    m_tickObserver(*this);
  }
}

void CSimulator::Stop() {
  m_isStopped = true;
  Terminate();
}

bool CSimulator::IsReplay() const {
  return m_experiment->Replay != nullptr;
}

void CSimulator::SeekReplay(UInt32 tick) {
  m_context.Run.CheckIsIdle("CSimulator::SeekReplay()");
  if (!IsReplay()) {
    THROW_ARGOSEXCEPTION("only a replay can be shown from another tick on");
  }
  const CScope scope(*this);
  CRunOutputs& outputs = m_experiment->Outputs;
  outputs.Begin(*this);
  // ticks of outputs only increase
  if (tick <= m_space->GetSimulationClock()) {
    outputs.Reset(*this);
  }
  m_experiment->Replay->Seek(*m_space, tick);
  outputs.Begin(*this);
}

bool CSimulator::IsExperimentFinished() const {
  return m_terminated || (m_experiment->Replay != nullptr && m_experiment->Replay->IsAtEnd()) ||
         (m_settings.MaxClock > 0 && m_space->GetSimulationClock() >= m_settings.MaxClock) ||
         (m_context.LoopFunctions != nullptr &&
          CallHook(m_context, "IsExperimentFinished()",
                   [this] { return m_context.LoopFunctions->IsExperimentFinished(); }));
}

}  // namespace argos
