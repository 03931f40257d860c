#include <argos3/program/command_line.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/loading/loading_check.h>
#include <argos3/core/simulator/outputs/run_outputs.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/program/argos_command_line_arg_parser.h>
#include <argos3/program/catalogue/libraries_of.h>
#include <argos3/program/catalogue/log_silence.h>
#include <argos3/program/catalogue/schema.h>
#include <argos3/program/catalogue/version_text.h>
#include <argos3/program/crash_handler.h>
#include <argos3/program/exit_guard.h>
#include <argos3/program/progress.h>
#include <argos3/program/query_plugins.h>
#include <argos3/program/shell_documents.h>
#include <argos3/program/shielded_check.h>
#include <argos3/program/stop_signals.h>
#include <argos3/support/exit_status.h>

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <vector>

namespace argos {

namespace {

using SOptions = CARGoSCommandLineArgParser::SOptions;

constexpr int kFailure = 1;
// the run ended normally, but errors stopped robots
constexpr int kRobotsStopped = 3;

void FlushLogs() {
  LOG.Flush();
  LOGERR.Flush();
}

std::string DescribeFailure(const std::string& stream) {
  const std::string reason = errno == 0 ? "" : std::string(": ") + std::strerror(errno);
  return stream + " cannot be written completely" + reason;
}

// @return one line for each output that could not be written, each line once
std::string TakeFailedOutputs() {
  std::vector<std::string> failures = TakeOutputFailures();
  for (CARGoSLog* log : {&LOG, &LOGERR}) {
    failures.push_back(log->TakeFailure());
  }
  std::string text;
  for (const std::string& failure : failures) {
    text += (text.empty() || failure.empty() ? "" : "\n") + failure;
  }
  return text;
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
    text = DescribeFailure(name);
  }
  if (!text.empty()) {
    THROW_ARGOSEXCEPTION(text);
  }
}

void PrintError(const std::string& what) {
  CARGoSLog& log = LOGERR.HasFailed() && !LOG.HasFailed() ? LOG : LOGERR;
  log << what << std::endl;
  FlushLogs();
}

/* Calls a step and prints its exception. @return true if it threw nothing. */
template <typename STEP>
bool Try(STEP&& step) {
  try {
    step();
    return true;
  } catch (const std::bad_alloc&) {
    PrintError("[FATAL] not enough memory");
  } catch (const std::exception& ex) {
    PrintError(MarkLines(ex.what()));
  } catch (...) {
    PrintError("[FATAL] an exception that is not a std::exception was thrown");
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
class CLogLevelScope {
 public:
  explicit CLogLevelScope(ELogLevel level) {
    FlushLogs();
    CLogControl::SetLevel(level);
  }
  ~CLogLevelScope() {
    FlushLogs();
    CLogControl::SetLevel(m_previous);
  }
  CLogLevelScope(const CLogLevelScope&) = delete;
  CLogLevelScope& operator=(const CLogLevelScope&) = delete;

 private:
  ELogLevel m_previous = CLogControl::GetLevel();
};

// messages about loaded libraries would be among the text that is asked for
void LoadLibrariesSilently(const SOptions& options) {
  const CLogSilence silence;
  CDynamicLoading::LoadAllLibraries();
  if (!options.ExperimentFile.empty()) {
    LoadLibrariesOf(options.ExperimentFile);
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

void LoadExperiment(CSimulator& simulator, const SOptions& options) {
  CDynamicLoading::LoadAllLibraries();
  ApplyRunOptions(simulator, options);
  if (!options.RecordFile.empty()) {
    simulator.AddOutput("recording", {{"file", options.RecordFile}});
  }
  if (!options.VideoFile.empty()) {
    simulator.AddVideo(options.VideoFile, options.VideoSpeed);
  }
  for (const auto& [path, value] : options.Overrides) {
    simulator.AddOverride(path, value);
  }
  if (!options.CSVFolder.empty()) {
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

/* Runs the experiment until it ends or is stopped by a signal. @return wall time, s. */
Real Execute(CSimulator& simulator, const SOptions& options) {
  CProgressLine progress(simulator, options.ProgressPeriod);
  simulator.SetTickObserver([&progress](CSimulator& running) {
    ThrowIfLogsFailed();
    progress.Update();
    if (CStopSignals::WasStopped()) {
      running.Terminate();
    }
  });
  const auto start = std::chrono::steady_clock::now();
  try {
    simulator.Execute();
  } catch (...) {
    simulator.SetTickObserver(nullptr);
    throw;
  }
  const std::chrono::duration<Real> wall = std::chrono::steady_clock::now() - start;
  simulator.SetTickObserver(nullptr);
  FlushLogs();
  return wall.count();
}

/* Prints how many robots errors have stopped, and each of the errors once. */
void PrintFailedRobots(CSimulator& simulator) {
  if (simulator.GetRobotFailures().IsEmpty()) {
    return;
  }
  const std::vector<CControllableEntity*>& robots = simulator.GetSpace().GetControllableEntities();
  size_t stopped = 0;
  size_t quarantined = 0;
  for (const CControllableEntity* robot : robots) {
    stopped += robot->IsStopped() ? 1 : 0;
    quarantined += robot->IsQuarantined() ? 1 : 0;
  }
  LOGERR << fmt::format("[FATAL] {} of {} robots are stopped because of errors", stopped,
                        robots.size())
         << (quarantined > 0 ? fmt::format(", {} of them in quarantine", quarantined) : "")
         << "; all errors of robots in this run:\n"
         << simulator.GetRobotFailures().Summarize();
  LOGERR.Flush();
}

/* How the wall time divides into the simulation and the outputs, if there are any. */
std::string DescribeOutputTime(const CRunOutputs& outputs, Real wallSeconds) {
  return outputs.IsEmpty()
             ? std::string()
             : fmt::format(": {:.3g} s for the simulation, {:.3g} s for its outputs",
                           std::max(0.0, wallSeconds - outputs.GetSeconds()), outputs.GetSeconds());
}

void PrintSummary(CSimulator& simulator, Real wallSeconds, bool digest) {
  CSpace& space = simulator.GetSpace();
  const Real simulated = space.GetSimulationClock() * simulator.GetTickLength();
  const size_t robots = space.GetControllableEntities().size();
  LOG << fmt::format(
             "[INFO] simulated {:.6g} s in {:.3g} s of wall time (real-time factor {:.3g}, {} "
             "robot{})",
             simulated, wallSeconds, wallSeconds > 0.0 ? simulated / wallSeconds : 0.0, robots,
             robots == 1 ? "" : "s")
      << DescribeOutputTime(simulator.GetOutputs(), wallSeconds) << std::endl;
  LOG.Flush();
  PrintFailedRobots(simulator);
  if (digest) {
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
  const bool isGood = Try([&] {
    LoadExperiment(simulator, options);
    const size_t robots = simulator.GetSpace().GetControllableEntities().size();
    LOG << fmt::format("[INFO] {}: no errors found; {} robot{}; it was not run",
                       options.ExperimentFile, robots, robots == 1 ? "" : "s")
        << std::endl;
  });
  const bool isDestroyed = Try([&] { simulator.Destroy(); });
  return isGood && isDestroyed ? 0 : kFailure;
}

int RunExperiment(const SOptions& options) {
  const CLogLevelScope level(options.LogLevel);
  CSimulator& simulator = CSimulator::GetInstance();
  CExitGuard exitGuard(simulator);
  int status = 0;
  const bool loaded = Try([&] { LoadExperiment(simulator, options); });
  const bool executed = loaded && Try([&] {
                          const CStopSignals stopSignals;
                          exitGuard.Renew();
                          const Real wallSeconds = Execute(simulator, options);
                          if (const int signal = CStopSignals::GetSignal(); signal != 0) {
                            status = kSignalStatus + signal;
                            LOG << "[INFO] stopped by SIG" << sigabbrev_np(signal) << " after tick "
                                << simulator.GetSpace().GetSimulationClock() << std::endl;
                          }
                          PrintSummary(simulator, wallSeconds, options.Digest);
                        });
  // after an error, too: loop functions close their files in Destroy()
  const bool destroyed = Try([&] { simulator.Destroy(); });
  if (!executed || !destroyed) {
    return kFailure;
  }
  // robots that have failed in Destroy() are among them
  return status == 0 && !simulator.GetRobotFailures().IsEmpty() ? kRobotsStopped : status;
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
    default:
      return options.Check ? CheckExperiment(options) : RunExperiment(options);
  }
  return 0;
}

}  // namespace

int RunCommandLine(int argc, const char* const* argv, const char* program) noexcept {
  int status = kFailure;
  try {
    Try([&] {
      CARGoSCommandLineArgParser parser;
      parser.Parse(argc, argv);
      if (parser.GetOptions().Check && program != nullptr && !IsInShieldedCheck()) {
        status = RunShieldedCheck(program, argv);
        return;
      }
      if (parser.GetOptions().NoColor) {
        LOG.DisableColoredOutput();
        LOGERR.DisableColoredOutput();
      }
      SetUpLogs(parser.GetOptions());
      if (!parser.GetOptions().NoCrashHandler) {
        CCrashHandler::Install();
        CCrashHandler::SetLogFiles(parser.GetOptions().LogFile, parser.GetOptions().LogErrFile);
      }
      status = Act(parser.GetOptions());
    });
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
