#include <argos3/core/control_interface/ci_actuator.h>
#include <argos3/core/simulator/entity/actuator.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/core/utility/logging/argos_log.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_grid.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <array>
#include <mutex>
#include <set>
#include <thread>

namespace tick_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

SExperiment Recorded() {
  return SExperiment{.Controllers = R"(<toy_controller id='c'>
      <actuators> <toy_drive implementation='default' /> </actuators>
      <sensors> <toy_range implementation='default' /> </sensors>
      <params velocity='1,0,0' /> </toy_controller>)",
                     .LoopFunctions = "<loop_functions label='toy_loop_functions' record='true' />",
                     .Engines = "<toy_engine id='toy' iterations='1' />",
                     .Media = "<toy_medium id='air' />",
                     .Arena = R"(
      <toy-robot id='r1'> <body position='0,0,0' /> <controller config='c' /> </toy-robot>
      <toy-robot id='r2'> <body position='0,1,0' /> <controller config='c' /> </toy-robot>
      <toy-block id='b' size='0.2,4,1' movable='false'> <body position='2,0,0' /> </toy-block>)"};
}

SExperiment ManyRobots(UInt32 threads, const std::string& method) {
  SExperiment experiment = Recorded();
  experiment.Threads = threads;
  experiment.Method = method;
  experiment.LoopFunctions = "<loop_functions label='toy_loop_functions' />";
  experiment.Arena = ToyRobotGrid(20);
  return experiment;
}

/** Records a metric in each tick. */
class CScribeActuator : public CSimulatedActuator, public CCI_Actuator {
 public:
  void SetRobot(CComposableEntity& /*robot*/) override {}
  void Update() override { CSimulator::GetInstance().GetMetrics().Record("acts", 2.5); }
  void Reset() override {}
};
REGISTER_ACTUATOR(CScribeActuator, "tick_scribe", "default", "", "", "", "", "")

CToyController& ControllerOf(CTestWorld& world, const std::string& robot) {
  return dynamic_cast<CToyController&>(
      world.Get<CToyRobotEntity>(robot).GetControllableEntity().GetController());
}

Real X(CTestWorld& world, const std::string& robot) {
  return world.Get<CToyRobotEntity>(robot).GetEmbodiedEntity().GetOriginAnchor().Position.GetX();
}

}  // namespace

TEST_CASE("tick: the phases are physics, media, PreStep, control, PostStep", "[core][tick]") {
  CTestWorld world(Recorded());
  auto& functions = world.GetLoopFunctions<CToyLoopFunctions>();
  functions.IsRecording = true;
  functions.Events.clear();
  world.Step();
  CHECK(functions.Events == std::vector<std::string>{"physics toy", "medium air", "pre step",
                                                     "control r1", "control r2", "post step"});
}

TEST_CASE("tick: a command of step k acts in tick k + 1", "[core][tick]") {
  CTestWorld world(Recorded());
  // one step of 0.1 s at 1 m/s is a single addition of 0.1
  world.Step();
  CHECK(X(world, "r1") == 0.0);
  world.Step();
  CHECK(X(world, "r1") == 0.1);
  ControllerOf(world, "r1").Velocity = CVector3(-2.0, 0.0, 0.0);
  world.Step();
  CHECK(X(world, "r1") == 0.2);
  world.Step();
  CHECK_THAT(X(world, "r1"), WithinAbs(0.0, 1e-15));
}

TEST_CASE("tick: metrics that actuators record count in the same tick", "[core][tick][metrics]") {
  SExperiment experiment = Recorded();
  experiment.Controllers = R"(<toy_controller id='c'>
      <actuators> <tick_scribe implementation='default' /> </actuators> <sensors />
      </toy_controller>)";
  CTestWorld world(experiment);
  const CMetrics& metrics = world.GetSimulator().GetMetrics();
  for (UInt32 tick = 1; tick <= 2; ++tick) {
    world.Step();
    const CMetrics::SMetric* const acts = metrics.Find("acts");
    REQUIRE(acts != nullptr);
    CHECK(acts->Tick == tick);
    CHECK(acts->Count == 2);
    CHECK(acts->Sum == 5.0);
  }
}

