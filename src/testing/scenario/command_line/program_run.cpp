#include "program_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <sstream>
#include <string>
#include <thread>

namespace argos {

namespace {

// longer than any test takes, shorter than the limit of the test driver
constexpr std::chrono::seconds kPatience(120);

void RedirectTo(int file, const std::string& path) {
  const int target = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  dup2(target, file);
  close(target);
}

[[noreturn]] void Execute(const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& folder, const std::string& out,
                          const std::string& err) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
  RedirectTo(STDOUT_FILENO, out);
  RedirectTo(STDERR_FILENO, err);
  if (chdir(folder.c_str()) == 0) {
    execv(program.c_str(), argv.data());
  }
  _exit(127);
}

}  // namespace

void SplitStandardError(const std::string& text, SProgramRun& run) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    (line.rfind("[INFO] ", 0) == 0 ? run.Notices : run.Err) += line + (lines.eof() ? "" : "\n");
  }
}

SProgramRun CTestFolder::Run(const std::vector<std::string>& arguments, int signal,
                             const std::string& trigger) const {
  return RunProgram("argos3", arguments, signal, trigger);
}

SProgramRun CTestFolder::RunProgram(const std::string& name,
                                    const std::vector<std::string>& arguments, int signal,
                                    const std::string& trigger) const {
  const std::string program = InBuildTree("bin/" + name);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    Execute(program, arguments, GetPath(), Path("stdout.txt"), Path("stderr.txt"));
  }

  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  bool signalled = signal == 0;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!signalled &&
        (Read("stdout.txt") + Read("stderr.txt")).find(trigger) != std::string::npos) {
      kill(child, signal);
      signalled = true;
    }
    if (std::chrono::steady_clock::now() > deadline) {
      kill(child, SIGKILL);
    }
  }
  SProgramRun run;
  run.Status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.Out = Read("stdout.txt");
  SplitStandardError(Read("stderr.txt"), run);
  return run;
}

}  // namespace argos
