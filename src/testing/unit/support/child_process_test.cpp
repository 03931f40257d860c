#include <argos3/support/child_process.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace child_process_test {

using namespace argos;
using Catch::Contains;

namespace {

std::vector<std::string> Shell(const std::string& script) {
  return {"sh", "-c", script};
}

}  // namespace

TEST_CASE("child process: programs are found in PATH, or by their path", "[core][processes]") {
  CHECK_THAT(FindProgram("sh"), Catch::EndsWith("/sh"));
  CHECK(FindProgram("/bin/sh") == "/bin/sh");
  CHECK(FindProgram("no_such_program_of_argos").empty());
  CHECK(FindProgram("/bin").empty());  // a folder
  CHECK(FindProgram("/etc/passwd").empty());  // not executable
  CHECK(FindProgram("").empty());
}

TEST_CASE("child process: a program reads all that is written to it", "[core][processes]") {
  const std::string file =
      (std::filesystem::temp_directory_path() / ("argos_child_" + std::to_string(getpid())))
          .string();
  std::string text;
  for (int i = 0; i < 300000; ++i) {
    text += std::to_string(i) + "\n";  // more than any buffer of the system
  }
  CChildProcess child(Shell("cat > " + file));
  CHECK(child.Write(text.data(), text.size()));
  const SProcessEnd end = child.Finish();
  CHECK(end.IsSuccess);
  CHECK(end.Description == "exit status 0");
  CHECK(child.GetErrorText().empty());
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  CHECK(content.str() == text);
  std::filesystem::remove(file);
}

TEST_CASE("child process: one that does nothing is killed, but not one that computes",
          "[core][processes]") {
  setenv("ARGOS_OUTPUT_TIMEOUT", "0.4", 1);
  const std::string block(1 << 20, '\n');
  CChildProcess idle(Shell("sleep 60"));
  CHECK_FALSE(idle.Write(block.data(), block.size()));
  SProcessEnd end = idle.Finish();
  CHECK_FALSE(end.IsSuccess);
  CHECK_THAT(end.Description, Contains("no sign of life for 0.4 s (ARGOS_OUTPUT_TIMEOUT)"));
  CChildProcess slow(Shell("sleep 60"));
  CHECK_FALSE(slow.Finish().IsSuccess);
  // long, because a busy machine may leave it little time
  setenv("ARGOS_OUTPUT_TIMEOUT", "3", 1);
  CChildProcess busy(Shell("i=0; while [ $i -lt 400000 ]; do i=$((i + 1)); done"));
  CHECK(busy.Finish().IsSuccess);
  unsetenv("ARGOS_OUTPUT_TIMEOUT");
}

TEST_CASE("child process: one that ends early is an error, not a SIGPIPE", "[core][processes]") {
  CChildProcess child(Shell("read line; echo 'no space' >&2; exit 3"));
  const std::string block(1 << 20, '\n');
  bool isWritten = true;
  for (int i = 0; i < 100 && isWritten; ++i) {
    isWritten = child.Write(block.data(), block.size());
  }
  CHECK_FALSE(isWritten);
  const SProcessEnd end = child.Finish();
  CHECK_FALSE(end.IsSuccess);
  CHECK(end.Description == "exit status 3");
  CHECK(child.GetErrorText() == "no space");
  CHECK(child.Finish().Description == "exit status 3");
  CHECK_FALSE(child.Write(block.data(), block.size()));
}

TEST_CASE("child process: the last messages are kept, in whole lines", "[core][processes]") {
  // 20,000 lines do not fit into the pipe: they must be read while the child runs
  CChildProcess child(
      Shell("i=0; while [ $i -lt 20000 ]; do i=$((i+1)); echo line $i >&2; done; "
            "cat > /dev/null; echo last >&2"));
  const std::string block(1 << 20, 'x');
  CHECK(child.Write(block.data(), block.size()));
  CHECK(child.Finish().IsSuccess);
  const std::string text = child.GetErrorText();
  CHECK(text.size() <= CChildProcess::kErrorTextSize);
  CHECK(text.size() > CChildProcess::kErrorTextSize / 2);
  CHECK(text.rfind("line ", 0) == 0);
  CHECK_THAT(text, Catch::EndsWith("line 20000\nlast"));
}

TEST_CASE("child process: a last message that is longer than what is kept is cut",
          "[core][processes]") {
  // with and without a line break at its end, and in two lines
  const auto [script, expected] = GENERATE(table<std::string, std::string>({
      {"printf '%05000d' 7 >&2", std::string(CChildProcess::kErrorTextSize - 1, '0') + '7'},
      {"printf '%05000d\\n' 7 >&2", std::string(CChildProcess::kErrorTextSize - 2, '0') + '7'},
      {"printf '%05000d\\nend' 7 >&2", "end"},
      {"printf '%02048d' 7 >&2", std::string(CChildProcess::kErrorTextSize - 1, '0') + '7'},
  }));
  CChildProcess child(Shell(script));
  CHECK(child.Finish().IsSuccess);
  CHECK(child.GetErrorText() == expected);
}

TEST_CASE("child process: a signal that ends it is named", "[core][processes]") {
  CChildProcess child(Shell("kill -TERM $$"));
  const SProcessEnd end = child.Finish();
  CHECK_FALSE(end.IsSuccess);
  CHECK_THAT(end.Description, Contains("signal 15 (Terminated)"));
}

TEST_CASE("child process: it has its own process group and no other files", "[core][processes]") {
  const int file = open("/dev/null", O_RDONLY);  // without O_CLOEXEC
  const int inherited = dup2(file, 57);
  CChildProcess child(Shell("cat; test ! -e /proc/$$/fd/57"));
  CHECK(getpgid(child.GetId()) == child.GetId());
  CHECK(child.Finish().IsSuccess);
  close(inherited);
  close(file);
}

TEST_CASE("child process: one that is not finished is killed", "[core][processes]") {
  pid_t id = 0;
  {
    CChildProcess child({"sleep", "1000"});
    id = child.GetId();
  }
  CHECK(kill(id, 0) != 0);
}

TEST_CASE("child process: children of the child do not delay its end", "[core][processes]") {
  CChildProcess child(Shell("sleep 5 & echo started >&2; exit 0"));
  CHECK(child.Finish().IsSuccess);
  CHECK(child.GetErrorText() == "started");
}

TEST_CASE("child process: a program that cannot be started is an error", "[core][processes]") {
  CHECK_THROWS_WITH(CChildProcess({"no_such_program_of_argos"}),
                    Contains("no_such_program_of_argos") && Contains("no such executable file"));
}

}  // namespace child_process_test
