#include <argos3/campaign/execution/run_process.h>

#include <argos3/campaign/execution/run_execution.h>
#include <argos3/campaign/execution/run_messages.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/run/run.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>

namespace fs = std::filesystem;

namespace argos {

namespace {

constexpr int kLostResult = 1;  // exit status of a process whose results are not read any more
// ms; the first for processes that have closed their files. Others have died unnoticed if users'
// code has forked: the fork keeps the files open
constexpr int kDeathCheckPeriod = 20;
constexpr int kLongDeathCheckPeriod = 200;

void Close(int& file) {
  if (file >= 0) {
    close(file);
  }
  file = -1;
}

void OpenPipe(int (&ends)[2]) {
  if (pipe2(ends, O_CLOEXEC) != 0) {
    THROW_ARGOSEXCEPTION("a pipe for a run cannot be opened: " << std::strerror(errno));
  }
}

void Limit(int resource, rlim_t value) {
  const rlimit limit{value, value};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &limit);
}

// @return true if processes that users' code has forked have not ended
bool HasRunningChildren() {
  pid_t child = 0;
  do {
    child = waitpid(-1, nullptr, WNOHANG);
  } while (child > 0);
  return child == 0;
}

/* What is done in the child before anything else. */
void PrepareProcess(pid_t parent, const SRunLimits& limits, int output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) {
    _exit(kLostResult);
  }
  setpgid(0, 0);
  // they are ignored in a worker. SIGTERM stays so: batch systems send it to all processes of a
  // job, and the manager finishes what runs
  std::signal(SIGINT, SIG_DFL);
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  Limit(RLIMIT_CORE, 0);
  if (limits.Memory > 0) {
    Limit(RLIMIT_AS, limits.Memory);
  }
}

void RemoveFolder(const std::string& folder, EKeptFiles kept, const SRunResult& result) {
  // most runs leave an empty one
  if (rmdir(folder.c_str()) == 0) {
    return;
  }
  const bool isKept =
      kept == EKeptFiles::All || (kept == EKeptFiles::Failed && result.Status != ERunStatus::Done);
  if (!isKept) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
  }
}

}  // namespace

CRunProcess::~CRunProcess() {
  UInt64 peakMemory = 0;
  End(peakMemory);
}

std::optional<SRunResult> CRunProcess::Execute(const SRunRequest& request) {
  const bool wasUsed = m_process >= 0;
  EEnd end = EEnd::Result;
  std::optional<SRunResult> result = ExecuteOnce(request, end);
  if (end == EEnd::Death && wasUsed) {
    result = ExecuteOnce(request, end);
    // the next run begins with a new process again
    UInt64 peakMemory = 0;
    End(peakMemory);
  }
  return result;
}

std::optional<SRunResult> CRunProcess::ExecuteOnce(const SRunRequest& request, EEnd& end) {
  m_start = TClock::now();
  m_tail = COutputTail(m_setup.Limits.Output);
  mkdir(request.Folder.c_str(), 0777);
  if (m_process < 0) {
    Start(request);
  } else {
    WriteMessage(m_requests, SMessage::EKind::Request, EncodeRequest(request));
  }
  ++m_numRuns;
  SRunResult result;
  end = Supervise(request.Id, result);
  // remains of a failed run may harm others
  const bool isReusable = end == EEnd::Result && m_setup.Isolation == EIsolation::SharedProcess &&
                          result.Status == ERunStatus::Done;
  if (!isReusable) {
    UInt64 peakMemory = 0;
    const int status = End(peakMemory);
    if (end == EEnd::Timeout) {
      result.Status = ERunStatus::TimedOut;
      result.Signal = SIGKILL;
      m_tail.Add("\n[FATAL] killed: the run has reached its limit of wall time\n");
    } else if (end == EEnd::Death) {
      DescribeDeath(status, result);
    }
    result.PeakMemory = std::max(result.PeakMemory, peakMemory);
  }
  RemoveFolder(request.Folder, m_setup.Kept, result);
  if (end == EEnd::Abort) {
    return std::nullopt;
  }
  result.Log = m_tail.GetText();
  result.LogBytes = m_tail.GetNumBytes();
  result.TotalWallTime = std::chrono::duration<Real>(TClock::now() - m_start).count();
  return result;
}

