// The program from the user's view: exit status, output, files.

#include "program_run.h"

#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <csignal>
#include <regex>
#include <thread>

using namespace argos;
using Catch::Contains;

namespace {

const std::string kBadControllers =
    InBuildTree("testing/plugins/libargos3_test_bad_controllers.so");

// three e-pucks at random places that do not move, for one second
std::string Experiment(const std::string& controller = "test_idle",
                       const std::string& rest = "<visualization/>") {
  return "<argos-configuration>\n"
         "<framework><experiment ticks_per_second=\"10\" length=\"1\" "
         "random_seed=\"1\"/></framework>\n"
         "<controllers><" +
         controller + " id=\"c\" library=\"" + kBadControllers +
         "\"><actuators>"
         "<differential_steering implementation=\"default\"/></actuators><sensors/><params/></" +
         controller +
         "></controllers>\n"
         "<physics_engines><dynamics2d id=\"d\"/></physics_engines>\n<media/>\n"
         "<arena size=\"4,4,1\"><distribute><position method=\"uniform\" min=\"-1,-1,0\" "
         "max=\"1,1,0\"/><orientation method=\"uniform\" min=\"0,0,0\" max=\"360,0,0\"/>"
         "<entity quantity=\"3\" max_trials=\"100\"><e-puck id=\"ep\"><controller config=\"c\"/>"
         "</e-puck></entity></distribute></arena>\n" +
         rest + "\n</argos-configuration>\n";
}

std::string DigestIn(const std::string& text) {
  std::smatch match;
  return std::regex_search(text, match, std::regex("digest: ([0-9a-f]{16})\n")) ? match[1].str()
                                                                                : "";
}

// keeps every core busy during its lifetime
class CLoad {
 public:
  CLoad() {
    for (unsigned int i = 0; i < 2 * std::thread::hardware_concurrency(); ++i) {
      m_threads.emplace_back([this] {
        while (!m_stop) {
        }
      });
    }
  }
  ~CLoad() {
    m_stop = true;
    for (std::thread& thread : m_threads) {
      thread.join();
    }
  }
  CLoad(const CLoad&) = delete;
  CLoad& operator=(const CLoad&) = delete;

 private:
  std::atomic<bool> m_stop{false};
  std::vector<std::thread> m_threads;
};

// short runs with threads on a busy machine: first valid ones, then ones whose robots throw
void CheckStatusOfShortRuns(int runs) {
  const CTestFolder folder;
  folder.Write("good.argos", Experiment());
  folder.Write("bad.argos", Experiment("test_throws_in_step"));
  const CLoad load;
  for (int run = 0; run < runs; ++run) {
    const std::string threads = std::to_string(2 + run % 7);
    CAPTURE(run, threads);
    REQUIRE(folder.Run({"-c", "good.argos", "--length", "0.1", "--threads", threads}).Status == 0);
    REQUIRE(folder.Run({"-c", "bad.argos", "--threads", threads}).Status == 1);
  }
}

}  // namespace

TEST_CASE("argos3: short runs with threads end with their status on a busy machine",
          "[command_line][threads]") {
  CheckStatusOfShortRuns(25);
}

TEST_CASE("argos3: 2,000 short runs with threads end with their status on a busy machine",
          "[.][soak][command_line][threads]") {
  CheckStatusOfShortRuns(1000);
}

TEST_CASE("argos3: a run ends with a summary and status 0", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 0);
  CHECK(run.Err == "");
  CHECK(
      std::regex_search(run.Out, std::regex("\\[INFO\\] simulated 1 s in [0-9.e+-]+ s of wall time "
                                            "\\(real-time factor [0-9.e+-]+, 3 robots\\)\n")));
  CHECK_THAT(run.Out, Contains("[INFO] Using random seed = 1\n") &&
                          Contains("[INFO] Total experiment length in clock ticks = 10\n"));
}

TEST_CASE("argos3: without a terminal the output has no colours and no progress line",
          "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "--length", "5000"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Out, !Contains("\x1b"));
  CHECK(run.Err == "");
}

TEST_CASE("argos3: the digest repeats and differs between seeds", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const std::string digest = DigestIn(folder.Run({"-c", "e.argos", "--digest"}).Out);
  REQUIRE(digest.size() == 16);
  CHECK(DigestIn(folder.Run({"-zc", "e.argos", "--digest"}).Out) == digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos", "--digest", "--threads", "2"}).Out) == digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos", "--digest", "--seed", "1"}).Out) == digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos", "--digest", "--seed", "2"}).Out) != digest);
  CHECK(DigestIn(folder.Run({"-c", "e.argos"}).Out).empty());
}

TEST_CASE("argos3: --length, --threads, --seed and --set change the run", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run =
      folder.Run({"-c", "e.argos", "--length", "2", "--threads", "2", "--seed", "77", "--set",
                  "arena/distribute/entity/@quantity=5", "--set", "//e-puck/@id=robot"});
  CHECK(run.Status == 0);
  CHECK_THAT(run.Out, Contains("simulated 2 s") && Contains("5 robots") &&
                          Contains("Using random seed = 77") && Contains("Using 2 threads"));
}

