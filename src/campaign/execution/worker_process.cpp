#include <argos3/campaign/execution/worker_process.h>

#include <argos3/campaign/execution/run_messages.h>
#include <argos3/campaign/execution/worker.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/support/child_process.h>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <thread>

namespace argos {

namespace {

// a worker that is told to end kills its run and ends at once
constexpr std::chrono::seconds kPatience(2);
constexpr std::chrono::milliseconds kCheckPeriod(2);

/*
 * In the worker: the signals that stop a campaign are for the manager. No file is inherited: not
 * the database, and not the pipes of other workers, which would then never be closed.
 */
void LeaveManager(pid_t manager, int& requests, int& results) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != manager) {
    _exit(1);
  }
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2}) {
    std::signal(signal, SIG_IGN);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int first = std::min(requests, results);
  const int last = std::max(requests, results);
  close_range(STDERR_FILENO + 1, static_cast<unsigned>(first - 1), 0);
  close_range(static_cast<unsigned>(first + 1), static_cast<unsigned>(last - 1), 0);
  close_range(static_cast<unsigned>(last + 1), ~0U, 0);
}

}  // namespace

CWorkerProcess::CWorkerProcess(const SRunSetup& setup) {
  int requests[2] = {-1, -1};
  int results[2] = {-1, -1};
  if (pipe2(requests, O_CLOEXEC) != 0 || pipe2(results, O_CLOEXEC) != 0) {
    THROW_ARGOSEXCEPTION("the pipes of a worker cannot be opened: " << std::strerror(errno));
  }
  // buffered text would be written twice
  LOG.Flush();
  LOGERR.Flush();
  std::fflush(nullptr);
  const pid_t manager = getpid();
  m_process = fork();
  if (m_process == 0) {
    LeaveManager(manager, requests[0], results[1]);
    RunWorker(setup, requests[0], results[1]);
  }
  const int error = errno;
  close(requests[0]);
  close(results[1]);
  m_requests = requests[1];
  m_results = results[0];
  if (m_process < 0) {
    close(m_requests);
    close(m_results);
    THROW_ARGOSEXCEPTION("a worker cannot be started: " << std::strerror(error));
  }
  fcntl(m_results, F_SETFL, O_NONBLOCK);
}

CWorkerProcess::~CWorkerProcess() {
  close(m_requests);
  close(m_results);
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (m_process >= 0 && waitpid(m_process, nullptr, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > deadline) {
      kill(m_process, SIGKILL);
    }
    std::this_thread::sleep_for(kCheckPeriod);
  }
}

bool CWorkerProcess::Send(const std::string& encodedRequest) {
  ARGOS_ASSERT(m_process >= 0, "a worker that has ended gets no requests");
  return WriteMessage(m_requests, SMessage::EKind::Request, encodedRequest);
}

bool CWorkerProcess::Receive(std::vector<std::pair<UInt64, SRunResult>>& results) {
  const bool isOpen = m_reader.Fill(m_results);
  while (const std::optional<SMessage> message = m_reader.Take()) {
    if (message->Kind == SMessage::EKind::Error) {
      throw CARGoSException("a worker cannot execute runs\n" + message->Body);
    }
    results.push_back(DecodeResult(message->Body));
  }
  return isOpen;
}

std::string CWorkerProcess::AwaitDeath() {
  ARGOS_ASSERT(m_process >= 0, "the end of a worker is awaited once");
  const int status = AwaitEnd(m_process);
  m_process = -1;
  return DescribeEnd(status).Description;
}

}  // namespace argos
