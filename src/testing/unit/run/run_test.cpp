#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/logging/log_control.h>
#include <argos3/run/run.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <csignal>
#include <new>
#include <string>
#include <vector>

namespace run_run_test {

using namespace argos;
using Catch::Contains;

namespace {

/** A run of two robots over ten ticks of 0.1 s, whose failures are only data. */
struct SToyRun {
  CConfigurationDocument Document;  // outlives what is loaded from it
  CSimulator Simulator;
  CSimulator::CScope Scope{Simulator};
  std::vector<std::string> Reported;
  CRun Run{Simulator, [this](const SRunFailure& failure) { Reported.push_back(failure.Text); }};

  bool Load(const std::string& loopFunctions = "") {
    return Run.Load([&] {
      Document.Parse(SExperiment{.Length = 1.0,
                                 .Controllers = R"(<toy_controller id='c'> <actuators />
          <sensors /> </toy_controller>)",
                                 .LoopFunctions = loopFunctions,
                                 .Engines = "<toy_engine id='toy' />",
                                 .Arena = R"(
          <toy-robot id='r1'> <body position='0,0,0' /> <controller config='c' /> </toy-robot>
          <toy-robot id='r2'> <body position='1,0,0' /> <controller config='c' /> </toy-robot>)"}
                         .ToXml(),
                     "run.argos");
      Simulator.Load(Document);
    });
  }
};

}  // namespace

TEST_CASE("run: what ends normally is done, and has its measures", "[run]") {
  SToyRun toy;
  REQUIRE(toy.Load());
  int observed = 0;
  CHECK(toy.Run.Execute([&](CSimulator&) { ++observed; }));
  UInt32 robots = 0;
  CHECK(toy.Run.Do([&] { robots = toy.Run.GetSummary().Robots; }));
  const SRunSummary& summary = toy.Run.Finish();
  CHECK(summary.Status == ERunStatus::Done);
  CHECK(summary.GetExitStatus() == 0);
  CHECK(observed == 10);
  CHECK(summary.Ticks == 10);
  // 10 ticks of 0.1 s: one rounding
  CHECK_THAT(summary.SimulatedTime, Catch::WithinULP(1.0, 1));
  CHECK(robots == 2);
  CHECK(summary.StartUpTime > 0.0);
  CHECK(summary.WallTime > 0.0);
  CHECK(summary.Failures.empty());
  CHECK(toy.Reported.empty());
  CHECK_THAT(DescribeRun(summary),
             Contains("simulated 1 s in ") && Contains("10 ticks, 2 robots)"));
}

TEST_CASE("run: after a failure steps are left out, but the destruction", "[run]") {
  SToyRun toy;
  REQUIRE(toy.Load("<loop_functions label='toy_loop_functions' />"));
  auto& functions = dynamic_cast<CToyLoopFunctions&>(toy.Simulator.GetLoopFunctions());
  int ticks = 0;
  functions.OnPostStep = [&] {
    if (++ticks == 3) {
      THROW_ARGOSEXCEPTION("third\n[WARNING] second line");
    }
  };
  CHECK_FALSE(toy.Run.Execute());
  CHECK_FALSE(toy.Run.Do([] { FAIL("a step after a failure"); }));
  const SRunSummary& summary = toy.Run.Finish();
  CHECK(summary.Status == ERunStatus::Failed);
  CHECK(summary.GetExitStatus() == 1);
  CHECK(summary.Ticks == 3);
  REQUIRE(summary.Failures.size() == 1);
  CHECK_THAT(summary.Failures[0].Text,
             Contains("[FATAL] ") && Contains("third") && Contains("\n[WARNING] second line"));
  CHECK_FALSE(summary.Failures[0].IsOutOfMemory);
  CHECK(toy.Reported == std::vector<std::string>{summary.Failures[0].Text});
  CHECK_THROWS_AS(toy.Simulator.GetMetrics(), CARGoSException);  // no experiment is loaded
}

TEST_CASE("run: what cannot be loaded is not executed", "[run]") {
  SToyRun toy;
  CHECK_FALSE(toy.Load("<loop_functions label='no_such_functions' />"));
  CHECK_FALSE(toy.Run.Execute([](CSimulator&) { FAIL("a tick"); }));
  CHECK(toy.Run.Finish().Status == ERunStatus::Failed);
  CHECK_THAT(toy.Reported.at(0), Contains("no_such_functions"));
}

