// Built-in metrics of the main loop: wall and processor time, speedup, memory.

#include "../command_line/program_run.h"
#include "table_reading.h"

#include <argos3/core/simulator/space/metrics.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

namespace loop_metrics_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

constexpr const char* kNames[] = {"loop_wall_time", "loop_cpu_time", "speedup", "real_time_factor",
                                  "resident_memory"};

// e-pucks that stand still
SExperiment MakeExperiment(size_t robots) {
  SExperiment experiment;
  experiment.Length = 1.0;
  experiment.Controllers = "<test_idle id='c' library='" +
                           InBuildTree("testing/plugins/libargos3_test_bad_controllers.so") + "'/>";
  experiment.Engines = "<kinematics2d id='kin2d'/>";
  experiment.ArenaSize = "40,40,1";
  experiment.Arena =
      "<distribute><position method='uniform' min='-19,-19,0' max='19,19,0'/>"
      "<orientation method='constant' values='0,0,0'/><entity quantity='" +
      std::to_string(robots) +
      "' max_trials='1000'><e-puck id='e'><controller config='c'/></e-puck></entity></distribute>";
  return experiment;
}

class CLoopWorld {
 public:
  CLoopWorld() : m_world(MakeExperiment(1)) {
    for (const char* const name : kNames) {
      Metrics().EnableBuiltIn(name);
    }
  }
  CTestWorld& World() { return m_world; }
  CMetrics& Metrics() { return m_world.GetSimulator().GetMetrics(); }
  Real Get(const char* name) { return Metrics().Find(name)->Value; }

 private:
  CTestWorld m_world;
};

void Sleep(std::chrono::milliseconds time) {
  std::this_thread::sleep_for(time);
}

// uses a processor
void Spin(std::chrono::milliseconds time) {
  const auto end = std::chrono::steady_clock::now() + time;
  while (std::chrono::steady_clock::now() < end) {
  }
}

// uses a processor until this thread has used it for so long
void Burn(Real seconds) {
  timespec now{};
  do {
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  } while (static_cast<Real>(now.tv_sec) + 1e-9 * static_cast<Real>(now.tv_nsec) < seconds);
}

}  // namespace

TEST_CASE("loop metrics: a loop that sleeps uses less processor time than wall time",
          "[outputs][metrics]") {
  CLoopWorld loop;
  CHECK(loop.Get("loop_wall_time") == 0.0);
  CHECK(loop.Get("loop_cpu_time") == 0.0);
  CHECK(std::isnan(loop.Get("speedup")));
  loop.World().Step();
  Sleep(std::chrono::milliseconds(200));
  loop.World().Step();
  CHECK(loop.Get("loop_wall_time") >= 0.2);
  CHECK(loop.Get("loop_cpu_time") > 0.0);
  CHECK(loop.Get("loop_wall_time") - loop.Get("loop_cpu_time") >= 0.199);
  // all of a tick are from one measurement
  CHECK(loop.Get("speedup") == loop.Get("loop_cpu_time") / loop.Get("loop_wall_time"));
  CHECK(loop.Get("real_time_factor") == Approx(0.2 / loop.Get("loop_wall_time")));
  CHECK(loop.Metrics().Find("loop_cpu_time")->Unit == "s");
  CHECK_FALSE(loop.Metrics().Find("loop_cpu_time")->IsReproducible);
}

TEST_CASE("loop metrics: without threads the speedup is at most 1", "[outputs][metrics]") {
  CLoopWorld loop;
  for (int tick = 0; tick < 100; ++tick) {
    // ticks of a few microseconds share a measurement
    Spin(std::chrono::milliseconds(1));
    loop.World().Step();
    // clocks may run at slightly different rates
    CHECK(loop.Get("speedup") <= 1.001);
  }
}

TEST_CASE("loop metrics: processor time is that of all threads", "[outputs][metrics]") {
  CLoopWorld loop;
  std::thread other([] { Burn(0.1); });
  other.join();
  loop.World().Step();
  CHECK(loop.Get("loop_cpu_time") >= 0.1);
}

