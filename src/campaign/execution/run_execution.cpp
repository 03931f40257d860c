#include <argos3/campaign/execution/run_execution.h>

#include <argos3/campaign/execution/collected_columns.h>
#include <argos3/campaign/execution/experiment_paths.h>
#include <argos3/campaign/execution/metric_collection.h>

#include <argos3/core/simulator/outputs/run_output.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/space.h>
#include <argos3/core/utility/configuration/configuration_document.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/exception_text.h>
#include <argos3/core/utility/errors/line_marks.h>
#include <argos3/core/utility/files/output_file.h>
#include <argos3/core/utility/logging/argos_log.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <new>
#include <string_view>
#include <utility>

namespace argos {

namespace {

constexpr int kFailure = 1;
constexpr int kRobotsStopped = 3;

using TClock = std::chrono::steady_clock;

Real GetSecondsSince(TClock::time_point start) {
  return std::chrono::duration<Real>(TClock::now() - start).count();
}

// of all threads of this process, s
Real GetCPUTime() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto toSeconds = [](const timeval& time) {
    return static_cast<Real>(time.tv_sec) + 1e-6 * static_cast<Real>(time.tv_usec);
  };
  return toSeconds(usage.ru_utime) + toSeconds(usage.ru_stime);
}

UInt64 GetPeakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<UInt64>(usage.ru_maxrss) << 10;
}

bool SetsThreads(const SSetting& setting) {
  constexpr std::string_view kEnd = "system/@threads";
  const std::string_view path = setting.Path;
  return path.size() >= kEnd.size() && path.substr(path.size() - kEnd.size()) == kEnd;
}

void Configure(CSimulator& simulator, const SRunSetup& setup, const SRunRequest& request) {
  simulator.SetExperimentFileName(setup.ExperimentFile);
  simulator.SetRandomSeed(request.Seed);
  for (const SSetting& setting : request.Settings) {
    simulator.AddOverride(setting.Path, MakeInputPathAbsolute(setting, setup.StartFolder));
  }
  const bool isFactor = std::any_of(request.Settings.begin(), request.Settings.end(), &SetsThreads);
  if (setup.Threads && !isFactor) {
    simulator.SetNumThreads(*setup.Threads);
  }
}

void ThrowIfOutputsFailed() {
  std::string text;
  for (const std::string& failure : TakeOutputFailures()) {
    text += (text.empty() ? "" : "\n") + failure;
  }
  if (!text.empty()) {
    THROW_ARGOSEXCEPTION(text);
  }
}

/* The stages of a run, in this order. */
class CExecution {
 public:
  CExecution(const SRunSetup& setup, const SRunRequest& request)
      : m_setup(setup), m_request(request), m_metrics(setup.Metrics) {}

  void Load() {
    if (chdir(m_request.Folder.c_str()) != 0) {
      THROW_ARGOSEXCEPTION("the folder \""
                           << m_request.Folder
                           << "\" of the run cannot be entered: " << std::strerror(errno));
    }
    Configure(m_simulator, m_setup, m_request);
    m_document.Parse(m_setup.ExperimentText, m_setup.ExperimentFile);
    MakeInputPathsAbsolute(m_document, m_setup.StartFolder);
    m_simulator.Load(m_document, true);
    m_metrics.Begin(m_simulator);
    if (auto output = m_metrics.MakeOutput()) {
      m_simulator.AddOutput(std::move(output));
    }
    m_result.StartUpTime = GetSecondsSince(m_start);
  }

  void Run() {
    const Real cpuTime = GetCPUTime();
    const TClock::time_point start = TClock::now();
    try {
      m_simulator.Execute();
    } catch (...) {
      Measure(start, cpuTime);
      throw;
    }
    Measure(start, cpuTime);
    m_metrics.Finish(m_simulator, m_result);
    m_result.Digest = m_simulator.GetSpace().ComputeDigest();
    if (!m_simulator.GetRobotFailures().IsEmpty()) {
      LOGERR << "[FATAL] errors have stopped robots:\n"
             << m_simulator.GetRobotFailures().Summarize() << std::flush;
    }
  }

  void Destroy() { m_simulator.Destroy(); }

  void Finish(bool isGood) {
    m_result.PeakMemory = GetPeakMemory();
    if (!isGood) {
      return;
    }
    ThrowIfOutputsFailed();
    CollectColumns(m_setup.Metrics, m_request.Folder, m_result);
    // robots that have failed in Destroy() are among them
    const bool hasFailures = !m_simulator.GetRobotFailures().IsEmpty();
    m_result.Status = hasFailures ? ERunStatus::RobotsStopped : ERunStatus::Done;
    m_result.ExitStatus = hasFailures ? kRobotsStopped : 0;
  }

  /* Calls a step; an exception becomes the status of the run. */
  template <typename STEP>
  bool Try(STEP&& step) {
    std::string text;
    try {
      step();
      return true;
    } catch (const std::bad_alloc&) {
      text = "not enough memory";
    } catch (...) {
      text = DescribeCurrentException();
    }
    m_result.ExitStatus = kFailure;
    m_result.Status = m_setup.Limits.Memory > 0 && SaysOutOfMemory(text) ? ERunStatus::OutOfMemory
                                                                         : ERunStatus::Failed;
    LOGERR << MarkLines(text) << std::endl;
    return false;
  }

  SRunResult& GetResult() { return m_result; }

 private:
  void Measure(TClock::time_point start, Real cpuTime) {
    m_result.WallTime = GetSecondsSince(start);
    m_result.CPUTime = GetCPUTime() - cpuTime;
    m_result.Ticks = m_simulator.GetSpace().GetSimulationClock();
    m_result.Robots = static_cast<UInt32>(m_simulator.GetSpace().GetControllableEntities().size());
  }

  TClock::time_point m_start = TClock::now();
  const SRunSetup& m_setup;
  const SRunRequest& m_request;
  CConfigurationDocument m_document;  // the experiment refers to it
  CSimulator m_simulator;
  CSimulator::CScope m_scope{m_simulator};
  CMetricCollection m_metrics;
  SRunResult m_result;
};

}  // namespace

bool SaysOutOfMemory(const std::string& text) {
  return text.find("not enough memory") != std::string::npos ||
         text.find("std::bad_alloc") != std::string::npos;
}

SRunResult ExecuteRun(const SRunSetup& setup, const SRunRequest& request) {
  CExecution execution(setup, request);
  const bool isExecuted =
      execution.Try([&] { execution.Load(); }) && execution.Try([&] { execution.Run(); });
  // after an error, too: loop functions close their files in Destroy()
  const bool isDestroyed = execution.Try([&] { execution.Destroy(); });
  execution.Try([&] { execution.Finish(isExecuted && isDestroyed); });
  LOG.Flush();
  LOGERR.Flush();
  std::fflush(nullptr);
  return execution.GetResult();
}

}  // namespace argos