TEST_CASE("run: memory that is not granted, and signals, are statuses of their own", "[run]") {
  SToyRun toy;
  REQUIRE(toy.Load());
  SECTION("no memory") {
    CHECK_FALSE(toy.Run.Execute([](CSimulator&) { throw std::bad_alloc(); }));
    CHECK(toy.Run.Finish().Status == ERunStatus::OutOfMemory);
    CHECK(toy.Run.GetSummary().GetExitStatus() == 1);
    CHECK(toy.Reported == std::vector<std::string>{"[FATAL] not enough memory"});
  }
  SECTION("signal") {
    CHECK(toy.Run.Execute([](CSimulator& simulator) { simulator.Terminate(); }));
    toy.Run.SetSignal(SIGTERM);
    CHECK(toy.Run.Finish().Status == ERunStatus::Interrupted);
    CHECK(toy.Run.GetSummary().GetExitStatus() == 128 + SIGTERM);
    CHECK(toy.Run.GetSummary().Ticks == 1);
  }
}

TEST_CASE("run: warnings are collected beside the log, and beside others that see it", "[run]") {
  SToyRun toy;
  toy.Run.CollectWarnings();
  std::vector<std::string> seen;
  {
    // as a view has one during the run
    const CLogObserver other([&seen](ELogLevel, const std::string& line) { seen.push_back(line); });
    LOG << "a line for both" << std::endl;
    LOG.Flush();
  }
  REQUIRE(toy.Load());
  CHECK(toy.Run.Do([] {
    LOG << "[WARNING] one" << std::endl << "[INFO] two" << std::endl;
    LOG.Flush();
    LOG << "[WARN";
    LOG.Flush();
    LOG << "ING] three" << std::endl;
  }));
  CHECK(toy.Run.Finish().Warnings == std::vector<std::string>{"[WARNING] one", "[WARNING] three"});
  LOG << "[WARNING] after the run" << std::endl;
  LOG.Flush();
  CHECK(toy.Run.GetSummary().Warnings.size() == 2);
  CHECK(seen == std::vector<std::string>{"a line for both"});
}

TEST_CASE("run: at most 200 warnings are collected, the first ones", "[run]") {
  SToyRun toy;
  toy.Run.CollectWarnings();
  REQUIRE(toy.Load());
  CHECK(toy.Run.Do([] {
    for (int i = 1; i <= 201; ++i) {
      LOG << "[WARNING] " << i << std::endl;
    }
    LOG.Flush();
  }));
  const std::vector<std::string>& warnings = toy.Run.Finish().Warnings;
  REQUIRE(warnings.size() == CRun::kMaxWarnings);
  CHECK(warnings.front() == "[WARNING] 1");
  CHECK(warnings.back() == "[WARNING] 200");
}

TEST_CASE("run: each status has its word, and its exit status", "[run]") {
  for (const ERunStatus status :
       {ERunStatus::Done, ERunStatus::RobotsStopped, ERunStatus::Failed, ERunStatus::Crashed,
        ERunStatus::TimedOut, ERunStatus::OutOfMemory, ERunStatus::Interrupted}) {
    CHECK(ToRunStatus(ToText(status)) == status);
  }
  CHECK(ToExitStatus(ERunStatus::Done) == 0);
  CHECK(ToExitStatus(ERunStatus::RobotsStopped) == 3);
  CHECK(ToExitStatus(ERunStatus::Failed) == 1);
  CHECK(ToExitStatus(ERunStatus::TimedOut) == 1);
  CHECK(ToExitStatus(ERunStatus::Crashed, SIGSEGV) == 139);
  CHECK_THROWS_WITH(ToRunStatus("don"), Contains("\"don\"") && Contains("done"));
}

TEST_CASE("run: the line about a run has its times and robots", "[run]") {
  SRunSummary summary;
  summary.SimulatedTime = 12.5;
  summary.WallTime = 0.25;
  summary.OutputTime = 0.05;
  summary.Robots = 1;
  summary.Ticks = 1;
  CHECK(DescribeRun(summary) ==
        "simulated 12.5 s in 0.25 s of wall time (real-time factor 50, 1 tick, 1 robot)");
  summary.Robots = 2;
  summary.Ticks = 125;
  summary.HasOutputs = true;
  CHECK(DescribeRun(summary) ==
        "simulated 12.5 s in 0.25 s of wall time (real-time factor 50, 125 ticks, 2 robots): "
        "0.2 s for the simulation, 0.05 s for its outputs");
  summary.OutputTime = 0.5;
  summary.WallTime = 0.0;
  CHECK(DescribeRun(summary) ==
        "simulated 12.5 s in 0 s of wall time (real-time factor 0, 125 ticks, 2 robots): "
        "0 s for the simulation, 0.5 s for its outputs");
}

}  // namespace run_run_test
