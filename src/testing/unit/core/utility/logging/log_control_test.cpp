#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/testing/unit/core/utility/logging/log_text.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace log_control_test {

using namespace argos;

namespace {

void LogAllLevels(CARGoSLog& log) {
  log << "[FATAL] f" << std::endl;
  log << "[ERROR] e" << std::endl;
  log << "[WARNING] w" << std::endl;
  log << "[INFO] i" << std::endl;
  log << "[DEBUG] d" << std::endl;
  log << "no mark" << std::endl;
}

// restores what the tests set
struct SDefaults {
  ~SDefaults() {
    CLogControl::SetLevel(ELogLevel::Info);
    CLogControl::SetLineReceiver(nullptr);
    CLogControl::SetThreadLabel("");
  }
};

}  // namespace

TEST_CASE("log control: less important lines are dropped", "[core][log]") {
  const SDefaults defaults;
  SLog log;
  const std::string everything =
      "[FATAL] f\n[ERROR] e\n[WARNING] w\n[INFO] i\n[DEBUG] d\nno mark\n";
  const auto [level, text] = GENERATE_COPY(table<ELogLevel, std::string>(
      {{ELogLevel::Error, "[FATAL] f\n[ERROR] e\n"},
       {ELogLevel::Warning, "[FATAL] f\n[ERROR] e\n[WARNING] w\n"},
       // marks of users' own debugging are no less important than lines without marks
       {ELogLevel::Info, everything},
       {ELogLevel::Debug, everything}}));
  CLogControl::SetLevel(level);
  CHECK(CLogControl::GetLevel() == level);
  LogAllLevels(log.Log);
  CHECK(log.Flushed() == text);
}

TEST_CASE("log control: a line without a mark on LOGERR is an error", "[core][log]") {
  const SDefaults defaults;
  std::vector<std::pair<ELogLevel, std::string>> lines;
  LOG.Flush();
  LOGERR.Flush();
  CLogControl::SetLineReceiver(
      [&lines](ELogLevel level, const std::string& line) { lines.emplace_back(level, line); });
  LOG << "out" << std::endl;
  LOGERR << "err" << std::endl;
  LOG.Flush();
  LOGERR.Flush();
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == std::make_pair(ELogLevel::Info, std::string("out")));
  CHECK(lines[1] == std::make_pair(ELogLevel::Error, std::string("err")));
}

TEST_CASE("log control: a receiver gets complete lines instead of the stream", "[core][log]") {
  const SDefaults defaults;
  SLog log(true);
  std::vector<std::pair<ELogLevel, std::string>> lines;
  CLogControl::SetLineReceiver(
      [&lines](ELogLevel level, const std::string& line) { lines.emplace_back(level, line); });
  log.Log << "[WARNING] two"
          << " items" << std::endl
          << "[INFO] beg";
  CHECK(log.Flushed() == "");
  REQUIRE(lines.size() == 1);
  // without colours
  CHECK(lines[0] == std::make_pair(ELogLevel::Warning, std::string("[WARNING] two items")));
  log.Log << "un\n";
  log.Log << "\n";
  CHECK(log.Flushed() == "");
  REQUIRE(lines.size() == 3);
  CHECK(lines[1] == std::make_pair(ELogLevel::Info, std::string("[INFO] begun")));
  CHECK(lines[2].second == "");
  // and the level applies
  CLogControl::SetLevel(ELogLevel::Error);
  log.Log << "[INFO] dropped" << std::endl;
  log.Log.Flush();
  CHECK(lines.size() == 3);
  CLogControl::SetLevel(ELogLevel::Info);
  CLogControl::SetLineReceiver(nullptr);
  log.Log << red << "again" << reset << std::endl;
  CHECK(log.Flushed() == "\033[1;31m\033[1;32magain\033[0m\033[0m\n");
}

TEST_CASE("log control: a line that begins at one level ends whole at another", "[core][log]") {
  const SDefaults defaults;
  SLog log;
  CLogControl::SetLevel(ELogLevel::Warning);
  log.Log << "[WARNING] sta";
  CHECK(log.Flushed().empty());
  CLogControl::SetLevel(ELogLevel::Info);
  log.Log << "rt" << std::endl;
  CHECK(log.Flushed() == "[WARNING] start\n");
}

TEST_CASE("log control: a colour that does not end hides its line only", "[core][log]") {
  const SDefaults defaults;
  SLog log;
  std::vector<std::string> lines;
  CLogControl::SetLineReceiver(
      [&lines](ELogLevel, const std::string& line) { lines.push_back(line); });
  log.Log << "before \033[31 not ended" << std::endl
          << "\033[31[FATAL] not ended" << std::endl
          << "\033[31mended" << std::endl;
  log.Log.Flush();
  CHECK(lines == std::vector<std::string>{"before ", "", "ended"});
}

TEST_CASE("log control: the end of the redirection writes the start of a line", "[core][log]") {
  const SDefaults defaults;
  SLog log;
  CLogControl::SetLevel(ELogLevel::Warning);
  log.Log << "[WARNING] unfinished";
  CHECK(log.Flushed() == "");
  log.Log.EndRedirection();
  CHECK(log.Stream.str() == "[WARNING] unfinished");
}

TEST_CASE("log control: only terminals get colours, also in programs that embed the simulator",
          "[core][log]") {
  const bool noColor = std::getenv("NO_COLOR") != nullptr;
  CHECK(LOG.IsColoredOutput() == (!noColor && isatty(STDOUT_FILENO) != 0));
  CHECK(LOGERR.IsColoredOutput() == (!noColor && isatty(STDERR_FILENO) != 0));
}

TEST_CASE("log control: lines of threads with labels can be told apart", "[core][log]") {
  const SDefaults defaults;
  SLog log;
  std::thread([&log] {
    CLogControl::SetThreadLabel("run 1");
    CHECK(CLogControl::GetThreadLabel() == "run 1");
    log.Log << "[INFO] seed " << 3 << std::endl << "text\n";
    CLogControl::SetThreadLabel("");
    log.Log << "none\n";
  }).join();
  log.Log << "main\n";
  CHECK(log.Flushed() == "[INFO] [run 1] seed 3\n[run 1] text\nnone\nmain\n");
  CHECK(CLogControl::GetThreadLabel() == "");
}

}  // namespace log_control_test