TEST_CASE("argos3: --lenient accepts malformed numbers with warnings", "[command_line]") {
  const CTestFolder folder;
  std::string xml = Experiment();
  xml.replace(xml.find("quantity=\"3\""), 12, "quantity=\"3x\"");
  folder.Write("e.argos", xml);
  const SProgramRun strict = folder.Run({"-c", "e.argos"});
  CHECK(strict.Status == 1);
  CHECK_THAT(strict.Err, Contains("e.argos:6") && Contains("found \"3x\""));
  const SProgramRun lenient = folder.Run({"-c", "e.argos", "--lenient"});
  CHECK(lenient.Status == 0);
  CHECK_THAT(lenient.Err, Contains("[WARNING] e.argos:6") && Contains("found \"3x\""));
}

TEST_CASE("argos3: --set without a match is an error", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "--set", "framwork/experiment/@length=5"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("framwork") && Contains("framework"));
}

TEST_CASE("argos3: logs can be written to files", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment("test_idle", "<nobody_reads_me/>"));
  folder.Write("log.txt", "old content");
  const SProgramRun run =
      folder.Run({"-c", "e.argos", "-l", "log.txt", "-e", "err.txt", "--digest"});
  CHECK(run.Status == 0);
  CHECK(run.Out == "");
  CHECK(run.Err == "");
  CHECK_THAT(folder.Read("log.txt"), Contains("simulated 1 s") && Contains("digest: ") &&
                                         !Contains("old content") && !Contains("\x1b"));
  CHECK_THAT(folder.Read("err.txt"), Contains("[WARNING]") && Contains("nobody_reads_me"));
}

TEST_CASE("argos3: a log file that cannot be written is an error before the run",
          "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const std::string option = GENERATE(as<std::string>{}, "-l", "-e");
  CAPTURE(option);
  const SProgramRun run = folder.Run({"-c", "e.argos", option, "no/such/folder/log.txt"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("no/such/folder/log.txt"));
  CHECK_THAT(run.Out, !Contains("simulated"));
}

TEST_CASE("argos3: a full disk for the log is an error", "[command_line]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "-l", "/dev/full"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("log could not be written"));
}

TEST_CASE("argos3: help, version and queries end with status 0", "[command_line]") {
  const CTestFolder folder;
  const SProgramRun help = folder.Run({"-h"});
  CHECK(help.Status == 0);
  CHECK_THAT(help.Out, Contains("Usage: argos3"));
  const SProgramRun version = folder.Run({"-v"});
  CHECK(version.Status == 0);
  CHECK_THAT(version.Out, Contains("ARGOS_VERSION="));
  const SProgramRun entities = folder.Run({"-q", "entities"});
  CHECK(entities.Status == 0);
  CHECK_THAT(entities.Out, Contains("AVAILABLE ENTITIES\n\n") && Contains("   [ box ]\n      ") &&
                               Contains("   [ e-puck ]\n      ") && Contains("   [ foot-bot ]\n"));
  const SProgramRun device = folder.Run({"-q", "footbot_proximity"});
  CHECK_THAT(device.Out, Contains("[ footbot_proximity (default) ]\n"));
}

TEST_CASE("argos3: an invalid command line is an error with status 1", "[command_line]") {
  const CTestFolder folder;
  const SProgramRun run = folder.Run({"--configfile", "e.argos"});
  CHECK(run.Status == 1);
  CHECK(run.Out == "");
  CHECK_THAT(run.Err, Contains("[FATAL]") && Contains("--config-file"));
}

TEST_CASE("argos3: a missing file, a folder, and text that is not XML are errors",
          "[command_line][bad_input]") {
  const CTestFolder folder;
  const SProgramRun missing = folder.Run({"-c", "nothing.argos"});
  CHECK(missing.Status == 1);
  CHECK_THAT(missing.Err, Contains("[FATAL]") && Contains("nothing.argos"));
  const SProgramRun directory = folder.Run({"-c", "."});
  CHECK(directory.Status == 1);
  CHECK_THAT(directory.Err, Contains("directory"));
  folder.Write("broken.argos", "<argos-configuration>\n<framework>\n</argos-configuration>\n");
  const SProgramRun broken = folder.Run({"-c", "broken.argos"});
  CHECK(broken.Status == 1);
  CHECK_THAT(broken.Err, Contains("broken.argos:"));
}

TEST_CASE("argos3: a controller that throws ends the run with status 1",
          "[command_line][bad_input]") {
  const CTestFolder folder;
  folder.Write("e.argos", Experiment("test_throws_in_step"));
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("\"ep0\"") && Contains("tired after two steps"));
  CHECK_THAT(run.Out, !Contains("simulated"));
  // earlier log output is not lost
  CHECK_THAT(run.Out, Contains("Using random seed = 1"));
}

TEST_CASE("argos3: a signal ends the run in order, with its own status", "[command_line]") {
  const auto [signal, status] = GENERATE(table<int, int>({{SIGINT, 130}, {SIGTERM, 143}}));
  CAPTURE(signal);
  const CTestFolder folder;
  folder.Write("e.argos", Experiment());
  const SProgramRun run = folder.Run({"-c", "e.argos", "--length", "0", "--digest", "--set",
                                      "framework/experiment/@real_time=true"},
                                     signal, "Total experiment length");
  CHECK(run.Status == status);
  CHECK_THAT(run.Out, Contains("stopped by SIG") && Contains("simulated ") && Contains("digest: "));
}
