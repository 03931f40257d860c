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
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/run/run.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace argos {

namespace {

// peak since ForgetPeakMemory(); bytes
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
  if (setup.HasLiveViews) {
    simulator.SetVisualization("live", {{"url_file", "auto"},
                                        {"control", "false"},
                                        {"play", "true"},
                                        {"speed", "0"},
                                        {"linger", "0"},
                                        {"open", "false"}});
  }
  for (const SSetting& setting : request.Settings) {
    simulator.AddOverride(setting.Path, MakeInputPathAbsolute(setting, setup.StartFolder));
  }
}

// users' code has created them in a run; another run of this process begins without
class CCategoryScope {
 public:
  ~CCategoryScope() {
    for (const std::string& id : m_registry.ListCategories()) {
      if (std::find(m_before.begin(), m_before.end(), id) == m_before.end()) {
        m_registry.RemoveCategory(id);
      }
    }
  }

 private:
  CRandom::CRegistry& m_registry = CRandom::GetCurrentRegistry();
  std::vector<std::string> m_before = m_registry.ListCategories();
};

/*
 * A run in the default simulator of the process without a scope, as in argos3: it is what
 * CSimulator::GetInstance() has returned to static objects of users' libraries, which were loaded
 * before, and what it returns to helper threads.
 */
class CExecution {
 public:
  CExecution(const SRunSetup& setup, const SRunRequest& request)
      : m_setup(setup), m_request(request), m_metrics(setup.Metrics) {
    ForgetPeakMemory();
    m_run.CollectWarnings();
    m_run.Load([this] { Load(); });
  }

  bool Check() { return m_run.Destroy(); }

  SRunResult Execute() {
    m_run.Execute();
    m_run.Do([this] { Summarize(); });
    m_run.Destroy();
    m_result.PeakMemory = GetPeakMemory();
    m_run.Do([this] { CollectOutputs(); });
    TakeSummary(m_run.Finish());
    return std::move(m_result);
  }

 private:
  void CollectOutputs() {
    if (const std::string failed = TakeFailedOutputs(); !failed.empty()) {
      THROW_ARGOSEXCEPTION(failed);
    }
    CollectColumns(m_setup.Metrics, m_request.Folder, m_result);
  }

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
  }

  void Summarize() {
    m_metrics.Finish(m_simulator, m_result);
    m_result.Digest = m_simulator.GetSpace().ComputeDigest();
    if (const std::string& errors = m_run.GetSummary().RobotErrors; !errors.empty()) {
      LOGERR << "[FATAL] errors have stopped robots:\n" << errors << std::flush;
    }
  }

  void TakeSummary(const SRunSummary& summary) {
    m_result.Status = summary.Status;
    // if there is no limit, the experiment is too large
    if (summary.Status == ERunStatus::OutOfMemory && m_setup.Limits.Memory == 0) {
      m_result.Status = ERunStatus::Failed;
    }
    m_result.ExitStatus = ToExitStatus(m_result.Status);
    m_result.StartUpTime = summary.StartUpTime;
    m_result.WallTime = summary.WallTime;
    m_result.CPUTime = summary.CPUTime;
    m_result.Ticks = summary.Ticks;
    m_result.Robots = summary.Robots;
    m_result.Error = summary.Failures.empty() ? "" : summary.Failures.back().Text;
    m_result.Warnings = summary.Warnings;
  }

  const SRunSetup& m_setup;
  const SRunRequest& m_request;
  CConfigurationDocument m_document;  // the experiment refers to it
  CSimulator& m_simulator = CurrentSimulator();
  const CCategoryScope m_categories;
  CMetricCollection m_metrics;
  SRunResult m_result;
  CRun m_run{m_simulator};
};

void FlushAll() {
  LOG.Flush();
  LOGERR.Flush();
  std::fflush(nullptr);
}

}  // namespace

bool LoadRun(const SRunSetup& setup, const SRunRequest& request) {
  const CLoadingCheck check;
  const bool isGood = CExecution(setup, request).Check();
  FlushAll();
  return isGood;
}

SRunResult ExecuteRun(const SRunSetup& setup, const SRunRequest& request) {
  SRunResult result = CExecution(setup, request).Execute();
  FlushAll();
  return result;
}

}  // namespace argos
