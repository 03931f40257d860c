#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/testing/unit/core/utility/logging/log_text.h>

#include <catch2/catch.hpp>

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <thread>
#include <vector>

namespace argos_log_test {

using namespace argos;
using Catch::Contains;

namespace {

class CRobot {
 public:
  const std::string& GetId() const { return m_id; }
  void Talk() const {
    RLOG << "hello" << std::endl;
    RLOGERR << "trouble" << std::endl;
  }

 private:
  std::string m_id = "fb7";
};

struct SChatty {};
CARGoSLog* chattyLog = nullptr;
std::ostream& operator<<(std::ostream& stream, const SChatty&) {
  *chattyLog << "inner ";
  return stream << "outer";
}

}  // namespace

TEST_CASE("log: nothing is written to the stream before a flush", "[core][log]") {
  SLog log;
  log.Log << "a" << 1 << ' ' << 2.5 << std::endl;
  CHECK(log.Stream.str().empty());
  CHECK(log.Flushed() == "a1 2.5\n");
  CHECK(log.Flushed().empty());
}

TEST_CASE("log: 8-bit integers print as numbers, and manipulators work", "[core][log]") {
  SLog log;
  log.Log << UInt8(65) << ',' << SInt8(-1) << ',' << std::setw(4) << 7 << ',' << std::hex << 255
          << std::dec << std::boolalpha << true;
  CHECK(log.Flushed() == "65,-1,   7,fftrue");
}

TEST_CASE("log: every item is enclosed in colour and reset sequences", "[core][log]") {
  SLog log(true);
  CHECK(log.Log.IsColoredOutput());
  log.Log << "a" << 1 << std::endl;
  CHECK(log.Flushed() == "\033[1;32ma\033[0m\033[1;32m1\033[0m\n");
  // an item that prints nothing gets no colour, and setw() applies to the next item
  log.Log << std::setw(3) << 1;
  CHECK(log.Flushed() == "\033[1;32m  1\033[0m");
  log.Log.DisableColoredOutput();
  CHECK_FALSE(log.Log.IsColoredOutput());
  log.Log << "b";
  CHECK(log.Flushed() == "b");
  log.Log.EnableColoredOutput();
  log.Log << "c";
  CHECK(log.Flushed() == "\033[1;32mc\033[0m");
}

TEST_CASE("log: colours are ANSI sequences", "[core][log]") {
  std::ostringstream stream;
  stream << kGreen << red << green << yellow << blue << magenta << cyan << white << reset;
  CHECK(stream.str() ==
        "\033[1;32m\033[1;31m\033[1;32m\033[1;33m\033[1;34m\033[1;35m\033[1;36m\033[1;37m\033[0m");
  SLog log;
  log.Log << red << "x" << reset;
  CHECK(log.Flushed() == "\033[1;31mx\033[0m");
}

TEST_CASE("log: the order is that of the keys, whatever the threads", "[core][log]") {
  constexpr UInt64 kRobots = 40;
  std::string expected;
  for (UInt64 robot = 0; robot < kRobots; ++robot) {
    expected += "sense " + std::to_string(robot) + "\nstep " + std::to_string(robot) + "\n";
  }
  const UInt64 numThreads = GENERATE(UInt64(1), UInt64(2), UInt64(4), UInt64(15));
  CAPTURE(numThreads);
  SLog log;
  // two phases with a barrier between them, with robots assigned to threads in different ways
  for (const std::string phase : {"sense ", "step "}) {
    std::vector<std::thread> threads;
    for (UInt64 t = 0; t < numThreads; ++t) {
      threads.emplace_back([&log, &phase, t, numThreads] {
        for (UInt64 robot = 0; robot < kRobots; ++robot) {
          const UInt64 owner = phase == "step " ? robot % numThreads : robot * numThreads / kRobots;
          if (owner == t) {
            CARGoSLog::SetSequence(robot);
            log.Log << phase << robot << std::endl;
          }
        }
      });
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
  }
  CHECK(log.Flushed() == expected);
}

TEST_CASE("log: each thread has its own key, which starts at 0", "[core][log]") {
  CARGoSLog::SetSequence(5);
  UInt64 other = 1;
  std::thread([&other] { other = CARGoSLog::GetSequence(); }).join();
  CHECK(other == 0);
  CHECK(CARGoSLog::GetSequence() == 5);
  SLog log;
  log.Log << "five ";
  log.Log.SetSequence(0);
  log.Log << "zero ";
  CHECK(log.Flushed() == "zero five ");
}

TEST_CASE("log: threads may log while another flushes, and nothing is lost", "[core][log]") {
  SLog log;
  constexpr int kLines = 2000;
  std::vector<std::thread> threads;
  for (int t = 0; t < 3; ++t) {
    threads.emplace_back([&log] {
      log.Log.AddThreadSafeBuffer();
      for (int i = 0; i < kLines; ++i) {
        log.Log << 'x';
      }
    });
  }
  std::size_t seen = 0;
  for (int i = 0; i < 100; ++i) {
    seen += log.Flushed().size();
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  seen += log.Flushed().size();
  CHECK(seen == 3U * kLines);
}

TEST_CASE("log: printing an item may log too", "[core][log]") {
  SLog log;
  chattyLog = &log.Log;
  log.Log << SChatty();
  CHECK(log.Flushed() == "inner outer");
}

TEST_CASE("log: the destructor flushes", "[core][log]") {
  std::ostringstream stream;
  {
    CARGoSLog log(stream, SLogColor(), false);
    log << "last words";
  }
  CHECK(stream.str() == "last words");
}

TEST_CASE("log: a log file replaces the stream until the log ends", "[core][log]") {
  const std::string name = "argos_log_test." + std::to_string(getpid()) + ".log";
  std::ofstream(name) << "old content";
  std::ostringstream stream;
  {
    CARGoSLog log(stream, kGreen, true);
    log.RedirectToFile(name);
    CHECK_FALSE(log.IsColoredOutput());
    log << "logged ";
    log.Flush();
    log.GetStream() << "direct";
    CHECK_THROWS_WITH(
        log.RedirectToFile("/no/such/folder/x.log"),
        Contains("Cannot write the log file \"/no/such/folder/x.log\": No such file"));
  }
  stream << "after";
  CHECK(stream.str() == "after");
  std::ifstream file(name);
  std::stringstream content;
  content << file.rdbuf();
  CHECK(content.str() == "logged direct");
  std::remove(name.c_str());
}

TEST_CASE("log: the two logs write to the standard streams, with the robot's id", "[core][log]") {
  LOG.Flush();
  LOGERR.Flush();
  CHECK(&LOG.GetStream() == &std::cout);
  CHECK(&LOGERR.GetStream() == &std::cerr);
  std::ostringstream out;
  std::ostringstream err;
  std::streambuf* outBuffer = LOG.GetStream().rdbuf(out.rdbuf());
  std::streambuf* errBuffer = LOGERR.GetStream().rdbuf(err.rdbuf());
  const bool wasColored = LOG.IsColoredOutput();
  LOG.DisableColoredOutput();
  LOGERR.DisableColoredOutput();
  CRobot().Talk();
  LOG.Flush();
  LOGERR.Flush();
  if (wasColored) {
    LOG.EnableColoredOutput();
    LOGERR.EnableColoredOutput();
  }
  LOG.GetStream().rdbuf(outBuffer);
  LOGERR.GetStream().rdbuf(errBuffer);
  CHECK(out.str() == "[fb7] hello\n");
  CHECK(err.str() == "[fb7] trouble\n");
}

TEST_CASE("log: debug macros indent the output of a function", "[core][log]") {
  // redirects the standard error to a file
  const std::string name = "argos_log_test_debug." + std::to_string(getpid());
  std::fflush(stderr);
  const int saved = dup(2);
  REQUIRE(saved >= 0);
  FILE* file = std::fopen(name.c_str(), "w");
  REQUIRE(file != nullptr);
  dup2(fileno(file), 2);
  int value = 1;
  DEBUG_FUNCTION_ENTER;
  DEBUG("value %d\n", value);
  TRACE(++value;)
  DEBUG_FUNCTION_EXIT;
  std::fflush(stderr);
  dup2(saved, 2);
  close(saved);
  std::fclose(file);
  CHECK(value == 2);
  CHECK(DEBUG_INDENTATION == 0);
  std::ifstream stream(name);
  std::stringstream content;
  content << stream.rdbuf();
  CHECK_THAT(content.str(), Contains(" - START\n value 1\n ++value;\n"));
  CHECK_THAT(content.str(), Catch::EndsWith(" - END\n"));
  std::remove(name.c_str());
}

}  // namespace argos_log_test