TEST_CASE("tick: sensors read the poses after this tick's physics and PreStep's changes",
          "[core][tick]") {
  CTestWorld world(Recorded());
  // from the rim at x + 0.05 to the face at 1.9
  world.Step();
  CHECK(ControllerOf(world, "r1").LastRange == 1.0);
  world.Step(11);
  CHECK_THAT(X(world, "r1"), WithinAbs(1.1, 1e-14));
  CHECK_THAT(ControllerOf(world, "r1").LastRange, WithinAbs(0.75, 1e-14));
  world.GetLoopFunctions<CToyLoopFunctions>().OnPreStep = [&] {
    world.Get<CToyRobotEntity>("r1").GetEmbodiedEntity().MoveTo(CVector3(1.35, 0.0, 0.0),
                                                                CQuaternion());
  };
  world.Step();
  CHECK_THAT(ControllerOf(world, "r1").LastRange, WithinAbs(0.5, 1e-14));
}

TEST_CASE("tick: entities added or removed by hooks are sensed or gone in the same tick",
          "[core][tick]") {
  CTestWorld world(Recorded());
  const CSimulator::CScope scope(world.GetSimulator());
  auto& functions = world.GetLoopFunctions<CToyLoopFunctions>();
  functions.OnPreStep = [&] {
    if (world.GetSpace().GetSimulationClock() == 1) {
      functions.AddEntity(*std::make_unique<CToyBlockEntity>("near", CVector3(0.6, 0.0, 0.0),
                                                             CVector3(0.2, 0.2, 1.0))
                               .release());
    } else if (world.GetSpace().GetSimulationClock() == 3) {
      functions.RemoveEntity("near");
    }
  };
  world.Step();
  CHECK_THAT(ControllerOf(world, "r1").LastRange, WithinAbs(0.45, 1e-14));
  world.Step();
  CHECK_THAT(ControllerOf(world, "r1").LastRange, WithinAbs(0.35, 1e-14));
  world.Step();
  CHECK(ControllerOf(world, "r1").LastRange == 1.0);
}

TEST_CASE("tick: hooks may remove robots of a swarm that is large enough for looking ahead",
          "[core][tick][threads]") {
  const UInt32 threads = GENERATE(0U, 4U);
  CAPTURE(threads);
  SExperiment experiment = ManyRobots(threads, "balance_quantity");
  experiment.ArenaSize = "20,20,2";
  // more robots than those for which CLookAhead does nothing
  experiment.Arena = ToyRobotGrid(50);
  CTestWorld world(experiment);
  const CSimulator::CScope scope(world.GetSimulator());
  auto& functions = world.GetLoopFunctions<CToyLoopFunctions>();
  int removed = 0;
  const auto removeSome = [&] {
    for (int i = 0; i < 30; ++i) {
      functions.RemoveEntity("r" + std::to_string(removed++));
    }
  };
  functions.OnPreStep = removeSome;
  functions.OnPostStep = removeSome;
  world.Step(5);
  REQUIRE(removed == 300);
  const auto& robots = world.GetSpace().GetControllableEntities();
  REQUIRE(robots.size() == 2200);
  for (CControllableEntity* robot : robots) {
    REQUIRE(dynamic_cast<CToyController&>(robot->GetController()).Steps == 5);
  }
}

TEST_CASE("tick: every robot steps once a tick, on any number of threads",
          "[core][tick][threads]") {
  const UInt32 threads = GENERATE(0U, 1U, 2U, 4U, 15U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  CTestWorld world(ManyRobots(threads, method));
  CHECK(world.GetSimulator().GetNumThreads() == threads);
  world.Step(5);
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    REQUIRE(dynamic_cast<CToyController&>(robot->GetController()).Steps == 5);
  }
}

TEST_CASE("tick: controllers can access their simulator on every thread", "[core][tick][threads]") {
  CTestWorld world(ManyRobots(4, "balance_length"));
  std::atomic<int> wrong{0};
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    dynamic_cast<CToyController&>(robot->GetController()).OnStep = [&](CToyController&) {
      wrong += &CSimulator::GetInstance() == &world.GetSimulator() ? 0 : 1;
    };
  }
  world.Step(3);
  CHECK(wrong == 0);
}

