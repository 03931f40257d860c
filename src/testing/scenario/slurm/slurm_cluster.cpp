#include "slurm_cluster.h"

#include <fmt/format.h>

#include <catch2/catch.hpp>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <pwd.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

namespace argos {

namespace {

using TClock = std::chrono::steady_clock;
constexpr std::chrono::seconds kStartPatience(30);
constexpr std::chrono::seconds kQueuePatience(90);
constexpr std::chrono::seconds kEndPatience(5);
constexpr std::chrono::milliseconds kPeriod(50);

// Debian has daemons in /usr/sbin, which is not in the PATH of all users
std::string FindDaemon(const std::string& name) {
  for (const char* folder : {"/usr/sbin/", "/usr/bin/", "/usr/local/sbin/", "/usr/local/bin/"}) {
    if (access((folder + name).c_str(), X_OK) == 0) {
      return folder + name;
    }
  }
  return "";
}

// of the system's choice; free until another program takes it
int FindFreePort() {
  const int file = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof(address);
  REQUIRE(bind(file, reinterpret_cast<sockaddr*>(&address), size) == 0);
  REQUIRE(getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) == 0);
  close(file);
  return ntohs(address.sin_port);
}

std::string GetShortHostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  const std::string whole = name.data();
  return whole.substr(0, whole.find('.'));
}

// children, also those that were adopted
std::vector<pid_t> ListChildren() {
  std::vector<pid_t> children;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream file(task.path() / "children");
    for (pid_t child = 0; file >> child;) {
      children.push_back(child);
    }
  }
  return children;
}

// waits for children that have ended
void Reap() {
  while (waitpid(-1, nullptr, WNOHANG) > 0) {
  }
}

}  // namespace

std::string ListMissingPrograms() {
  std::string missing;
  for (const char* name : {"munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel"}) {
    if (FindDaemon(name).empty()) {
      missing += (missing.empty() ? "" : ", ") + std::string(name);
    }
  }
  return missing;
}

CSlurmCluster::CSlurmCluster() {
  // processes of jobs become children of this one, so that they can be found
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  WriteConfiguration();
  const std::string munge = m_folder.Path("munge");
  Start({FindDaemon("munged"), "--foreground", "--force", "--socket=" + munge + "/socket",
         "--key-file=" + munge + "/key", "--pid-file=" + munge + "/pid",
         "--seed-file=" + munge + "/seed", "--log-file=" + munge + "/log", "--num-threads=1"});
  const auto end = TClock::now() + kStartPatience;
  while (!std::filesystem::exists(munge + "/socket") && TClock::now() < end) {
    std::this_thread::sleep_for(kPeriod);
  }
  Start({FindDaemon("slurmctld"), "-D", "-i"});
  Start({FindDaemon("slurmd"), "-D"});
  std::string state;
  while (state != "idle\n" && TClock::now() < end) {
    std::this_thread::sleep_for(kPeriod);
    state = Command("sinfo --noheader --format=%T").Out;
  }
  INFO(ReadLogs());
  REQUIRE(state == "idle\n");
}

CSlurmCluster::~CSlurmCluster() {
  // jobs end with their steps' processes; the daemons in reverse order
  Command("scancel --user=" + std::to_string(getuid()));
  for (size_t i = m_daemons.size(); i-- > 0;) {
    kill(m_daemons[i], SIGTERM);
    const auto end = TClock::now() + kEndPatience;
    while (waitpid(m_daemons[i], nullptr, WNOHANG) == 0) {
      if (TClock::now() > end) {
        kill(m_daemons[i], SIGKILL);
      }
      std::this_thread::sleep_for(kPeriod);
    }
  }
  // what they have started; its children come to this process in turn
  for (const auto end = TClock::now() + kEndPatience; TClock::now() < end;) {
    Reap();
    const std::vector<pid_t> rest = ListChildren();
    if (rest.empty()) {
      break;
    }
    for (const pid_t child : rest) {
      kill(child, SIGKILL);
    }
    std::this_thread::sleep_for(kPeriod);
  }
  prctl(PR_SET_CHILD_SUBREAPER, 0);
  unsetenv("SLURM_CONF");
}

void CSlurmCluster::WriteConfiguration() const {
  // munge refuses a folder that others cannot enter
  chmod(m_folder.Path(".").c_str(), 0755);
  for (const char* name : {"state", "spool", "munge"}) {
    std::filesystem::create_directory(m_folder.Path(name));
    chmod(m_folder.Path(name).c_str(), 0755);
  }
  std::string key(128, '\0');
  std::random_device random;
  for (char& byte : key) {
    byte = static_cast<char>(random());
  }
  chmod(m_folder.Write("munge/key", key).c_str(), 0600);
  const passwd* user = getpwuid(getuid());
  REQUIRE(user != nullptr);
  static constexpr char kText[] = R"(ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge/socket
SlurmctldPort={port}
SlurmdPort={nodePort}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SlurmdParameters=config_overrides
SchedulerType=sched/builtin
SchedulerParameters=sched_interval=1
ReturnToService=2
KillWait=2
NodeName={host} NodeAddr=127.0.0.1 CPUs=4 State=UNKNOWN
PartitionName=test Nodes=ALL Default=YES MaxTime=INFINITE State=UP
)";
  const std::string file = m_folder.Write(
      "slurm.conf",
      fmt::format(
          kText, fmt::arg("host", GetShortHostName()), fmt::arg("user", user->pw_name),
          fmt::arg("folder", std::filesystem::path(m_folder.Path("x")).parent_path().string()),
          fmt::arg("port", FindFreePort()), fmt::arg("nodePort", FindFreePort())));
  setenv("SLURM_CONF", file.c_str(), 1);
}

void CSlurmCluster::Start(const std::vector<std::string>& arguments) {
  std::vector<char*> argv;
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  const std::string log = m_folder.Path("daemons.out");
  const pid_t parent = getpid();
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    if (getppid() == parent) {
      execv(argv[0], argv.data());
    }
    _exit(127);
  }
  m_daemons.push_back(child);
}

bool CSlurmCluster::AwaitEmptyQueue() const {
  const auto end = TClock::now() + kQueuePatience;
  while (TClock::now() < end) {
    const SProgramRun queue = Command("squeue --noheader");
    if (queue.Status == 0 && queue.Out.empty()) {
      return true;
    }
    std::this_thread::sleep_for(4 * kPeriod);
  }
  return false;
}

SProgramRun CSlurmCluster::Command(const std::string& command) const {
  SProgramRun run;
  const std::string out = m_folder.Path("command.out");
  const int status = std::system((command + " >" + out + " 2>&1").c_str());
  run.Status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.Out = m_folder.Read("command.out");
  return run;
}

std::string CSlurmCluster::ReadLogs() const {
  return m_folder.Read("daemons.out") + m_folder.Read("slurmctld.log") +
         m_folder.Read("slurmd.log");
}

}  // namespace argos
