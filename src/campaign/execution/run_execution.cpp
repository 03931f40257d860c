#include <argos3/campaign/execution/run_execution.h>

#include <argos3/campaign/execution/collected_columns.h>
#include <argos3/campaign/execution/experiment_paths.h>
#include <argos3/campaign/execution/metric_collection.h>

#include <argos3/core/simulator/context/current.h>
#include <argos3/core/simulator/loading/loading_check.h>
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
#include <fstream>
#include <new>
#include <string>
#include <utility>
#include <vector>

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

// since ForgetPeakMemory(); bytes
UInt64 GetPeakMemory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<UInt64>(usage.ru_maxrss) << 10;
}

// Linux then counts from what is resident now. Without it (a container may forbid it) the peak is
// that of the process, which has executed other runs if they share one
void ForgetPeakMemory() {
  std::ofstream("/proc/self/clear_refs") << '5';
}

void Configure(CSimulator& simulator, const SRunSetup& setup, const SRunRequest& request) {
  simulator.SetExperimentFileName(setup.ExperimentFile);
  simulator.SetRandomSeed(request.Seed);
  for (const SSetting& setting : request.Settings) {
    simulator.AddOverride(setting.Path, MakeInputPathAbsolute(setting, setup.StartFolder));
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

/*
 * The stages of a run, in this order, in the default simulator of the process without a scope, as
 * in argos3: it is what CSimulator::GetInstance() has returned to static objects of users'
 * libraries, which were loaded before, and what it returns to helper threads.
 */
class CExecution {
 public:
  CExecution(const SRunSetup& setup, const SRunRequest& request)
      : m_setup(setup), m_request(request), m_metrics(setup.Metrics) {
    ForgetPeakMemory();
  }
  ~CExecution() {
    m_simulator.SetTickObserver(nullptr);
    // those that users' code has created in this run; another run of this process begins without
    for (const std::string& id : m_registry.ListCategories()) {
      if (std::find(m_categories.begin(), m_categories.end(), id) == m_categories.end()) {
        m_registry.RemoveCategory(id);
      }
    }
  }
  CExecution(const CExecution&) = delete;
  CExecution& operator=(const CExecution&) = delete;

  void Load() {
    if (chdir(m_request.Folder.c_str()) != 0) {
      THROW_ARGOSEXCEPTION("the folder \""
                           << m_request.Folder
                           << "\" of the run cannot be entered: " << std::strerror(errno));
    }
    Configure(m_simulator, m_setup, m_request);
    ParseExperiment(m_setup, m_document);
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
  CSimulator& m_simulator = CurrentSimulator();
  CRandom::CRegistry& m_registry = CRandom::GetCurrentRegistry();
  std::vector<std::string> m_categories = m_registry.ListCategories();
  CMetricCollection m_metrics;
  SRunResult m_result;
};

}  // namespace

bool SaysOutOfMemory(const std::string& text) {
  return text.find("not enough memory") != std::string::npos ||
         text.find("std::bad_alloc") != std::string::npos;
}

bool LoadRun(const SRunSetup& setup, const SRunRequest& request) {
  const CLoadingCheck check;
  CExecution execution(setup, request);
  const bool isLoaded = execution.Try([&] { execution.Load(); });
  const bool isDestroyed = execution.Try([&] { execution.Destroy(); });
  LOG.Flush();
  LOGERR.Flush();
  std::fflush(nullptr);
  return isLoaded && isDestroyed;
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
