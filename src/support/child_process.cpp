#include <argos3/support/child_process.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/errors/output_timeout.h>
#include <argos3/core/utility/non_copyable.h>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <system_error>
#include <thread>

extern char** environ;

namespace argos {

namespace {

// used by glibc, too, if PATH is not set
constexpr char kDefaultPath[] = "/bin:/usr/bin";
constexpr int kEndCheckPeriod = 20;  // ms
constexpr int kProgressCheckPeriod = 200;  // ms

bool IsProgram(const std::string& path) {
  struct stat information {};
  return stat(path.c_str(), &information) == 0 && S_ISREG(information.st_mode) &&
         access(path.c_str(), X_OK) == 0;
}

void Close(int& file) {
  if (file >= 0) {
    close(file);
  }
  file = -1;
}

// moves a file away from the standard streams, which may be closed in this process
int MoveUp(int file) {
  if (file < 0 || file > STDERR_FILENO) {
    return file;
  }
  const int moved = fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  close(file);
  return moved;
}

// counts all processes of the group; terminated ones when their parent has waited for them
std::chrono::milliseconds ReadCPUTimeOfGroup(pid_t group) {
  long ticks = 0;
  std::error_code error;
  for (std::filesystem::directory_iterator entry("/proc", error), end; !error && entry != end;
       entry.increment(error)) {
    std::ifstream file(entry->path() / "stat");
    std::string line;
    if (!std::getline(file, line)) {
      continue;
    }
    // the name may contain anything
    std::istringstream words(line.substr(std::min(line.rfind(')') + 1, line.size())));
    std::string state;
    long parent = 0;
    long itsGroup = 0;
    words >> state >> parent >> itsGroup;
    constexpr int kSkipped = 8;  // session, terminal and its group, flags, four numbers of faults
    std::string skipped;
    for (int i = 0; i < kSkipped; ++i) {
      words >> skipped;
    }
    long user = 0;
    long system = 0;
    long userOfChildren = 0;
    long systemOfChildren = 0;
    words >> user >> system >> userOfChildren >> systemOfChildren;
    if (words && itsGroup == group) {
      ticks += user + system + userOfChildren + systemOfChildren;
    }
  }
  return std::chrono::milliseconds(1000 * ticks / sysconf(_SC_CLK_TCK));
}

// actions of posix_spawn() in the child, freed by the destructor
class CSpawnPlan : private CNonCopyable {
 public:
  CSpawnPlan() {
    posix_spawn_file_actions_init(&Actions);
    posix_spawnattr_init(&Attributes);
  }
  ~CSpawnPlan() {
    posix_spawn_file_actions_destroy(&Actions);
    posix_spawnattr_destroy(&Attributes);
  }

