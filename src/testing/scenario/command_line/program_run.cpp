#include "program_run.h"

#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/terminal.h>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
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
                          const std::string& folder) {
  std::vector<char*> argv{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) {
    argv.push_back(const_cast<char*>(argument.c_str()));
  }
  argv.push_back(nullptr);
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
    RedirectTo(STDOUT_FILENO, Path("stdout.txt"));
    RedirectTo(STDERR_FILENO, Path("stderr.txt"));
    Execute(program, arguments, GetPath());
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

std::string CTestFolder::RunOnTerminal(const std::vector<std::string>& arguments,
                                       unsigned short columns, const std::string& trigger,
                                       const std::string& kind) const {
  CTerminal terminal(columns);
  REQUIRE(terminal.GetFile() >= 0);
  const pid_t child = fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    setenv("TERM", kind.c_str(), 1);
    dup2(terminal.GetFile(), STDOUT_FILENO);
    dup2(terminal.GetFile(), STDERR_FILENO);
    Execute(InBuildTree("bin/argos3"), arguments, GetPath());
  }
  const auto deadline = std::chrono::steady_clock::now() + kPatience;
  std::string text;
  bool interrupted = false;
  while (waitpid(child, nullptr, WNOHANG) == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    text += terminal.Read();
    if (!interrupted && text.find(trigger) != std::string::npos) {
      kill(child, SIGINT);
      interrupted = true;
    }
    if (std::chrono::steady_clock::now() > deadline) {
      kill(child, SIGKILL);
    }
  }
  return text + terminal.Read();
}

}  // namespace argos
