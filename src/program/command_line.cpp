#include <argos3/program/command_line.h>

#include <argos3/core/simulator/context/library_attribute.h>
#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/argos_configuration.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/files/writing.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/non_copyable.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/program/argos_command_line_arg_parser.h>
#include <argos3/program/catalogue/log_silence.h>
#include <argos3/program/catalogue/schema.h>
#include <argos3/program/catalogue/version_text.h>
#include <argos3/program/crash_handler.h>
#include <argos3/program/exit_guard.h>
#include <argos3/program/page_export.h>
#include <argos3/program/progress.h>
#include <argos3/program/query_plugins.h>
#include <argos3/program/shell_documents.h>
#include <argos3/program/shielded_check.h>
#include <argos3/program/stop_signals.h>
#include <argos3/run/run.h>

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace argos {

namespace {

using SOptions = CARGoSCommandLineArgParser::SOptions;

constexpr int kFailure = ToExitStatus(ERunStatus::Failed);

void FlushLogs() {
  LOG.Flush();
  LOGERR.Flush();
}

std::string DescribeStreamFailure(const std::string& stream) {
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  return stream + " cannot be written completely" + reason;
}

/* Called after each tick: a run whose logs are lost ends. */
void ThrowIfLogsFailed() {
  if (LOG.HasFailed() || LOGERR.HasFailed()) {
    THROW_ARGOSEXCEPTION(TakeFailedOutputs());
  }
}

// what users' code has printed with C's functions; network file systems report some errors only
// when a file is closed
bool IsStreamWritten(std::FILE* stream) {
  const int copy = dup(fileno(stream));
  return std::fflush(stream) == 0 && std::ferror(stream) == 0 && (copy < 0 || close(copy) == 0);
}

// throws failures that were not reported before. @param log  behind the standard stream
void CheckStream(CARGoSLog& log, std::FILE* stream, const std::string& name) {
  log.Flush();
  log.GetStream().flush();
  log.EndRedirection();
  errno = 0;
  const bool isWritten = log.GetStream() && IsStreamWritten(stream);
  std::string text = TakeFailedOutputs();
  if (text.empty() && !log.HasFailed() && !isWritten) {
    text = DescribeStreamFailure(name);
  }
  if (!text.empty()) {
    THROW_ARGOSEXCEPTION(text);
  }
}

/* Calls a step and prints its exception. @return true if it threw nothing. */
template <typename STEP>
bool Try(STEP&& step) {
  try {
    step();
    return true;
  } catch (...) {
    PrintFailure(DescribeFailure());
  }
  return false;
}

void SetUpLogs(const SOptions& options) {
  if (!options.LogFile.empty()) {
    LOG.RedirectToFile(options.LogFile);
  }
  if (!options.LogErrFile.empty()) {
    LOGERR.RedirectToFile(options.LogErrFile);
  }
}

/* Sets which lines reach the logs during its lifetime. */
class CLogLevelScope : private CNonCopyable {
 public:
  explicit CLogLevelScope(ELogLevel level) {
    FlushLogs();
    CLogControl::SetLevel(level);
  }
  ~CLogLevelScope() {
    FlushLogs();
    CLogControl::SetLevel(m_previous);
  }

 private:
  ELogLevel m_previous = CLogControl::GetLevel();
};

void LoadLibrariesIn(TConfigurationNode& element) {
  LoadLibraryOf(element);
  TConfigurationNodeIterator it;
  for (it = it.begin(&element); it != it.end(); ++it) {
    LoadLibrariesIn(*it);
  }
}

// messages about loaded libraries would be among the text that is asked for
void LoadLibrariesSilently(const SOptions& options) {
  const CLogSilence silence;
  CDynamicLoading::LoadAllLibraries();
  if (!options.ExperimentFile.empty()) {
    CConfigurationDocument document;
    document.LoadFile(options.ExperimentFile);
    LoadLibrariesIn(document.GetRoot());
  }
}

// the version is shown even if a library cannot be loaded; its engines are then left out
void TryToLoadLibraries() {
  try {
    LoadLibrariesSilently({});
  } catch (const std::exception& error) {
    LOGERR << "[WARNING] " << error.what() << std::endl;
  }
}

void ApplyRunOptions(CSimulator& simulator, const SOptions& options) {
  if (options.Seed == UInt32(0)) {
    // a seed of 0 in the file selects a seed from the clock
    simulator.AddOverride("framework/experiment/@random_seed", "0");
  } else if (options.Seed) {
    simulator.SetRandomSeed(*options.Seed);
  }
  if (options.Threads) {
    simulator.SetNumThreads(*options.Threads);
  }
  if (options.Length) {
    simulator.SetLength(*options.Length);
  }
  if (options.Lenient) {
    simulator.AddOverride("framework/experiment/@lenient", "true");
  }
}

// viewers come and go, and the run does not wait for them
void SetLiveSocket(CSimulator& simulator, const std::string& file) {
  simulator.SetVisualization(
      "live",
      {{"url_file", file}, {"play", "true"}, {"speed", "0"}, {"linger", "0"}, {"open", "false"}});
}

// makes the part that runs the experiment in place of the file's visualization
void SetVisualization(CSimulator& simulator, const SOptions& options) {
  if (options.LivePort) {
    std::vector<std::pair<std::string, std::string>> attributes;
    if (*options.LivePort != 0) {
      attributes.emplace_back("port", std::to_string(*options.LivePort));
    }
    simulator.SetVisualization("live", attributes);
  } else if (!options.LiveURLFile.empty()) {
    SetLiveSocket(simulator, options.LiveURLFile);
  } else if (!options.CommandsFile.empty()) {
    simulator.SetVisualization("live", {{"commands", options.CommandsFile}});
    if (!options.Seed) {
      const std::unique_ptr<CReplay> recording(CFactory<CReplay>::New("recording"));
      simulator.SetRandomSeed(recording->ReadSeed(options.CommandsFile));
    }
  }
}

void LoadExperiment(CSimulator& simulator, const SOptions& options) {
  CDynamicLoading::LoadAllLibrariesByLabel();
  ApplyRunOptions(simulator, options);
  if (!options.RecordFile.empty()) {
    simulator.AddOutput("recording", {{"file", options.RecordFile}});
  }
  if (!options.VideoFile.empty()) {
    simulator.AddVideo(options.VideoFile, options.VideoSpeed);
  }
  SetVisualization(simulator, options);
  for (const auto& [path, value] : options.Overrides) {
    simulator.AddOverride(path, value);
  }
  if (!options.CSVFolder.empty()) {
    // else each of the tables would say it
    const std::string problem = FindFolderProblem(
        options.CSVFolder,
        CLoadingCheck::IsActive() ? EMissingFolder::WillBeCreated : EMissingFolder::IsCreated);
    if (!problem.empty()) {
      THROW_ARGOSEXCEPTION("--csv: " << problem);
    }
    simulator.AddOutput("table", {{"file", options.CSVFolder + "/robots.csv"}});
    simulator.AddOutput("metrics", {{"file", options.CSVFolder + "/metrics.csv"}});
  }
  if (options.Action == CARGoSCommandLineArgParser::ACTION_REPLAY) {
    simulator.LoadReplay(options.Replay, options.NoVisualization);
  } else {
    simulator.SetExperimentFileName(options.ExperimentFile);
    simulator.LoadExperiment(options.NoVisualization);
  }
  FlushLogs();
  ThrowIfLogsFailed();
}

/* Runs the experiment until it ends or is stopped by a signal. */
void Execute(CRun& run, CSimulator& simulator, const SOptions& options) {
  if (simulator.GetMaxSimulationClock() == 0 &&
      options.Action != CARGoSCommandLineArgParser::ACTION_REPLAY) {
    CLogControl::Notify(
        "the experiment has no length: it runs until its code ends it, or until Ctrl-C");
  }
  CProgressLine progress(simulator, options.ProgressPeriod);
  run.Execute([&progress](CSimulator& running) {
    ThrowIfLogsFailed();
    progress.Update();
    if (CStopSignals::WasStopped()) {
      running.Stop();
    }
  });
}

/* Prints how many robots errors have stopped, and each of the errors once. */
void PrintFailedRobots(const SRunSummary& summary) {
  if (summary.RobotErrors.empty()) {
    return;
  }
  LOGERR << fmt::format("[FATAL] {} of {} robots are stopped because of errors",
                        summary.StoppedRobots, summary.Robots)
         << (summary.QuarantinedRobots > 0
                 ? fmt::format(", {} of them in quarantine", summary.QuarantinedRobots)
                 : "")
         << "; all errors of robots in this run:\n"
         << summary.RobotErrors;
  LOGERR.Flush();
}

void PrintDigest(const CSpace& space) {
  // printed whatever the level, because it was asked for
  const CLogLevelScope all(ELogLevel::Info);
  const bool colored = LOG.IsColoredOutput();
  LOG.DisableColoredOutput();
  LOG << fmt::format("digest: {:016x}", space.ComputeDigest()) << std::endl;
  LOG.Flush();
  if (colored) {
    LOG.EnableColoredOutput();
  }
}

void PrintSummary(const SRunSummary& summary) {
  if (summary.Signal != 0) {
    CLogControl::Notify(
        fmt::format("stopped by SIG{} after tick {}", sigabbrev_np(summary.Signal), summary.Ticks));
  }
  CLogControl::Notify(DescribeRun(summary));
  if (summary.RobotsOutside > 0) {
    CLogControl::Notify(fmt::format(
        "{} of {} robot{} ended outside of the arena, among them \"{}\"; only walls stop robots",
        summary.RobotsOutside, summary.Robots, summary.Robots == 1 ? "" : "s",
        summary.FirstOutside));
  }
  PrintFailedRobots(summary);
}

/* Loads the experiment and destroys it. */
int CheckExperiment(const SOptions& options) {
  const CLogLevelScope level(options.LogLevel);
  const CLoadingCheck check;
  if (IsInShieldedCheck()) {
    RaiseWriteShield();
  }
  CSimulator& simulator = CSimulator::GetInstance();
  const CExitGuard exitGuard(simulator);
  CRun run(simulator);
  run.Load([&] {
    LoadExperiment(simulator, options);
    const size_t robots = simulator.GetSpace().GetControllableEntities().size();
    LOG << fmt::format("[INFO] {}: no errors found; {} robot{}; it was not run",
                       options.ExperimentFile, robots, robots == 1 ? "" : "s")
        << std::endl;
  });
  return run.Destroy() ? 0 : kFailure;
}

int RunExperiment(const SOptions& options) {
  const CLogLevelScope level(options.LogLevel);
  CSimulator& simulator = CSimulator::GetInstance();
  CExitGuard exitGuard(simulator);
  CRun run(simulator);
  if (run.Load([&] { LoadExperiment(simulator, options); })) {
    const CStopSignals stopSignals;
    exitGuard.Renew();
    Execute(run, simulator, options);
    run.SetSignal(CStopSignals::GetSignal());
    run.Do([&] {
      PrintSummary(run.GetSummary());
      if (options.Digest) {
        PrintDigest(simulator.GetSpace());
      }
    });
  }
  return run.Finish().GetExitStatus();
}

std::string Generate(const SOptions& options) {
  if (options.Generate == "man") {
    return MakeManPage();
  }
  if (options.Generate == "bash") {
    return MakeBashCompletion();
  }
  if (options.Generate == "zsh") {
    return MakeZshCompletion();
  }
  std::vector<std::string> words;
  if (options.Generate == "xpaths") {
    words = ListAttributePaths(options.ExperimentFile);
  } else {
    CDynamicLoading::LoadAllLibraries();
    words = ListPluginWords();
  }
  return fmt::format("{}\n", fmt::join(words, "\n"));
}

int Act(const SOptions& options) {
  switch (options.Action) {
    case CARGoSCommandLineArgParser::ACTION_GENERATE:
      LOG.DisableColoredOutput();
      LOG << Generate(options);
      break;
    case CARGoSCommandLineArgParser::ACTION_SHOW_HELP:
      LOG.DisableColoredOutput();
      LOG << CARGoSCommandLineArgParser::GetUsage();
      break;
    case CARGoSCommandLineArgParser::ACTION_SHOW_VERSION:
      TryToLoadLibraries();
      PrintPlain(DescribeVersion());
      break;
    case CARGoSCommandLineArgParser::ACTION_QUERY_PLUGINS:
      LoadLibrariesSilently(options);
      return QueryPlugins(options.Query, options.Json) ? 0 : kFailure;
    case CARGoSCommandLineArgParser::ACTION_MAKE_SCHEMA:
      LoadLibrariesSilently(options);
      PrintPlain(MakeSchema(options.SchemaFormat));
      break;
    case CARGoSCommandLineArgParser::ACTION_REPLAY:
      if (!options.HTMLFile.empty()) {
        ExportPage(options.Replay.File, options.HTMLFile,
                   CSimulator::GetInstance().GetInstallationDirectory());
        break;
      }
      return RunExperiment(options);
    default:
      return options.Check ? CheckExperiment(options) : RunExperiment(options);
  }
  return 0;
}

int ParseAndAct(int argc, const char* const* argv, const char* program) {
  CARGoSCommandLineArgParser parser;
  parser.Parse(argc, argv);
  const auto& options = parser.GetOptions();
  if (options.Check && program != nullptr && !IsInShieldedCheck()) {
    return RunShieldedCheck(program, argv);
  }
  if (options.NoColor) {
    LOG.DisableColoredOutput();
    LOGERR.DisableColoredOutput();
  }
  SetUpLogs(options);
  if (!options.NoCrashHandler) {
    CCrashHandler::Install();
    CCrashHandler::SetLogFiles(options.LogFile, options.LogErrFile);
  }
  return Act(options);
}

}  // namespace

int RunCommandLine(int argc, const char* const* argv, const char* program) noexcept {
  int status = kFailure;
  try {
    Try([&] { status = ParseAndAct(argc, argv, program); });
    // the error log comes last: it reports the other one
    const bool isOutWritten = Try([] { CheckStream(LOG, stdout, "the standard output"); });
    const bool isErrWritten = Try([] { CheckStream(LOGERR, stderr, "the standard error"); });
    status = isOutWritten && isErrWritten ? status : kFailure;
  } catch (...) {
    // printing the message failed
    status = kFailure;
  }
  return status;
}

}  // namespace argos
