// Crashes of users' code: the program says where, and dies of the same signal.

#include "../command_line/program_run.h"
#include "fault_experiment.h"

#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>

namespace crash_test {

using namespace argos;
using Catch::Contains;

namespace {

// sanitizers handle these signals themselves
constexpr bool kHasSanitizer = kHasAddressSanitizer || kHasThreadSanitizer;

constexpr int kStatusOfSignal = 128;

SProgramRun RunCrash(const CTestFolder& folder, const SFaultExperiment& experiment,
                     const std::vector<std::string>& options = {}) {
  folder.Write("crash.argos", experiment.ToXml());
  std::vector<std::string> arguments = {"-c", "crash.argos"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return folder.Run(arguments);
}

}  // namespace

TEST_CASE("crash: the report names robot, controller, call and tick, and shows the stack",
          "[faults][crash][command_line]") {
  if (kHasSanitizer) {
    return;
  }
  const auto [what, signal, text] = GENERATE(table<std::string, int, std::string>(
      {{"segv", SIGSEGV, "SIGSEGV: invalid memory access at address 0x0"},
       {"overflow", SIGSEGV, "the stack has overflowed"},
       {"abort", SIGABRT, "SIGABRT"},
       {"fpe", SIGFPE, "SIGFPE"},
       {"bus", SIGBUS, "SIGBUS"},
       {"ill", SIGILL, "SIGILL"}}));
  const UInt32 threads = GENERATE(0, 2);
  CAPTURE(what, threads);
  const CTestFolder folder;
  SFaultExperiment experiment;
  experiment.Robots = 150;
  experiment.Threads = threads;
  // the last robots run on a worker, if there is one
  experiment.Params = "where='step' what='" + what + "' tick='3' robot='ep149'";
  const SProgramRun run = RunCrash(folder, experiment);
  CHECK(run.Status == kStatusOfSignal + signal);
  CHECK_THAT(run.Err, Contains("[FATAL] crash, ") && Contains(text) &&
                          Contains("[FATAL] robot \"ep149\", controller \"c\": ControlStep() in "
                                   "tick 3\n") &&
                          Contains("\n  #0 "));
  if (what == "overflow") {
    CHECK_THAT(run.Err, Contains("OverflowStack"));
  } else {
    CHECK_THAT(run.Err, Contains("argos::"));
  }
}

TEST_CASE("crash: loop functions, devices, media and Init() are named", "[faults][crash]") {
  if (kHasSanitizer) {
    return;
  }
  const std::string segv = " what='segv'";
  SFaultExperiment experiment;
  std::string expected;
  SECTION("a hook") {
    experiment.Loop = "where='pre_step' tick='2'" + segv;
    expected = "[FATAL] loop functions: PreStep() in tick 2\n";
  }
  SECTION("the end of loop functions") {
    experiment.Loop = "where='destroy'" + segv;
    expected = "[FATAL] loop functions: Destroy() in tick 10\n";
  }
  SECTION("the colour of the floor, which a sensor reads") {
    experiment.Loop = "where='floor_color' tick='2'" + segv;
    experiment.Sensors = "<ground implementation='rot_z_only'/>";
    experiment.Entities = "<floor id='floor' source='loop_functions' pixels_per_meter='1'/>";
    expected = "[FATAL] loop functions: GetFloorColor() in tick 2\n";
  }
  SECTION("a sensor") {
    experiment.Sensors =
        "<test_misbehaving implementation='default' where='update' robot='ep2'" + segv + "/>";
    expected = "[FATAL] robot \"ep2\", controller \"c\": a sensor in tick 1\n";
  }
  SECTION("a medium") {
    experiment.Media = "<test_misbehaving_medium id='air' where='update'" + segv + "/>";
    expected = "[FATAL] medium \"air\": Update() in tick 1\n";
  }
  SECTION("the start of a controller") {
    experiment.Params = "where='init' robot='ep2'" + segv;
    expected = "[FATAL] robot \"ep2\", controller \"c\": Init()\n";
  }
  SECTION("the end of a controller") {
    experiment.Params = "where='destroy' robot='ep2'" + segv;
    expected = "[FATAL] robot \"ep2\", controller \"c\": Destroy()\n";
  }
  const CTestFolder folder;
  const SProgramRun run = RunCrash(folder, experiment);
  CHECK(run.Status == kStatusOfSignal + SIGSEGV);
  CHECK_THAT(run.Err, Contains(expected));
}

TEST_CASE("crash: with a damaged heap the report is complete, and takes no long time",
          "[faults][crash]") {
  if (kHasSanitizer) {
    return;
  }
  // with threads the heap is locked when the C library finds the damage, without it is not
  const UInt32 threads = GENERATE(0, 2);
  CAPTURE(threads);
  SFaultExperiment experiment;
  experiment.Threads = threads;
  experiment.Params = "where='step' what='damage_heap' tick='3' robot='ep2'";
  const CTestFolder folder;
  const auto start = std::chrono::steady_clock::now();
  const SProgramRun run = RunCrash(folder, experiment);
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  CHECK(run.Status == kStatusOfSignal + SIGABRT);
  CHECK_THAT(run.Err, Contains("SIGABRT") &&
                          Contains("[FATAL] robot \"ep2\", controller \"c\": ControlStep() in "
                                   "tick 3\n") &&
                          Contains("\n  #0 ") && Contains("libargos3_test_misbehaving.so"));
  // the limit of a step that waits for a lock is 1 s; that of the others, 10 s
  CHECK(time.count() < 25.0);
}

TEST_CASE("crash: what was logged in the tick of the crash is written", "[faults][crash]") {
  if (kHasSanitizer) {
    return;
  }
  SFaultExperiment experiment;
  experiment.Params = "where='step' what='segv' tick='2' robot='ep2' logs='true'";
  const CTestFolder folder;
  SECTION("to the standard output") {
    const SProgramRun run = RunCrash(folder, experiment);
    CHECK(run.Status == kStatusOfSignal + SIGSEGV);
    CHECK_THAT(run.Out, Contains("ep4 steps\nep0 steps\nep1 steps\nep2 steps\n"));
  }
  SECTION("to the log files, with the report") {
    const SProgramRun run = RunCrash(folder, experiment, {"-l", "log.txt", "-e", "err.txt"});
    CHECK(run.Status == kStatusOfSignal + SIGSEGV);
    CHECK_THAT(folder.Read("log.txt"), Contains("ep4 steps\nep0 steps\nep1 steps\nep2 steps\n"));
    CHECK_THAT(folder.Read("err.txt"), Contains("robot \"ep2\", controller \"c\""));
    CHECK_THAT(run.Err, Contains("robot \"ep2\", controller \"c\""));
  }
}

TEST_CASE("crash: --no-crash-handler leaves the signals alone", "[faults][crash]") {
  if (kHasSanitizer) {
    return;
  }
  SFaultExperiment experiment;
  experiment.Params = "where='step' what='segv'";
  const CTestFolder folder;
  const SProgramRun run = RunCrash(folder, experiment, {"--no-crash-handler"});
  CHECK(run.Status == kStatusOfSignal + SIGSEGV);
  CHECK(run.Err == "");
}

TEST_CASE("crash: a library is named that throws or crashes while it is loaded",
          "[faults][crash][bad_input]") {
  const CTestFolder folder;
  const std::string what = GENERATE("throw", "segv");
  if (kHasSanitizer && what == "segv") {
    return;
  }
  CAPTURE(what);
  const std::string library = InBuildTree("testing/plugins/libargos3_test_bad_start.so");
  std::string xml = SFaultExperiment().ToXml();
  xml.replace(xml.find(MisbehavingLibrary()), MisbehavingLibrary().size(), library);
  folder.Write("e.argos", xml);
  setenv("ARGOS_TEST_BAD_START", what.c_str(), 1);
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  unsetenv("ARGOS_TEST_BAD_START");
  CHECK(run.Status == (what == "throw" ? 1 : kStatusOfSignal + SIGSEGV));
  CHECK_THAT(run.Err, Contains("ibrary \"" + library + "\""));
  if (what == "throw") {
    CHECK_THAT(run.Err, Contains("e.argos:4:") && Contains("no good beginning"));
  }
}

TEST_CASE("bad input: a function that no library defines is an error at load, with its line",
          "[faults][bad_input]") {
  const CTestFolder folder;
  std::string xml = SFaultExperiment().ToXml();
  xml.replace(xml.find(MisbehavingLibrary()), MisbehavingLibrary().size(),
              InBuildTree("testing/plugins/libargos3_test_missing_function.so"));
  folder.Write("e.argos", xml);
  const SProgramRun run = folder.Run({"-c", "e.argos"});
  CHECK(run.Status == 1);
  CHECK_THAT(run.Err, Contains("e.argos:4: <test_misbehaves>: attribute \"library\"") &&
                          Contains("undefined symbol: argosTest::DefinedNowhere(int)"));
}

}  // namespace crash_test
