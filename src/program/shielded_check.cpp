#include <argos3/program/shielded_check.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/run/run_status.h>
#include <argos3/support/child_process.h>
#include <argos3/support/scratch_folder.h>

#include <dlfcn.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

extern char** environ;

namespace argos {

namespace {

namespace fs = std::filesystem;

constexpr char kFolderVariable[] = "ARGOS_SHIELDED_CHECK";
constexpr char kRaise[] = "argos3_raise_write_shield";

// beside the library that has this code
std::string FindShield() {
  Dl_info information;
  if (dladdr(reinterpret_cast<const void*>(&IsInShieldedCheck), &information) == 0) {
    THROW_ARGOSEXCEPTION("the folder of the program's libraries is not known");
  }
  const fs::path path =
      fs::absolute(information.dli_fname).parent_path() / "on_demand" / "libargos3_write_shield.so";
  if (access(path.c_str(), R_OK) != 0) {
    THROW_ARGOSEXCEPTION("a check needs the library \"" << path.string()
                                                        << "\": " << std::strerror(errno));
  }
  return path.string();
}

std::vector<std::string> MakeEnvironment(const std::string& folder) {
  std::string preloaded = "LD_PRELOAD=" + FindShield();
  std::vector<std::string> variables;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string text = *variable;
    if (text.rfind("LD_PRELOAD=", 0) == 0) {
      preloaded += ':' + text.substr(text.find('=') + 1);
    } else {
      variables.push_back(text);
    }
  }
  variables.push_back(preloaded);
  variables.push_back(std::string(kFolderVariable) + '=' + folder);
  return variables;
}

int Wait(pid_t process) {
  // like system(): a signal of the terminal ends the child, and then the folder is removed
  struct sigaction ignore {};
  ignore.sa_handler = SIG_IGN;
  struct sigaction oldInterrupt {};
  struct sigaction oldQuit {};
  sigaction(SIGINT, &ignore, &oldInterrupt);
  sigaction(SIGQUIT, &ignore, &oldQuit);
  const int status = AwaitEnd(process);
  sigaction(SIGINT, &oldInterrupt, nullptr);
  sigaction(SIGQUIT, &oldQuit, nullptr);
  return WIFEXITED(status) ? WEXITSTATUS(status)
                           : ToExitStatus(ERunStatus::Crashed, WTERMSIG(status));
}

}  // namespace

bool IsInShieldedCheck() {
  return std::getenv(kFolderVariable) != nullptr && dlsym(RTLD_DEFAULT, kRaise) != nullptr;
}

void RaiseWriteShield() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  using TRaise = void(const char*);
  reinterpret_cast<TRaise*>(dlsym(RTLD_DEFAULT, kRaise))(std::getenv(kFolderVariable));
}

int RunShieldedCheck(const char* program, const char* const* argv) {
  if (std::getenv(kFolderVariable) != nullptr) {
    // it would be started again and again
    THROW_ARGOSEXCEPTION(
        "the system has not preloaded the library that keeps the experiment's code "
        "from changing files: LD_PRELOAD has no effect here");
  }
  const CScratchFolder folder("argos3_check_");
  std::vector<std::string> variables = MakeEnvironment(folder.GetPath().string());
  std::vector<char*> environment;
  for (std::string& variable : variables) {
    environment.push_back(variable.data());
  }
  environment.push_back(nullptr);
  pid_t process = -1;
  const int error = posix_spawn(&process, program, nullptr, nullptr, const_cast<char**>(argv),
                                environment.data());
  if (error != 0) {
    THROW_ARGOSEXCEPTION("the process of the check cannot be started: " << std::strerror(error));
  }
  return Wait(process);
}

}  // namespace argos
