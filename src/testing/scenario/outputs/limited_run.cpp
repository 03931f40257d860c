#include "limited_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace argos {

namespace {

constexpr std::chrono::milliseconds kPause(5);
constexpr std::chrono::minutes kPatience(2);

bool Redirect(int file, const std::string& path) {
  const int target = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  return target >= 0 && dup2(target, file) == file && close(target) == 0;
}

}  // namespace

pid_t StartProgram(const CTestFolder& folder, const std::vector<std::string>& arguments,
                   const SCircumstances& circumstances) {
  const std::string program = InBuildTree("bin/argos3");
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child > 0) {
    return child;
  }
  bool ready = chdir(folder.Path("").c_str()) == 0;
  ready = ready && (circumstances.PipeAsOut < 0
                        ? Redirect(STDOUT_FILENO, circumstances.Out)
                        : dup2(circumstances.PipeAsOut, STDOUT_FILENO) == STDOUT_FILENO);
  ready = ready && Redirect(STDERR_FILENO, circumstances.Err);
  for (const int stream : circumstances.Closed) {
    close(stream);
  }
  if (circumstances.FileSize) {
    const rlimit limit{*circumstances.FileSize, *circumstances.FileSize};
    ready = ready && setrlimit(RLIMIT_FSIZE, &limit) == 0;
  }
  for (const std::string& variable : circumstances.Environment) {
    const size_t equals = variable.find('=');
    setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  if (ready) {
    execv(program.c_str(), argv.data());
  }
  _exit(127);
}

int WaitFor(pid_t process) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  int status = 0;
  while (waitpid(process, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(kPause);
    if (std::chrono::steady_clock::now() > deadline) {
      kill(process, SIGKILL);
    }
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

SProgramRun RunProgramUnder(const CTestFolder& folder, const std::vector<std::string>& arguments,
                            const SCircumstances& circumstances) {
  SProgramRun run;
  run.Status = WaitFor(StartProgram(folder, arguments, circumstances));
  run.Out = folder.Read("stdout.txt");
  SplitStandardError(folder.Read("stderr.txt"), run);
  return run;
}

bool WaitForFile(const CTestFolder& folder, const std::string& name) {
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < deadline) {
    if (!folder.Read(name).empty()) {
      return true;
    }
    std::this_thread::sleep_for(kPause);
  }
  return false;
}

}  // namespace argos
