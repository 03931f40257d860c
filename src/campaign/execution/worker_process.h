#ifndef ARGOS3_CAMPAIGN_EXECUTION_WORKER_PROCESS_H
#define ARGOS3_CAMPAIGN_EXECUTION_WORKER_PROCESS_H

#include <argos3/campaign/execution/message_stream.h>
#include <argos3/campaign/execution/run_request.h>
#include <argos3/campaign/execution/run_result.h>
#include <argos3/core/utility/non_copyable.h>

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace argos {

/** A worker, seen by the process that has started it. */
class CWorkerProcess : private CNonCopyable {
 public:
  /**
   * Forks: this process must have one thread.
   * @param setup  used by the fork.
   * @throws CARGoSException if no process can be started.
   */
  explicit CWorkerProcess(const SRunSetup& setup);
  /** Aborts what it executes; returns when the worker has ended. */
  ~CWorkerProcess();

  /** Largest request that is sent while others wait: it always fits in the pipe. */
  static constexpr size_t kMaxWaitingRequest = 16 << 10;

  /** @return false if the worker has died. */
  bool Send(const std::string& encodedRequest);
  /** Readable when results have arrived, or the worker has died. */
  int GetFile() const { return m_results; }
  /**
   * Takes the results that have arrived, with the ids of their requests; never waits.
   * @return false if the worker has died.
   * @throws CARGoSException with the worker's error if it could not start.
   */
  bool Receive(std::vector<std::pair<UInt64, SRunResult>>& results);
  /** Waits for the end of a worker that has died. @return "signal 9 (Killed)". */
  std::string AwaitDeath();

 private:
  pid_t m_process = -1;
  int m_requests = -1;
  int m_results = -1;
  CMessageReader m_reader;
};

}  // namespace argos

#endif