  // gives the child a process group of its own, in which no signal is blocked or ignored
  void SetOwnGroup() {
    sigset_t signals;
    sigemptyset(&signals);
    posix_spawnattr_setsigmask(&Attributes, &signals);
    for (const int signal : {SIGPIPE, SIGINT, SIGTERM, SIGQUIT, SIGHUP, SIGALRM}) {
      sigaddset(&signals, signal);
    }
    posix_spawnattr_setsigdefault(&Attributes, &signals);
    posix_spawnattr_setpgroup(&Attributes, 0);
    posix_spawnattr_setflags(
        &Attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  }

  posix_spawn_file_actions_t Actions;
  posix_spawnattr_t Attributes;
};

// searches the program as FindProgram() does; no files but the standard streams are inherited
pid_t Spawn(const std::vector<std::string>& arguments, const std::string& directory,
            CSpawnPlan& plan) {
  std::string program = FindProgram(arguments.at(0));
  if (program.empty()) {
    THROW_ARGOSEXCEPTION("The program \"" << arguments[0] << "\" cannot be started: "
                                          << "there is no such executable file");
  }
  std::vector<std::string> copies = arguments;  // posix_spawn() takes them as not constant
  std::vector<char*> pointers;
  for (std::string& copy : copies) {
    pointers.push_back(copy.data());
  }
  pointers.push_back(nullptr);
  // users' code may have opened files without O_CLOEXEC
  posix_spawn_file_actions_addclosefrom_np(&plan.Actions, STDERR_FILENO + 1);
  if (!directory.empty()) {
    // a relative path of the program counts from the working directory of this process
    program = std::filesystem::absolute(program).string();
    posix_spawn_file_actions_addchdir_np(&plan.Actions, directory.c_str());
  }
  pid_t process = -1;
  const int error = posix_spawn(&process, program.c_str(), &plan.Actions, &plan.Attributes,
                                pointers.data(), environ);
  if (error != 0) {
    THROW_ARGOSEXCEPTION("The program \"" << program
                                          << "\" cannot be started: " << std::strerror(error));
  }
  return process;
}

using TFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

TFile OpenTemporaryFile() {
  TFile file(std::tmpfile(), &std::fclose);
  if (file == nullptr) {
    THROW_ARGOSEXCEPTION("no temporary file can be created: " << std::strerror(errno));
  }
  return file;
}

std::string ReadAll(std::FILE* file) {
  std::rewind(file);
  std::string text;
  std::array<char, 4096> block{};
  for (size_t size = 0; (size = std::fread(block.data(), 1, block.size(), file)) > 0;) {
    text.append(block.data(), size);
  }
  text.erase(text.find_last_not_of('\n') + 1);
  return text;
}

}  // namespace

std::string FindProgram(const std::string& name) {
  if (name.empty()) {
    return "";
  }
  if (name.find('/') != std::string::npos) {
    return IsProgram(name) ? name : "";
  }
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : kDefaultPath);
  std::string folder;
  while (std::getline(folders, folder, ':')) {
    std::string candidate = (folder.empty() ? "." : folder) + "/" + name;
    if (IsProgram(candidate)) {
      return candidate;
    }
  }
  return "";
}

int AwaitEnd(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

SProcessEnd DescribeEnd(int status) {
  if (WIFEXITED(status)) {
    return {WEXITSTATUS(status) == 0, "exit status " + std::to_string(WEXITSTATUS(status))};
  }
  const int signal = WTERMSIG(status);
  return {false, "signal " + std::to_string(signal) + " (" + strsignal(signal) + ")"};
}

SProgramOutput RunProgram(const std::vector<std::string>& arguments) {
  // files, because a full pipe would stop the program
  const TFile out = OpenTemporaryFile();
  const TFile err = OpenTemporaryFile();
  CSpawnPlan plan;
  posix_spawn_file_actions_adddup2(&plan.Actions, fileno(out.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&plan.Actions, fileno(err.get()), STDERR_FILENO);
  const int status = AwaitEnd(Spawn(arguments, "", plan));
  return {DescribeEnd(status).IsSuccess, ReadAll(out.get()), ReadAll(err.get())};
}

CChildProcess::CChildProcess(const std::vector<std::string>& arguments,
                             const std::string& directory) {
  int sockets[2] = {-1, -1};
  int pipes[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0 ||
      pipe2(pipes, O_CLOEXEC) != 0) {
    const int error = errno;
    Close(sockets[0]);
    Close(sockets[1]);
    THROW_ARGOSEXCEPTION("The program \"" << arguments.at(0)
                                          << "\" cannot be started: " << std::strerror(error));
  }
  m_input = MoveUp(sockets[0]);
  m_errors = MoveUp(pipes[0]);
  int childInput = MoveUp(sockets[1]);
  int childErrors = MoveUp(pipes[1]);
  fcntl(m_errors, F_SETFL, O_NONBLOCK);
  try {
    Start(arguments, directory, childInput, childErrors);
  } catch (...) {
    for (int* file : {&m_input, &m_errors, &childInput, &childErrors}) {
      Close(*file);
    }
    throw;
  }
  Close(childInput);
  Close(childErrors);
}

void CChildProcess::Start(const std::vector<std::string>& arguments, const std::string& directory,
                          int input, int errors) {
  CSpawnPlan plan;
  posix_spawn_file_actions_adddup2(&plan.Actions, input, STDIN_FILENO);
  posix_spawn_file_actions_addopen(&plan.Actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&plan.Actions, errors, STDERR_FILENO);
  plan.SetOwnGroup();
  m_id = Spawn(arguments, directory, plan);
  m_isRunning = true;
}

CChildProcess::~CChildProcess() {
  Kill();
  Close(m_input);
  Close(m_errors);
}

void CChildProcess::Kill() {
  if (m_isRunning) {
    kill(-m_id, SIGKILL);
    Finish();
  }
}

bool CChildProcess::Write(const void* data, std::size_t size) {
  const char* from = static_cast<const char*>(data);
  NoteProgress();
  while (size > 0 && m_input >= 0) {
    // a child whose messages are not read would wait, and not read its input
    std::array<pollfd, 2> files = {pollfd{m_input, POLLOUT, 0}, pollfd{m_errors, POLLIN, 0}};
    const int count = poll(files.data(), files.size(), kProgressCheckPeriod);
    if (count < 0) {
      if (errno != EINTR) {
        return false;
      }
      continue;
    }
    if (count == 0) {
      CheckProgress();
      continue;
    }
    if (files[1].revents != 0 && !ReadErrors()) {
      Close(m_errors);  // poll() ignores negative numbers
    }
    if (files[0].revents != 0) {
      const ssize_t sent = send(m_input, from, size, MSG_NOSIGNAL | MSG_DONTWAIT);
      if (sent >= 0) {
        from += sent;
        size -= static_cast<std::size_t>(sent);
        NoteProgress();
      } else if (errno != EAGAIN && errno != EINTR) {
        return false;
      }
    }
  }
  return size == 0;
}

SProcessEnd CChildProcess::Finish() {
  if (!m_isRunning) {
    return m_end;
  }
  Close(m_input);
  NoteProgress();
  ReadErrorsUntilEnd();
  while (!HasEnded()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(kEndCheckPeriod));
    CheckProgress();
  }
  int status = 0;
  pid_t ended = 0;
  do {
    ended = waitpid(m_id, &status, 0);
  } while (ended < 0 && errno == EINTR);
  m_isRunning = false;
  // users' code may wait for all children, or ignore SIGCHLD
  m_end = ended == m_id ? DescribeEnd(status) : SProcessEnd{false, "unknown exit status"};
  if (m_hasHung) {
    m_end = {false, "no sign of life for " + DescribeOutputTimeout() + ": it was killed"};
  }
  return m_end;
}

bool CChildProcess::HasEnded() const {
  siginfo_t information{};
  return waitid(P_PID, static_cast<id_t>(m_id), &information, WEXITED | WNOHANG | WNOWAIT) != 0 ||
         information.si_pid == m_id;
}

void CChildProcess::NoteProgress() {
  m_idleStart = std::chrono::steady_clock::now();
  m_lastCheck = m_idleStart;
  m_idleStartCPU = std::chrono::milliseconds(-1);  // read at the first check
}

void CChildProcess::CheckProgress() {
  const auto now = std::chrono::steady_clock::now();
  if (m_hasHung || now - m_lastCheck < std::chrono::milliseconds(kProgressCheckPeriod)) {
    return;
  }
  m_lastCheck = now;
  const std::chrono::milliseconds limit = GetOutputTimeout();
  const std::chrono::milliseconds used = ReadCPUTimeOfGroup(m_id);
  if (m_idleStartCPU.count() < 0) {
    m_idleStartCPU = used;
  }
  // a child that only waits uses some, too
  constexpr int kShare = 100;
  if (used - m_idleStartCPU >= limit / kShare) {
    NoteProgress();
  } else if (now - m_idleStart > limit) {
    m_hasHung = true;
    kill(-m_id, SIGKILL);
  }
}

// ends when the child closes its standard error or ends: its own children may keep the stream open
void CChildProcess::ReadErrorsUntilEnd() {
  while (m_errors >= 0) {
    pollfd file = {m_errors, POLLIN, 0};
    const int count = poll(&file, 1, kEndCheckPeriod);
    const bool hasEnded = HasEnded();
    CheckProgress();
    if ((count > 0 && !ReadErrors()) || (hasEnded && count == 0)) {
      Close(m_errors);
    }
  }
}

bool CChildProcess::ReadErrors() {
  std::array<char, 4096> buffer{};
  const ssize_t count = read(m_errors, buffer.data(), buffer.size());
  if (count <= 0) {
    return count < 0 && (errno == EAGAIN || errno == EINTR);
  }
  m_errorText.append(buffer.data(), static_cast<std::size_t>(count));
  if (m_errorText.size() > 2 * kErrorTextSize) {
    m_errorText.erase(0, m_errorText.size() - kErrorTextSize);
    m_isErrorTextCut = true;
  }
  return true;
}

std::string CChildProcess::GetErrorText() const {
  std::string text = m_errorText;
  bool isCut = m_isErrorTextCut;
  if (text.size() > kErrorTextSize) {
    text.erase(0, text.size() - kErrorTextSize);
    isCut = true;
  }
  const std::size_t end = text.find('\n');
  if (isCut && end != std::string::npos && end + 1 < text.size()) {
    text.erase(0, end + 1);
  }
  text.erase(text.find_last_not_of(" \t\r\n") + 1);
  return text;
}

}  // namespace argos
