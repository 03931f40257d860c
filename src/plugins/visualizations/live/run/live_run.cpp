#include <argos3/plugins/simulator/visualizations/live/run/live_run.h>

#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/run_commands.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/simulator/tick/loop_functions.h>
#include <argos3/core/simulator/tick/loop_hooks.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/plugins/simulator/outputs/recording/run_info.h>
#include <argos3/plugins/simulator/visualizations/live/run/command_arguments.h>
#include <argos3/plugins/simulator/visualizations/live/run/device_marks.h>
#include <argos3/plugins/simulator/visualizations/live/run/entity_values.h>
#include <argos3/plugins/simulator/visualizations/live/run/page.h>

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace argos {

namespace {

constexpr int kProtocolVersion = 1;
constexpr Real kMaxSpeed = 1e6;
constexpr UInt32 kMaxSteps = 1000000;
constexpr size_t kMaxValueBytes = 65536;  // of an entity, as text
// how long the program may not notice a signal while nothing happens
constexpr std::chrono::milliseconds kLongestWait(100);
constexpr std::chrono::milliseconds kValuesPeriod(100);
constexpr std::chrono::seconds kStatusPeriod(1);

std::string WithoutMark(std::string text) {
  constexpr std::string_view kMark = "[FATAL] ";
  if (text.rfind(kMark, 0) == 0) {
    text.erase(0, kMark.size());
  }
  return text;
}

}  // namespace

CLiveRun::CLiveRun()
    : m_pace(m_cSimulator.GetTickLength()), m_executor(m_cSimulator, m_capture.GetDrawing()) {}

CLiveRun::~CLiveRun() = default;

void CLiveRun::ReadAttributes(TConfigurationNode& tree, SLiveServerSettings& settings) {
  const auto check = [&](bool isGood, const char* text) {
    if (!isGood) {
      THROW_ARGOSEXCEPTION(tree.GetLocation() << ": <live>: " << text);
    }
  };
  std::string hosts;
  GetNodeAttributeOrDefault(tree, "port", settings.Port, settings.Port);
  settings.Access.Address = "127.0.0.1";
  GetNodeAttributeOrDefault(tree, "address", settings.Access.Address, settings.Access.Address);
  GetNodeAttributeOrDefault(tree, "hosts", hosts, hosts);
  Tokenize(hosts, settings.Access.Hosts, ", ");
  GetNodeAttributeOrDefault(tree, "fps", settings.StatesPerSecond, settings.StatesPerSecond);
  check(settings.StatesPerSecond >= 0.1 && settings.StatesPerSecond <= 100.0,
        "\"fps\" must be from 0.1 to 100");
  GetNodeAttributeOrDefault(tree, "speed", m_speed, m_speed);
  check(m_speed >= 0.0 && m_speed <= kMaxSpeed, "\"speed\" must be from 0 to 1000000");
  m_pace.SetSpeed(m_speed);
  GetNodeAttributeOrDefault(tree, "play", m_isPlaying, m_isPlaying);
  GetNodeAttributeOrDefault(tree, "open", m_opensPage, m_opensPage);
  GetNodeAttributeOrDefault(tree, "linger", m_linger, m_linger);
  check(m_linger >= 0.0 && m_linger <= 1e9, "\"linger\" must be from 0 to 1e9");
  GetNodeAttributeOrDefault(tree, "edit", m_mayEdit, m_mayEdit);
  GetNodeAttributeOrDefault(tree, "control", m_hasControl, m_hasControl);
  settings.HasControl = m_hasControl;
  GetNodeAttributeOrDefault(tree, "url_file", m_urlFileName, m_urlFileName);
  m_goesOn = !m_urlFileName.empty() && m_isPlaying;
}

void CLiveRun::Init(TConfigurationNode& tree) {
  SLiveServerSettings settings;
  ReadAttributes(tree, settings);
  m_capture.Init(tree);
  settings.Access.Token = MakeLiveToken();
  settings.Page = ReadPage(m_cSimulator.GetInstallationDirectory());
  if (!CLoadingCheck::IsActive()) {
    m_server = std::make_unique<CLiveServer>(std::move(settings), m_link);
  }
}

void CLiveRun::Destroy() {
  m_urlFile.reset();
  m_log.reset();
  m_server.reset();
  m_capture.Destroy();
}

TJson CLiveRun::MakeWelcome() {
  const bool isReplay = m_cSimulator.IsReplay();
  return {{"protocol", kProtocolVersion},
          {"version", ARGOS_VERSION "-" ARGOS_RELEASE},
          {"experiment", m_cSimulator.GetExperimentFileName()},
          {"tick_length", m_cSimulator.GetTickLength()},
          {"last_tick", m_cSimulator.GetMaxSimulationClock()},
          {"seed", m_cSimulator.GetRandomSeed()},
          {"can",
           {{"control", m_hasControl},
            {"edit", m_mayEdit && !isReplay},
            {"replay", isReplay},
            {"seek", isReplay},
            {"change", !isReplay},
            {"drive", !isReplay},
            {"user_functions", !isReplay && m_capture.GetDrawing().HasFunctions()},
            {"redistribute", !isReplay}}},
          {"types_to_add", m_executor.ListTypesToAdd()}};
}

void CLiveRun::Announce() {
  const std::string url = m_server->GetURL();
  if (!m_urlFileName.empty()) {
    SLiveRunEntry entry;
    entry.URL = url;
    entry.Experiment = m_cSimulator.GetExperimentFileName();
    entry.Seed = m_cSimulator.GetRandomSeed();
    entry.Process = static_cast<UInt64>(getpid());
    m_urlFile = std::make_unique<CLiveRunFile>(m_urlFileName, entry);
  }
  CLogControl::Notify("Live view: " + url);
  if (m_opensPage) {
    OpenInBrowser(url);
  }
}

void CLiveRun::Execute() {
  CheckEnd();
  SendStatus();
  m_server->Start(WriteInfo(MakeRunInfo(m_cSimulator)), MakeWelcome());
  Announce();
  m_log = std::make_unique<CLiveLog>();
  try {
    Loop();
    CallPostExperiment();
  } catch (...) {
    HandOverLog(true);
    m_server->Stop("the run has failed: " + WithoutMark(DescribeCurrentException()));
    m_log.reset();
    throw;
  }
  Serve(TClock::now());
  m_urlFile.reset();
  m_server->Stop("the run has ended");
  m_log.reset();
}

void CLiveRun::Loop() {
  m_executor.CheckSelection();
  m_capture.Observe(m_cSimulator);
  m_pace.Restart(TClock::now());
  while (true) {
    const TClock::time_point now = TClock::now();
    Serve(now);
    const bool isOver = m_isFinished && (m_goesOn || HasLingered(now));
    if (m_isEnding || m_cSimulator.IsStopped() || isOver) {
      return;
    }
    GoOnAlone();
    if (!MayTick()) {
      WaitForUser();
    } else if (!m_pace.IsDue(now)) {
      m_link.WaitUntil(std::min(m_pace.GetDueTime(), now + kLongestWait), m_hasChanged);
    } else {
      Tick();
    }
  }
}

void CLiveRun::Tick() {
  m_executor.Drive();
  m_cSimulator.UpdateSpace();
  m_executor.CheckSelection();
  m_capture.Observe(m_cSimulator);
  m_hasChanged = m_haveValuesChanged = true;
  m_pace.CountTick(TClock::now());
  if (m_stepsLeft > 0 && --m_stepsLeft == 0) {
    m_isPlaying = false;
  }
  CheckEnd();
}

void CLiveRun::CheckEnd() {
  m_isFinished = m_cSimulator.IsExperimentFinished();
  if (m_isFinished) {
    m_isPlaying = false;
    m_stepsLeft = 0;
    CallPostExperiment();
    m_lastViewer = TClock::now();
  }
}

void CLiveRun::CallPostExperiment() {
  if (std::exchange(m_isPostExperimentDone, true)) {
    return;
  }
  CLoopFunctions& loopFunctions = m_cSimulator.GetLoopFunctions();
  CallHook(m_cSpace.GetContext(), "PostExperiment()",
           [&loopFunctions] { loopFunctions.PostExperiment(); });
  m_hasChanged = m_haveValuesChanged = true;
}

void CLiveRun::WaitForUser() {
  m_link.WaitUntil(TClock::now() + kLongestWait, m_hasChanged);
  m_cSimulator.CallTickObserver();
  m_pace.Restart(TClock::now());
}

// lets the run go on at its speed after the last viewer has left
void CLiveRun::GoOnAlone() {
  if (m_goesOn && !m_isFinished && m_link.HadViewers() && !m_link.HasViewers() &&
      (!m_isPlaying || m_pace.GetSpeed() != m_speed)) {
    m_isPlaying = true;
    m_stepsLeft = 0;
    m_pace.SetSpeed(m_speed);
    m_pace.Restart(TClock::now());
  }
}

// @return true if the time after the last viewer has passed
bool CLiveRun::HasLingered(TClock::time_point now) {
  if (!m_link.HadViewers()) {
    return true;
  }
  if (m_link.HasViewers()) {
    m_lastViewer = now;
  }
  return now - m_lastViewer > std::chrono::duration<Real>(m_linger);
}

void CLiveRun::Serve(TClock::time_point now) {
  const bool hasCommands = m_link.HasCommands();
  if (hasCommands) {
    DoCommands();
  }
  HandOverLog(hasCommands || !MayTick());
  if (!m_link.HasViewers()) {
    return;
  }
  if (m_hasChanged && m_link.WantsState()) {
    CaptureState();
    HandOverLog(true);
  }
  if (m_haveValuesChanged && now >= m_valuesDue) {
    m_valuesDue = now + kValuesPeriod;
    m_haveValuesChanged = false;
    SendValues();
  }
  if (now >= m_statusDue || MayTick() != m_wasTicking) {
    m_wasTicking = MayTick();
    m_statusDue = now + kStatusPeriod;
    SendStatus();
  }
}

// @param isOutside  users' code may have logged since the last tick, which has flushed its own
// lines
void CLiveRun::HandOverLog(bool isOutside) {
  if (isOutside) {
    LOG.Flush();
    LOGERR.Flush();
  }
  m_log->HandOver(m_link, m_cSpace.GetSimulationClock());
}

void CLiveRun::CaptureState() {
  // first: a viewer that gets the state then has what belongs to it
  SendPerceptions();
  std::unique_ptr<SLiveState> state = m_link.MakeState();
  m_capture.Take(m_cSimulator, *state);
  m_hasChanged = false;
  m_link.PutState(std::move(state));
}

void CLiveRun::SendStatus() {
  SLiveStatus status;
  status.Run = m_isFinished ? "ended" : MayTick() ? "playing" : "paused";
  status.Tick = m_cSpace.GetSimulationClock();
  status.Speed = m_pace.GetSpeed();
  status.RealTimeFactor = MayTick() ? m_pace.GetRealTimeFactor() : 0.0;
  m_link.PutStatus(status);
}

void CLiveRun::SendValues() {
  for (const std::string& id : m_pinned) {
    CEntity* const entity = m_cSpace.TryGetEntity(id);
    if (entity == nullptr) {
      continue;
    }
    TJson tree;
    try {
      tree = ReadValues(entity->GetRootEntity(), kMaxValueBytes);
    } catch (...) {
      // what viewers look at does not end the run
      tree = {{"error", WithoutMark(DescribeCurrentException())}};
    }
    m_link.PutEvent(
        {0,
         ToText({{"values",
                  {{"entity", id}, {"tick", m_cSpace.GetSimulationClock()}, {"tree", tree}}}}),
         id});
  }
}

// what pinned robots perceive at the present tick
void CLiveRun::SendPerceptions() {
  for (const std::string& id : m_pinned) {
    CEntity* const entity = m_cSpace.TryGetEntity(id);
    if (entity == nullptr) {
      continue;
    }
    TJson perceived = {{"entity", id}, {"tick", m_cSpace.GetSimulationClock()}};
    try {
      perceived["marks"] = ReadDeviceMarks(entity->GetRootEntity());
      perceived["light"] = ReadLight(entity->GetRootEntity());
    } catch (...) {
      // values say why they cannot be read
      perceived["marks"] = TJson::array();
      perceived["light"] = nullptr;
    }
    m_link.PutEvent({0, ToText({{"perceived", perceived}}), id});
  }
}

void CLiveRun::DoCommands() {
  m_link.TakeCommands(m_commands);
  for (const SLiveCommand& command : m_commands) {
    DoCommand(command);
  }
  // at once, whatever the commands were
  m_haveValuesChanged = true;
  m_valuesDue = m_statusDue = TClock::time_point();
}

CLiveRun::TAction CLiveRun::FindAction(const std::string& command) {
  constexpr std::pair<const char*, TAction> kActions[] = {
      {"play", &CLiveRun::Play},
      {"pause", &CLiveRun::Pause},
      {"step", &CLiveRun::Step},
      {"speed", &CLiveRun::SetSpeed},
      {"reset", &CLiveRun::ResetRun},
      {"redistribute", &CLiveRun::RedistributeRun},
      {"seek", &CLiveRun::SeekTick},
      {"end", &CLiveRun::EndRun},
      {"open_script", &CLiveRun::OpenScript},
      {"parameters", &CLiveRun::ListParameters}};
  for (const auto& [name, action] : kActions) {
    if (command == name) {
      return action;
    }
  }
  return nullptr;
}

// Does a command that comes from the server, not from a viewer.
void CLiveRun::DoServerCommand(const SLiveCommand& command) {
  if (command.Do == "pinned") {
    m_pinned = command.Arguments["entities"].get<std::vector<std::string>>();
    SendPerceptions();
    return;
  }
  if (command.Do == "left") {
    m_hasChanged = m_haveValuesChanged = true;
    return;
  }
  // "release": another viewer has control, or none
  for (const TJson& release : m_executor.ListReleases()) {
    m_hasChanged = true;
    RecordCommand(release);
    try {
      m_executor.Do(release["do"].get<std::string>(), release);
    } catch (...) {
      LOGERR << "[ERROR] " << WithoutMark(DescribeCurrentException()) << std::endl;
    }
  }
}

void CLiveRun::DoCommand(const SLiveCommand& command) {
  if (command.Viewer == 0) {
    DoServerCommand(command);
    return;
  }
  TJson answer = {{"re", command.Id}};
  try {
    TJson more = TJson::object();
    if (const TAction action = FindAction(command.Do)) {
      more = (this->*action)(command.Arguments);
    } else if (CCommandExecutor::Knows(command.Do)) {
      more = DoChange(command);
    } else {
      THROW_ARGOSEXCEPTION("there is no command \"" << command.Do << '"');
    }
    answer.update(more);
    if (!answer.contains("error")) {
      answer["ok"] = true;
    }
  } catch (...) {
    answer["error"] = WithoutMark(DescribeCurrentException());
  }
  m_link.PutEvent({command.Viewer, ToText(answer)});
}

void CLiveRun::RecordCommand(TJson command) {
  command.erase("id");
  m_cSpace.GetExtension<CRunCommands>().Add(m_cSpace.GetSimulationClock(), ToText(command));
}

TJson CLiveRun::DoChange(const SLiveCommand& command) {
  if (command.Do == "script") {
    CheckEditing();
  }
  // one that is refused is recorded, too: users' code may have been called
  RecordCommand(command.Arguments);
  m_hasChanged = m_haveValuesChanged = true;
  return m_executor.Do(command.Do, command.Arguments);
}

TJson CLiveRun::Play(const TJson&) {
  if (m_isFinished) {
    THROW_ARGOSEXCEPTION("the run has ended: reset it first");
  }
  m_isPlaying = true;
  m_stepsLeft = 0;
  m_pace.Restart(TClock::now());
  return TJson::object();
}

TJson CLiveRun::Pause(const TJson&) {
  m_isPlaying = false;
  m_stepsLeft = 0;
  return TJson::object();
}

TJson CLiveRun::Step(const TJson& arguments) {
  if (m_isFinished) {
    THROW_ARGOSEXCEPTION("the run has ended: reset it first");
  }
  m_stepsLeft = ReadCountArgument(arguments, "n", 1, kMaxSteps).value_or(1);
  m_isPlaying = false;
  m_pace.Restart(TClock::now());
  return TJson::object();
}

TJson CLiveRun::SetSpeed(const TJson& arguments) {
  const auto factor = ReadNumberArgument(arguments, "factor", 0.0, kMaxSpeed);
  if (!factor || (*factor > 0.0 && *factor < 1e-3)) {
    THROW_ARGOSEXCEPTION("\"factor\" is a number from 0.001 to 1000000, or 0");
  }
  m_pace.SetSpeed(*factor);
  m_pace.Restart(TClock::now());
  return TJson::object();
}

TJson CLiveRun::ResetRun(const TJson& arguments) {
  const auto seed = ReadCountArgument(arguments, "seed", 1, ~UInt32(0));
  const CCommandExecutor::SRestart restart = m_executor.Restore();
  if (seed && !m_cSimulator.IsReplay()) {
    m_cSimulator.Reset(*seed);
  } else {
    m_cSimulator.Reset();
  }
  BeginAgain(restart);
  return {{"seed", m_cSimulator.GetRandomSeed()}};
}

TJson CLiveRun::RedistributeRun(const TJson& arguments) {
  const auto seed = ReadCountArgument(arguments, "seed", 1, ~UInt32(0));
  if (m_cSimulator.IsReplay()) {
    THROW_ARGOSEXCEPTION("a replay shows what was recorded: nothing can be changed in it");
  }
  const CCommandExecutor::SRestart restart = m_executor.Restore();
  if (seed) {
    m_cSimulator.Redistribute(*seed);
  } else {
    m_cSimulator.Redistribute();
  }
  BeginAgain(restart);
  return {{"seed", m_cSimulator.GetRandomSeed()}};
}

TJson CLiveRun::SeekTick(const TJson& arguments) {
  const auto tick = ReadCountArgument(arguments, "tick", 0, ~UInt32(0));
  if (!tick) {
    THROW_ARGOSEXCEPTION("\"tick\" is missing");
  }
  if (!m_cSimulator.IsReplay()) {
    THROW_ARGOSEXCEPTION("only a replay has other ticks to show");
  }
  m_cSimulator.SeekReplay(*tick);
  BeginAgain({});
  return TJson::object();
}

TJson CLiveRun::EndRun(const TJson&) {
  RecordCommand({{"do", "end"}});
  m_isEnding = true;
  return TJson::object();
}

void CLiveRun::CheckEditing() const {
  if (!m_mayEdit) {
    THROW_ARGOSEXCEPTION(
        "the author of this run does not allow to edit scripts: <live edit=\"true\">");
  }
}

TJson CLiveRun::OpenScript(const TJson& arguments) {
  CheckEditing();
  return m_executor.OpenScript(arguments);
}

TJson CLiveRun::ListParameters(const TJson& arguments) {
  return m_executor.ListParameters(arguments);
}

// Call it after the clock was set; the scripts and parameters that viewers have set remain.
void CLiveRun::BeginAgain(const CCommandExecutor::SRestart& restart) {
  m_executor.ForgetDrivers();
  m_isPostExperimentDone = false;
  m_stepsLeft = 0;
  m_hasChanged = m_haveValuesChanged = true;
  m_executor.CheckSelection();
  m_capture.Observe(m_cSimulator);
  m_pace.Restart(TClock::now());
  for (const TJson& command : restart.Done) {
    RecordCommand(command);
  }
  for (const TJson& command : restart.ToDo) {
    RecordCommand(command);
    try {
      m_executor.Do(command["do"].get<std::string>(), command);
    } catch (...) {
      LOGERR << "[ERROR] After the reset: " << WithoutMark(DescribeCurrentException()) << std::endl;
    }
  }
  const bool wasPlaying = m_isPlaying;
  CheckEnd();
  m_isPlaying = wasPlaying && !m_isFinished;
}

REGISTER_LIVE_ENGINE(CLiveRun, "live")

}  // namespace argos