TEST_CASE("tick: controllers may read the space concurrently", "[core][tick][threads]") {
  CTestWorld world(ManyRobots(4, "balance_length"));
  std::atomic<int> wrong{0};
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    dynamic_cast<CToyController&>(robot->GetController()).OnStep = [&](CToyController& controller) {
      CSpace& space = CSimulator::GetInstance().GetSpace();
      wrong += space.GetEntitiesByType("toy-robot").size() == 400 ? 0 : 1;
      wrong += &space.GetEntity(controller.GetId() + ".body_0").GetRootEntity() ==
                       &space.GetEntity(controller.GetId())
                   ? 0
                   : 1;
    };
  }
  world.Step(3);
  CHECK(wrong == 0);
}

TEST_CASE("tick: an exception of a controller names it and the tick, for any number of threads",
          "[core][tick][threads]") {
  const UInt32 threads = GENERATE(0U, 2U, 4U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  CTestWorld world(ManyRobots(threads, method));
  for (const std::string robot : {"r77", "r123", "r399"}) {
    ControllerOf(world, robot).OnStep = [](CToyController& controller) {
      if (controller.Steps == 3) {
        throw std::runtime_error("out of ideas");
      }
    };
  }
  world.Step(2);
  CHECK_THROWS_WITH(world.Step(),
                    Contains("\"r77\"") && Contains("tick 3") && Contains("out of ideas"));
}

TEST_CASE("tick: a thrown value that is not a std::exception is reported with its controller",
          "[core][tick]") {
  CTestWorld world(Recorded());
  ControllerOf(world, "r2").OnStep = [](CToyController&) { throw 42; };
  CHECK_THROWS_WITH(world.Step(), Contains("\"r2\"") && Contains("tick 1"));
}

TEST_CASE("tick: log output follows the order of phases and, within a phase, of robots",
          "[core][tick][logging]") {
  const UInt32 threads = GENERATE(0U, 4U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  CTestWorld world(ManyRobots(threads, method));
  auto& functions = world.GetLoopFunctions<CToyLoopFunctions>();
  functions.OnPreStep = [] { LOG << "pre" << std::endl; };
  functions.OnPostStep = [] { LOG << "post" << std::endl; };
  std::string expected = "pre\n";
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    dynamic_cast<CToyController&>(robot->GetController()).OnStep = [](CToyController& controller) {
      LOG << "step " << controller.GetId() << std::endl;
    };
    expected += "step " + robot->GetRootEntity().GetId() + "\n";
  }
  expected += "post\n";
  TakeLog();
  world.Step();
  CHECK((TakeLog() == expected));
  world.Step();
  CHECK((TakeLog() == expected));
}

namespace {

// uses the thread pool itself, which is not possible inside a parallel phase
class CPoolMedium : public CMedium {
 public:
  void Update() override {
    m_cSimulator.GetThreadPool().ParallelFor(100, 1, [this](size_t begin, size_t end, UInt32) {
      for (size_t i = begin; i < end; ++i) {
        ++Counts[i];
      }
    });
    LOG << "medium " << GetId() << std::endl;
  }
  bool UsesThreadPool() const override { return true; }

  std::array<int, 100> Counts{};
};

// works in one thread
class CAloneMedium : public CMedium {
 public:
  void Update() override { LOG << "medium " << GetId() << std::endl; }
};

REGISTER_MEDIUM(CPoolMedium, "pool_medium", "", "", "A medium for tests.", "", "")
REGISTER_MEDIUM(CAloneMedium, "alone_medium", "", "", "A medium for tests.", "", "")

}  // namespace

TEST_CASE("tick: media that use the thread pool run beside media that do not",
          "[core][tick][threads]") {
  const UInt32 threads = GENERATE(0U, 1U, 4U);
  SExperiment experiment = ManyRobots(threads, "balance_length");
  experiment.Media =
      "<alone_medium id='a'/><pool_medium id='b'/><alone_medium id='c'/><pool_medium id='d'/>";
  CTestWorld world(experiment);
  TakeLog();
  world.Step();
  // the log output follows the order of the file
  CHECK(TakeLog() == "medium a\nmedium b\nmedium c\nmedium d\n");
  world.Step(2);
  for (const char* id : {"b", "d"}) {
    for (const int count : world.GetSimulator().GetMedium<CPoolMedium>(id).Counts) {
      CHECK(count == 3);
    }
  }
}

}  // namespace tick_test