TEST_CASE("loop metrics: what other programs use is counted, and what this one uses is not",
          "[outputs][metrics]") {
  CLoopWorld loop;
  loop.Metrics().EnableBuiltIn("other_load");
  CHECK(std::isnan(loop.Get("other_load")));
  loop.World().Step();
  // shorter spans are not measured
  CHECK(std::isnan(loop.Get("other_load")));
  const pid_t other = fork();
  if (other == 0) {
    Burn(0.6);
    _exit(0);
  }
  REQUIRE(other > 0);
  const auto numProcessors = static_cast<Real>(std::thread::hardware_concurrency());
  std::vector<std::thread> own;
  for (int i = 0; i < 2; ++i) {
    own.emplace_back([] { Burn(0.6); });
  }
  for (std::thread& thread : own) {
    thread.join();
  }
  int status = 0;
  REQUIRE(waitpid(other, &status, 0) == other);
  Sleep(std::chrono::milliseconds(100));
  loop.World().Step();
  const Real time = loop.Get("loop_wall_time");
  // the system counts in hundredths of a second
  CHECK(loop.Get("other_load") * time >= 0.55);
  CHECK(loop.Get("speedup") * time >= 1.2);
  CHECK(loop.Get("other_load") + loop.Get("speedup") <= 1.05 * numProcessors);
  loop.World().GetSimulator().Reset();
  CHECK(std::isnan(loop.Get("other_load")));
}

TEST_CASE("loop metrics: after a reset they begin at 0", "[outputs][metrics]") {
  CLoopWorld loop;
  Spin(std::chrono::milliseconds(500));
  loop.World().Step();
  const Real before = loop.Get("loop_wall_time");
  loop.World().GetSimulator().Reset();
  CHECK(loop.Get("loop_wall_time") == 0.0);
  CHECK(loop.Get("loop_cpu_time") == 0.0);
  CHECK(std::isnan(loop.Get("speedup")));
  CHECK(loop.Get("resident_memory") > 0.0);
  Spin(std::chrono::milliseconds(1));
  loop.World().Step();
  CHECK(loop.Get("loop_wall_time") > 0.0);
  CHECK(loop.Get("loop_wall_time") < before);
}

TEST_CASE("loop metrics: a metric that is enabled later has the start of the first one",
          "[outputs][metrics]") {
  CTestWorld world(MakeExperiment(1));
  CMetrics& metrics = world.GetSimulator().GetMetrics();
  metrics.EnableBuiltIn("loop_cpu_time");
  Sleep(std::chrono::milliseconds(50));
  world.Step();
  metrics.EnableBuiltIn("loop_wall_time");
  CHECK(metrics.Find("loop_wall_time")->Value >= 0.05);
}

TEST_CASE("loop metrics: memory grows with what is allocated, and shrinks", "[outputs][metrics]") {
  constexpr size_t kBytes = 100000000;
  CLoopWorld loop;
  const auto measure = [&loop] {
    // readings are some pauses apart
    Sleep(std::chrono::milliseconds(100));
    loop.World().Step();
    return loop.Get("resident_memory");
  };
  const Real before = measure();
  std::vector<char> block(kBytes, 'x');
  const Real with = measure();
  CHECK(with - before > 95.0);
  CHECK(block.back() == 'x');
  std::vector<char>().swap(block);
  // AddressSanitizer keeps freed memory in its quarantine
  if (!kHasAddressSanitizer) {
    CHECK(with - measure() > 95.0);
  }
  CHECK(loop.Metrics().Find("resident_memory")->Unit == "MB");
}

TEST_CASE("loop metrics: an experiment asks for them in its file", "[outputs][metrics]") {
  const CTestFolder folder;
  Real memory = 0.0;
  for (const size_t robots : {1, 20000}) {
    std::string xml = MakeExperiment(robots).ToXml();
    xml.insert(xml.rfind("</argos-configuration>"),
               "<outputs><metrics file='m.csv' builtin='loop_wall_time, loop_cpu_time, speedup, "
               "resident_memory'/></outputs>");
    folder.Write("e.argos", xml);
    const SProgramRun run = folder.Run({"-zc", "e.argos"});
    INFO(run.Err);
    REQUIRE(run.Status == 0);
    CHECK_THAT(folder.Read("m.csv"), Contains("loop_wall_time [s], loop_cpu_time [s], "
                                              "resident_memory [MB]"));
    const SReadTable table = ReadCSV(folder.Read("m.csv"));
    const std::vector<double> wall = table.GetNumbers("loop_wall_time");
    REQUIRE(wall.size() == 11);
    for (size_t tick = 1; tick < wall.size(); ++tick) {
      CHECK(wall[tick] >= wall[tick - 1]);
    }
    if (memory > 0.0) {
      CHECK(wall.back() > 0.0);
      // a robot takes more than 500 bytes
      CHECK(table.GetNumbers("resident_memory").back() - memory > 500e-6 * 19999);
    }
    memory = table.GetNumbers("resident_memory").back();
  }
}

}  // namespace loop_metrics_test