void CRunProcess::Start(const SRunRequest& request) {
  ARGOS_ASSERT(m_process < 0, "the process of the last run has not ended");
  int requests[2] = {-1, -1};
  int results[2] = {-1, -1};
  int output[2] = {-1, -1};
  OpenPipe(requests);
  OpenPipe(results);
  OpenPipe(output);
  const pid_t parent = getpid();
  m_process = fork();
  if (m_process == 0) {
    PrepareProcess(parent, m_setup.Limits, output[1]);
    for (int* file : {&requests[1], &results[0], &output[0], &output[1]}) {
      Close(*file);
    }
    m_requests = requests[0];
    m_results = results[1];
    Serve(request);
  }
  const int error = errno;
  for (int* file : {&requests[0], &results[1], &output[1]}) {
    Close(*file);
  }
  m_requests = requests[1];
  m_results = results[0];
  m_output = output[0];
  m_reader = CMessageReader();
  m_numRuns = 0;
  if (m_process < 0) {
    CloseFiles();
    THROW_ARGOSEXCEPTION("a process for a run cannot be started: " << std::strerror(error));
  }
  // repeats what the child does, because it must have happened before the group is killed
  setpgid(m_process, m_process);
  fcntl(m_results, F_SETFL, O_NONBLOCK);
  fcntl(m_output, F_SETFL, O_NONBLOCK);
}

// In the child. It ends by _exit(): exit handlers and static objects are the worker's, too.
void CRunProcess::Serve(const SRunRequest& first) {
  const pid_t server = getpid();
  const auto execute = [this, server](const SRunRequest& request) {
    const SRunResult result = ExecuteRun(m_setup, request);
    // a process that users' code has forked, and that has returned from it: the run is its parent's
    if (getpid() != server) {
      _exit(0);
    }
    if (!WriteMessage(m_results, SMessage::EKind::Result, EncodeResult(request.Id, result))) {
      _exit(kLostResult);
    }
    // they would print, and write files, during the next run: that begins in a new process, and
    // these are killed with the group of this one
    if (HasRunningChildren()) {
      _exit(0);
    }
  };
  execute(first);
  CMessageReader reader;
  while (m_setup.Isolation == EIsolation::SharedProcess) {
    const std::optional<SMessage> message = reader.Take();
    if (message) {
      execute(DecodeRequest(message->Body));
    } else if (!reader.Fill(m_requests)) {
      break;
    }
  }
  _exit(0);
}

CRunProcess::EEnd CRunProcess::Supervise(UInt64 request, SRunResult& result) {
  ARGOS_ASSERT(m_process >= 0, "there is no process that executes run " << request);
  for (;;) {
    std::array<pollfd, 3> files = {pollfd{m_output, POLLIN, 0}, pollfd{m_results, POLLIN, 0},
                                   pollfd{m_abortFile, 0, 0}};
    const int count = poll(files.data(), files.size(), ComputeTimeout());
    if (count > 0 && files[2].revents != 0) {
      return EEnd::Abort;
    }
    if (count > 0 && files[0].revents != 0) {
      ReadOutput();
    }
    // before the results are read: what it has written before its end is in the pipe, which holds
    // no more than is read at once
    const bool hasDied = HasDied();
    if (m_results >= 0 && TakeResult(request, result)) {
      return EEnd::Result;
    }
    if (hasDied) {
      return EEnd::Death;
    }
    const std::chrono::duration<Real> wall = TClock::now() - m_start;
    if (m_setup.Limits.WallTime > 0.0 && wall.count() >= m_setup.Limits.WallTime) {
      return EEnd::Timeout;
    }
  }
}

