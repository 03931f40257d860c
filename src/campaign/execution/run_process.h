#ifndef ARGOS3_CAMPAIGN_EXECUTION_RUN_PROCESS_H
#define ARGOS3_CAMPAIGN_EXECUTION_RUN_PROCESS_H

#include <argos3/campaign/execution/message_stream.h>
#include <argos3/campaign/execution/output_tail.h>
#include <argos3/campaign/execution/run_request.h>
#include <argos3/campaign/execution/run_result.h>
#include <argos3/core/utility/non_copyable.h>

#include <sys/types.h>

#include <chrono>
#include <optional>

namespace argos {

/**
 * Executes runs in a forked process, under the limits of the setup.
 *
 * EIsolation::OwnProcess: each run has a process. EIsolation::SharedProcess: one process executes
 * them, one after another, until a run fails or it dies; the run that was executed when it died is
 * repeated alone in a process of its own, and that is its result, because an earlier run may have
 * broken the memory.
 *
 * A process of runs is the leader of a process group, which is killed with it. It has the limit of
 * memory (RLIMIT_AS), writes no core files, and dies if this process does. Its standard streams
 * are read here all the time, so that a run never waits for its output to be read.
 *
 * Fork copies one thread: this process must have no other, and no lock of one may be locked.
 */
class CRunProcess : private CNonCopyable {
 public:
  /**
   * @param setup      must outlive this object.
   * @param abortFile  a pipe; when its writer closes it, the present run is aborted.
   */
  CRunProcess(const SRunSetup& setup, int abortFile) : m_setup(setup), m_abortFile(abortFile) {}
  /** Kills. */
  ~CRunProcess();

  /**
   * Executes a run: creates its folder, and removes it if it is empty or not to be kept.
   * @return nothing if it was aborted.
   * @throws CARGoSException if no process can be started.
   */
  std::optional<SRunResult> Execute(const SRunRequest& request);

 private:
  using TClock = std::chrono::steady_clock;
  enum class EEnd { Result, Death, Timeout, Abort };

  /** @param end  how the run has ended. */
  std::optional<SRunResult> ExecuteOnce(const SRunRequest& request, EEnd& end);
  void Start(const SRunRequest& request);
  [[noreturn]] void Serve(const SRunRequest& first);
  EEnd Supervise(UInt64 request, SRunResult& result);
  int ComputeTimeout() const;
  bool TakeResult(UInt64 request, SRunResult& result);
  bool HasDied();
  void ReadOutput();
  void DescribeDeath(int status, SRunResult& result);
  /** Kills and reaps. @return the status of wait4(). */
  int End(UInt64& peakMemory);
  void CloseFiles();

  const SRunSetup& m_setup;
  int m_abortFile;
  pid_t m_process = -1;  // -1: none
  int m_requests = -1;
  int m_results = -1;  // -1: the process has closed it
  int m_output = -1;
  UInt32 m_numRuns = 0;  // runs of the process
  TClock::time_point m_start;  // start of the run
  CMessageReader m_reader;
  COutputTail m_tail{0};
};

}  // namespace argos

#endif