// ms
int CRunProcess::ComputeTimeout() const {
  Real timeout = m_results < 0 ? kDeathCheckPeriod : kLongDeathCheckPeriod;
  if (m_setup.Limits.WallTime > 0.0) {
    const std::chrono::duration<Real> wall = TClock::now() - m_start;
    timeout = std::min(timeout, 1e3 * (m_setup.Limits.WallTime - wall.count()) + 1.0);
  }
  return static_cast<int>(std::max(0.0, timeout));
}

bool CRunProcess::TakeResult(UInt64 request, SRunResult& result) {
  const bool isOpen = m_reader.Fill(m_results);
  try {
    while (const std::optional<SMessage> message = m_reader.Take()) {
      auto [id, taken] = DecodeResult(message->Body);
      if (id != request) {
        continue;
      }
      result = std::move(taken);
      // text that was printed before is there
      while (m_output >= 0) {
        const UInt64 before = m_tail.GetNumBytes();
        ReadOutput();
        if (m_tail.GetNumBytes() == before) {
          break;
        }
      }
      return true;
    }
  } catch (const CARGoSException& error) {
    // users' code has written into the pipe
    m_tail.Add(std::string("\n") + error.what() + "\n");
    kill(m_process, SIGKILL);
    Close(m_results);
    return false;
  }
  if (!isOpen) {
    Close(m_results);
  }
  return false;
}

bool CRunProcess::HasDied() {
  siginfo_t information{};
  return waitid(P_PID, static_cast<id_t>(m_process), &information, WEXITED | WNOHANG | WNOWAIT) !=
             0 ||
         information.si_pid == m_process;
}

// once, so that a run that prints all the time cannot occupy this process
void CRunProcess::ReadOutput() {
  std::array<char, 1 << 16> buffer;
  const ssize_t count = read(m_output, buffer.data(), buffer.size());
  if (count > 0) {
    m_tail.Add(std::string_view(buffer.data(), static_cast<size_t>(count)));
  } else if (count == 0) {
    Close(m_output);
  }
}

void CRunProcess::DescribeDeath(int status, SRunResult& result) {
  const bool lackedMemory = m_setup.Limits.Memory > 0 && SaysOutOfMemory(m_tail.GetText());
  if (WIFSIGNALED(status)) {
    result.Signal = WTERMSIG(status);
    result.Status = lackedMemory ? ERunStatus::OutOfMemory : ERunStatus::Crashed;
    m_tail.Add("\n[FATAL] the process of the run was killed by signal " +
               std::to_string(result.Signal) + " (" + strsignal(result.Signal) + ")" +
               (result.Signal == SIGKILL ? "; perhaps the system was out of memory" : "") + "\n");
  } else {
    result.ExitStatus = WEXITSTATUS(status);
    result.Status = lackedMemory ? ERunStatus::OutOfMemory : ERunStatus::Failed;
    m_tail.Add("\n[FATAL] users' code ended the process of the run with exit status " +
               std::to_string(result.ExitStatus) + "\n");
  }
}

int CRunProcess::End(UInt64& peakMemory) {
  if (m_process < 0) {
    return 0;
  }
  // processes that the run has started are in its group. The leader is not reaped yet, so that no
  // other group can have its number
  kill(-m_process, SIGKILL);
  kill(m_process, SIGKILL);
  int status = 0;
  rusage usage{};
  while (wait4(m_process, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  peakMemory = static_cast<UInt64>(usage.ru_maxrss) << 10;
  m_process = -1;
  for (UInt64 before = ~UInt64(0); m_output >= 0 && before != m_tail.GetNumBytes();) {
    before = m_tail.GetNumBytes();
    ReadOutput();
  }
  CloseFiles();
  return status;
}

void CRunProcess::CloseFiles() {
  for (int* file : {&m_requests, &m_results, &m_output}) {
    Close(*file);
  }
}

}  // namespace argos
