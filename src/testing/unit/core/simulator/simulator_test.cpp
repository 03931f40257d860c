#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/visualization/visualization.h>
#include <argos3/core/utility/profiler/profiler.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

namespace simulator_simulator_test {

using namespace argos;
using Catch::Contains;

namespace {

SExperiment Experiment() {
  return SExperiment{.Seed = 42,
                     .Controllers = R"(<toy_controller id='c'>
      <actuators> <toy_drive implementation='default' /> </actuators>
      <sensors> <toy_range implementation='default' noise='0.1' /> </sensors> </toy_controller>)",
                     .LoopFunctions = "<loop_functions label='toy_loop_functions' />",
                     .Engines = "<toy_engine id='toy' />",
                     .Media = "<toy_medium id='air' />",
                     .Arena = R"(
      <toy-robot id='r1'> <body position='0,0,0' /> <controller config='c' /> </toy-robot>
      <toy-robot id='r2'> <body position='0.5,0,0' /> <controller config='c' /> </toy-robot>)"};
}

// sets a random walk that depends on noisy sensors
void SetRandomWalk(CSimulator& simulator) {
  for (CControllableEntity* robot : simulator.GetSpace().GetControllableEntities()) {
    dynamic_cast<CToyController&>(robot->GetController()).OnStep = [](CToyController& controller) {
      controller.Velocity = CVector3(controller.LastRange - 0.5, 0.1 * controller.LastRange, 0.0);
    };
  }
}

std::vector<UInt64> Digests(CTestWorld& world, int ticks) {
  std::vector<UInt64> digests = {world.ComputeDigest()};
  for (int i = 0; i < ticks; ++i) {
    world.Step();
    digests.push_back(world.ComputeDigest());
  }
  return digests;
}

/** A temporary file, removed by the destructor. */
class CTemporaryFile {
 public:
  explicit CTemporaryFile(const std::string& content)
      : m_path(std::filesystem::temp_directory_path() /
               ("argos_test_" + std::to_string(reinterpret_cast<size_t>(this)) + ".argos")) {
    std::ofstream(m_path) << content;
  }
  ~CTemporaryFile() { std::filesystem::remove(m_path); }
  CTemporaryFile(const CTemporaryFile&) = delete;
  CTemporaryFile& operator=(const CTemporaryFile&) = delete;
  std::string GetPath() const { return m_path.string(); }

 private:
  std::filesystem::path m_path;
};

}  // namespace

TEST_CASE("simulator: parts are initialised in the documented order", "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.LoopFunctions = "<loop_functions label='toy_loop_functions' record='true' />";
  CTestWorld world(experiment);
  auto& functions = world.GetLoopFunctions<CToyLoopFunctions>();
  // controllers were initialised before the loop functions' Init() began to record
  CHECK(functions.Events == std::vector<std::string>{"loop functions init"});
  functions.Events.clear();
  world.GetSimulator().Reset();
  CHECK(functions.Events ==
        std::vector<std::string>{"controller reset r1", "controller reset r2", "reset"});
  CHECK(world.GetSimulator().GetMedium<CToyMedium>("air").WasPostSpaceInit);
}

TEST_CASE("simulator: Destroy() destroys the loop functions, then the entities in reverse order",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.LoopFunctions = "<loop_functions label='toy_loop_functions' record='true' />";
  CTestWorld world(experiment);
  // this pointer outlives the experiment
  CToyLoopFunctions* recorder = nullptr;
  {
    const CSimulator::CScope scope(world.GetSimulator());
    recorder = std::make_unique<CToyLoopFunctions>().release();
  }
  recorder->IsRecording = true;
  world.GetSimulator().SetLoopFunctions(*recorder);
  const int alive = CToyController::NumAlive;
  world.GetSimulator().Destroy();
  CHECK(recorder->Events ==
        std::vector<std::string>{"destroy", "controller destroy r2", "controller destroy r1"});
  CHECK(CToyController::NumAlive == alive - 2);
  const std::unique_ptr<CToyLoopFunctions> owned(recorder);
  CHECK_THROWS_AS(world.GetSimulator().GetLoopFunctions(), CARGoSException);
}

TEST_CASE("simulator: controllers that throw in Destroy() are errors, and everything is destroyed",
          "[core][simulator][errors]") {
  CTestWorld world(Experiment());
  CSimulator& simulator = world.GetSimulator();
  const int alive = CToyController::NumAlive;
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    dynamic_cast<CToyController&>(robot->GetController()).ThrowsInDestroy = true;
  }
  // entities are destroyed last to first
  CHECK_THROWS_WITH(simulator.Destroy(), Contains("the controller of r2 cannot be destroyed"));
  CHECK_THAT(TakeLogErr(), Contains("Destroy() of 1 more component of entities threw"));
  CHECK(CToyController::NumAlive == alive - 2);
  CHECK(simulator.GetPhysicsEngines().empty());
  CHECK(simulator.GetSpace().GetRootEntityVector().empty());
  CHECK(simulator.GetSpace().GetBodyIndex().GetNumBodies() == 0);
  CHECK_NOTHROW(simulator.Destroy());
}

TEST_CASE("simulator: runs the ticks of the experiment's length, then PostExperiment",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  // 0.3 / 0.1 is a little less than 3 in floating point
  experiment.Length = GENERATE(0.3, 0.35, 0.39999);
  CTestWorld world(experiment);
  CSimulator& simulator = world.GetSimulator();
  CHECK(simulator.GetMaxSimulationClock() == 3);
  auto& functions = world.GetLoopFunctions<CToyLoopFunctions>();
  functions.IsRecording = true;
  simulator.Execute();
  CHECK(world.GetSpace().GetSimulationClock() == 3);
  CHECK(std::count(functions.Events.begin(), functions.Events.end(), "post step") == 3);
  CHECK(functions.Events.back() == "post experiment");
  CHECK(simulator.IsExperimentFinished());
  // and again after a reset
  simulator.Reset();
  CHECK_FALSE(simulator.IsExperimentFinished());
  simulator.Execute();
  CHECK(world.GetSpace().GetSimulationClock() == 3);
}

TEST_CASE("simulator: length, seed, threads and attributes can be overridden",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.Length = 100.0;
  CTestWorld world(experiment, [](CSimulator& simulator) {
    simulator.SetLength(0.5);
    simulator.SetRandomSeed(7);
    simulator.SetNumThreads(2);
    simulator.AddOverride("//toy-robot[@id='r2']/body/@position", "3,0,0");
    simulator.AddOverride("framework/experiment/@ticks_per_second", "20");
  });
  CHECK(world.GetSimulator().GetMaxSimulationClock() == 10);
  CHECK(world.GetSimulator().GetRandomSeed() == 7);
  CHECK(world.GetSimulator().GetNumThreads() == 2);
  CHECK(world.GetSimulator().GetTickLength() == 0.05);
  CHECK(world.Get<CToyRobotEntity>("r2").GetEmbodiedEntity().GetOriginAnchor().Position ==
        CVector3(3.0, 0.0, 0.0));
  CHECK_THAT(TakeLog(), Contains("3,0,0"));
  world.GetSimulator().SetLength(0.0);
  CHECK(world.GetSimulator().GetMaxSimulationClock() == 0);
  CHECK_THROWS_AS(world.GetSimulator().SetLength(-1.0), CARGoSException);
}

TEST_CASE("simulator: an override without a match is an error", "[core][simulator]") {
  CHECK_THROWS_WITH(
      CTestWorld(Experiment(),
                 [](CSimulator& simulator) { simulator.AddOverride("framwork/@x", "1"); }),
      Contains("framwork/@x") && Contains("framework"));
}

TEST_CASE("simulator: ends on request or when the loop functions say so", "[core][simulator]") {
  CTestWorld world(Experiment());
  CSimulator& simulator = world.GetSimulator();
  CHECK(simulator.GetMaxSimulationClock() == 0);
  auto& functions = world.GetLoopFunctions<CToyLoopFunctions>();
  functions.IsFinished = [&] { return world.GetSpace().GetSimulationClock() == 4; };
  simulator.Execute();
  CHECK(world.GetSpace().GetSimulationClock() == 4);
  functions.IsFinished = {};
  functions.OnPostStep = [&] {
    if (world.GetSpace().GetSimulationClock() == 9) {
      simulator.Terminate();
    }
  };
  simulator.Execute();
  CHECK(world.GetSpace().GetSimulationClock() == 9);
  CHECK(simulator.IsExperimentFinished());
  simulator.Reset();
  CHECK_FALSE(simulator.IsExperimentFinished());
}

TEST_CASE("simulator: a tick observer is called after every tick", "[core][simulator]") {
  CTestWorld world(Experiment());
  std::vector<UInt32> ticks;
  world.GetSimulator().SetTickObserver(
      [&](CSimulator& simulator) { ticks.push_back(simulator.GetSpace().GetSimulationClock()); });
  world.Step(3);
  world.GetSimulator().SetTickObserver({});
  world.Step();
  CHECK(ticks == std::vector<UInt32>{1, 2, 3});
}

TEST_CASE("simulator: after a reset the run repeats bit by bit", "[core][simulator]") {
  CTestWorld world(Experiment());
  SetRandomWalk(world.GetSimulator());
  const std::vector<UInt64> first = Digests(world, 30);
  world.GetSimulator().Reset();
  CHECK(Digests(world, 30) == first);
  CHECK(first.front() != first.back());
}

TEST_CASE("simulator: a reset with another seed equals loading with that seed",
          "[core][simulator]") {
  CTestWorld world(Experiment());
  SetRandomWalk(world.GetSimulator());
  const std::vector<UInt64> first = Digests(world, 30);
  world.GetSimulator().Reset(43);
  CHECK(world.GetSimulator().GetRandomSeed() == 43);
  const std::vector<UInt64> other = Digests(world, 30);
  CHECK(other.back() != first.back());
  SExperiment experiment = Experiment();
  experiment.Seed = 43;
  CTestWorld fresh(experiment);
  SetRandomWalk(fresh.GetSimulator());
  CHECK(Digests(fresh, 30) == other);
}

TEST_CASE("simulator: random generators of users repeat after a reset", "[core][simulator]") {
  CTestWorld world(Experiment());
  const CSimulator::CScope scope(world.GetSimulator());
  CRandom::CRNG* const rng = CRandom::CreateRNG("argos");
  const CRange<Real> range(0.0, 1.0);
  const std::vector<Real> first = {rng->Uniform(range), rng->Uniform(range),
                                   world.GetSimulator().GetRNG()->Uniform(range)};
  world.GetSimulator().Reset();
  CHECK(std::vector<Real>{rng->Uniform(range), rng->Uniform(range),
                          world.GetSimulator().GetRNG()->Uniform(range)} == first);
  // the first generator of the category "argos" belongs to the simulator
  CRandom::CreateCategory("same", 42);
  world.GetSimulator().Reset();
  CHECK(CRandom::CreateRNG("same")->Uniform(range) ==
        world.GetSimulator().GetRNG()->Uniform(range));
}

TEST_CASE("simulator: the first generator of users has the second seed of the category",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.Seed = 124;
  CTestWorld world(experiment);
  const CSimulator::CScope scope(world.GetSimulator());
  // as in ARGoS 3, whose seeder gives 455545294 and then 2996933276
  CRandom::CRNG* const rng = CRandom::CreateRNG("argos");
  CHECK(rng->GetSeed() == 2996933276U);
  CHECK_THAT(rng->Uniform(CRange<Real>(0.0, 1.0)), Catch::WithinAbs(0.1766, 5e-5));
  CHECK(&world.GetSimulator().GetSpace().GetRNG() == world.GetSimulator().GetRNG());
}

TEST_CASE("simulator: without a seed, one is taken from the clock and logged",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.Seed = 0;
  CTestWorld world(experiment);
  const UInt32 seed = world.GetSimulator().GetRandomSeed();
  CHECK_THAT(TakeLog(), Contains("random seed = " + std::to_string(seed)));
  // the file has random_seed="0", which looks like a seed
  CHECK_THAT(TakeLogErr(), Contains("[WARNING] test.argos:") && Contains("random_seed=\"0\"") &&
                               Contains("random_seed=\"" + std::to_string(seed) + "\""));
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  world.GetSimulator().Reset();
  CHECK(world.GetSimulator().GetRandomSeed() != seed);
}

TEST_CASE("simulator: the seed 0 warns if a program sets it, other seeds do not",
          "[core][simulator]") {
  const UInt32 seed = GENERATE(0U, 1U);
  CTestWorld world(Experiment(), [seed](CSimulator& simulator) { simulator.SetRandomSeed(seed); });
  CHECK(world.GetSimulator().GetRandomSeed() == seed);
  const std::string warnings = TakeLogErr();
  CHECK((warnings.find("the seed 0 ") != std::string::npos) == (seed == 0));
  CHECK(warnings.empty() == (seed != 0));
}

TEST_CASE("simulator: attributes of the arena that have no effect are reported",
          "[core][simulator]") {
  std::string xml = Experiment().ToXml();
  xml.replace(xml.find("<arena") + 6, 0, " positional_index='grid'");
  CTestWorld world(xml);
  CHECK_THAT(TakeLogErr(), Contains("[WARNING] test.argos:") &&
                               Contains("\"positional_index\" has no effect") &&
                               Contains("each medium"));
}

TEST_CASE("simulator: after Destroy() it loads the experiment again and repeats the run",
          "[core][simulator]") {
  CConfigurationDocument document;
  CSimulator simulator;
  std::vector<UInt64> digests;
  for (int round = 0; round < 3; ++round) {
    document.Parse(Experiment().ToXml());
    simulator.Load(document);
    SetRandomWalk(simulator);
    for (int i = 0; i < 20; ++i) {
      simulator.UpdateSpace();
    }
    digests.push_back(simulator.GetSpace().ComputeDigest());
    if (round == 1) {
      simulator.Reset();
    }
    simulator.Destroy();
    CHECK(simulator.GetSpace().GetNumberEntities() == 0);
    CHECK(simulator.GetPhysicsEngines().empty());
    CHECK(simulator.GetMedia().empty());
  }
  CHECK(digests[1] == digests[0]);
  CHECK(digests[2] == digests[0]);
}

TEST_CASE("simulator: no state of an experiment is left for the next one", "[core][simulator]") {
  CConfigurationDocument document;
  CSimulator simulator;
  SExperiment experiment = Experiment();
  experiment.ArenaSize = "10,10,2' center='3,3,1";
  experiment.Length = 5.0;
  experiment.Threads = 2;
  std::string xml = experiment.ToXml();
  xml.replace(xml.find("random_seed"), 0, "real_time='true' ");
  document.Parse(xml);
  simulator.SetRandomSeed(99);
  simulator.AddOverride("framework/experiment/@length", "7");
  simulator.Load(document);
  CHECK(simulator.IsRealTimeClock());
  CHECK(simulator.GetMaxSimulationClock() == 70);
  simulator.Destroy();
  document.Parse(Experiment().ToXml());
  simulator.Load(document);
  CHECK(simulator.GetSpace().GetArenaCenter() == CVector3());
  CHECK(simulator.GetMaxSimulationClock() == 0);
  CHECK(simulator.GetNumThreads() == 0);
  CHECK_FALSE(simulator.IsRealTimeClock());
  CHECK(simulator.GetRandomSeed() == 42);
}

TEST_CASE("simulator: after an experiment that fails to load it can load another one",
          "[core][simulator]") {
  CConfigurationDocument document;
  CSimulator simulator;
  SExperiment bad = Experiment();
  bad.Arena +=
      "<toy-robot id='r3'> <body position='0,0,0' /> <controller config='nobody' /> </toy-robot>";
  const int alive = CToyController::NumAlive;
  document.Parse(bad.ToXml());
  CHECK_THROWS_WITH(simulator.Load(document), Contains("nobody"));
  CHECK(CToyController::NumAlive == alive);
  CHECK(simulator.GetSpace().GetRootEntityVector().empty());
  document.Parse(Experiment().ToXml());
  simulator.Load(document);
  CHECK(simulator.GetSpace().GetRootEntityVector().size() == 2);
}

TEST_CASE("simulator: all errors of a file are reported together", "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.Controllers += "<toy_controller id='c' />";
  experiment.Engines +=
      "<toy_engine id='toy' /> <toy_engin id='x' /> <toy_engine id='none' iterations='0' />";
  experiment.Media += "<toy_medium /> <toy_medium id='air' />";
  experiment.Arena += R"(
    <toy-robto id='r3' />
    <toy-robot id='r4'> <body position='0,0' /> <controller config='c' /> </toy-robot>
    <toy-lamp id='r1' />)";
  const std::string error = LoadError(experiment);
  CAPTURE(error);
  CHECK_THAT(error, Contains("9 errors"));
  CHECK_THAT(error, Contains("already a controller with id \"c\""));
  CHECK_THAT(error, Contains("already a physics engine with id \"toy\""));
  CHECK_THAT(error, Contains("<toy_engin>") && Contains("toy_engine"));
  CHECK_THAT(error, Contains("\"iterations\" must be at least 1"));
  CHECK_THAT(error, Contains("already a medium with id \"air\""));
  CHECK_THAT(error, Contains("toy-robto") && Contains("toy-robot"));
  CHECK_THAT(error, Contains("0,0"));
  CHECK_THAT(error, Contains("already an entity with id \"r1\""));
}

TEST_CASE("simulator: a wrong value in <framework> does not hide other errors",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.Method = "balance_lenght";
  experiment.TicksPerSecond = 0;
  const std::string error = LoadError(experiment);
  CAPTURE(error);
  CHECK_THAT(error, Contains("balance_length") && Contains("test.argos:2"));
  CHECK_THAT(error, Contains("ticks_per_second"));
}

TEST_CASE("simulator: missing sections are errors", "[core][simulator]") {
  const std::string xml = Experiment().ToXml();
  const std::string section =
      GENERATE("framework", "controllers", "physics_engines", "media", "arena");
  CAPTURE(section);
  std::string without = xml;
  without.replace(without.find("<" + section) + 1, section.size(), "other");
  without.replace(without.find("</" + section) + 2, section.size(), "other");
  CHECK_THROWS_WITH(CTestWorld(without), Contains(section));
}

TEST_CASE("simulator: unused elements and attributes are reported with their lines",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.Arena += "\n<toy-lamp id='lamp' colour='red'> <shade /> </toy-lamp>";
  CTestWorld world(experiment);
  const std::string warnings = TakeLogErr();
  CHECK_THAT(warnings, Contains("colour") && Contains("<toy-lamp>") && Contains("test.argos:14"));
  CHECK_THAT(warnings, Contains("<shade> is not used"));
}

TEST_CASE("simulator: an unknown visualization is a warning and a headless run",
          "[core][simulator]") {
  std::string xml = Experiment().ToXml();
  xml.insert(xml.find("</argos-configuration>"),
             "<visualization> <webviz port='3000' /> </visualization>");
  CConfigurationDocument document;
  document.Parse(xml, "test.argos");
  CSimulator simulator;
  simulator.SetLength(0.2);
  simulator.Load(document);
  CHECK_THAT(TakeLogErr(), Contains("[WARNING]") && Contains("webviz") && Contains("test.argos:"));
  simulator.Execute();
  CHECK(simulator.GetSpace().GetSimulationClock() == 2);
}

TEST_CASE("simulator: a profile counts every phase of every tick", "[core][simulator]") {
  const CTemporaryFile file("");
  std::string xml = Experiment().ToXml();
  const std::string end = "</framework>";
  xml.insert(xml.find(end), "<profiling file='" + file.GetPath() + "' format='human_readable' />");
  {
    CTestWorld world(xml);
    CHECK(world.GetSimulator().IsProfiling());
    world.Step(3);
    world.GetSimulator().Destroy();
    CHECK_FALSE(world.GetSimulator().IsProfiling());
  }
  std::ostringstream report;
  report << std::ifstream(file.GetPath()).rdbuf();
  for (const std::string phase :
       {"act", "physics", "index", "media", "pre-step", "sense+control", "post-step"}) {
    CAPTURE(phase, report.str());
    const size_t start = report.str().find("phase \"" + phase + "\": ");
    REQUIRE(start != std::string::npos);
    const std::string line = report.str().substr(start, report.str().find('\n', start) - start);
    CHECK_THAT(line, Contains(" 3 times, "));
    // every phase takes some time
    CHECK_THAT(line, !Contains(" 0.000000 us each"));
  }
}

TEST_CASE("simulator: an engine that does not exist is replaced with one warning",
          "[core][simulator]") {
  CTestWorld world(Experiment());
  CSimulator& simulator = world.GetSimulator();
  CHECK(&simulator.GetPhysicsEngine("toi") == simulator.GetPhysicsEngines().front());
  CHECK_THAT(TakeLogErr(), Contains("GetPhysicsEngine(\"toi\")") &&
                               Contains("did you mean \"toy\"") && Contains("is used instead"));
  simulator.GetPhysicsEngine("toi");
  CHECK(TakeLogErr().empty());
}

TEST_CASE("simulator: before engines exist, one stands in that knows the clock",
          "[core][simulator]") {
  CSimulator simulator;
  const CPhysicsEngine& engine = simulator.GetPhysicsEngine("dyn2d");
  CHECK_THAT(TakeLogErr(), Contains("GetPhysicsEngine(\"dyn2d\")") && Contains("do not exist yet"));
  CHECK(engine.GetId() == "dyn2d");
  CHECK(engine.GetIterations() == 10);
  const CSimulator::CScope scope(simulator);
  CPhysicsEngine::SetSimulationClockTick(0.25);
  CHECK(engine.GetInverseSimulationClockTick() == 4.0);
  for (const Real wrong : {0.0, -0.1, std::nan("")}) {
    CHECK_THROWS_WITH(CPhysicsEngine::SetSimulationClockTick(wrong),
                      Contains("the length of a tick must be positive"));
  }
  CHECK(engine.GetInverseSimulationClockTick() == 4.0);
  CHECK(&simulator.GetPhysicsEngine("other") == &engine);
  CHECK_THAT(TakeLogErr(), Contains("\"other\""));
}

TEST_CASE("simulator: access to parts that do not exist is an error", "[core][simulator]") {
  CSimulator simulator;
  CHECK_THROWS_AS(simulator.GetLoopFunctions(), CARGoSException);
  CHECK_THROWS_AS(simulator.GetVisualization(), CARGoSException);
  CHECK_THROWS_AS(simulator.GetConfigurationRoot(), CARGoSException);
  CHECK_THROWS_AS(simulator.Reset(), CARGoSException);
  CTestWorld world(Experiment());
  CHECK_THROWS_WITH(world.GetSimulator().GetMedium<CToyMedium>("fire"),
                    Contains("fire") && Contains("air"));
  CHECK_THROWS_WITH(world.GetSimulator().GetConfigForController("d"), Contains("\"d\""));
  CHECK_THROWS_AS(world.GetSimulator().GetProfiler(), CARGoSException);
  CHECK_FALSE(world.GetSimulator().IsProfiling());
  class COtherMedium : public CToyMedium {};
  CHECK_THROWS_WITH(world.GetSimulator().GetMedium<COtherMedium>("air"), Contains("air"));
  CHECK(world.GetSimulator().GetConfigForController("c").Value() == "toy_controller");
  CHECK(world.GetSimulator().GetConfigurationRoot().Value() == "argos-configuration");
}

TEST_CASE("simulator: loads from a file", "[core][simulator]") {
  const CTemporaryFile file(Experiment().ToXml());
  CSimulator simulator;
  simulator.SetExperimentFileName(file.GetPath());
  CHECK(simulator.GetExperimentFileName() == file.GetPath());
  simulator.LoadExperiment();
  simulator.UpdateSpace();
  // a second experiment at the same time is refused and leaves the first unchanged
  CHECK_THROWS_WITH(simulator.LoadExperiment(), Contains("Destroy()"));
  CHECK(simulator.GetConfigForController("c").Value() == "toy_controller");
  simulator.Reset();
  simulator.UpdateSpace();
  simulator.Destroy();
  simulator.SetExperimentFileName("/no/such/file.argos");
  CHECK_THROWS_WITH(simulator.LoadExperiment(), Contains("/no/such/file.argos"));
}

TEST_CASE("simulator: in real time a tick takes as long as it is", "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.TicksPerSecond = 50;
  experiment.Length = 0.2;
  CTestWorld world(experiment);
  world.GetSimulator().SetRealTimeClock(true);
  const auto start = std::chrono::steady_clock::now();
  world.GetSimulator().Execute();
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - start;
  CHECK(world.GetSpace().GetSimulationClock() == 10);
  // a sleep never ends early; how late it ends depends on the machine
  CHECK(duration.count() >= 0.2 - 1e-6);
  TakeLogErr();
}

TEST_CASE("simulator: a late tick is reported as a warning, and the run goes on",
          "[core][simulator]") {
  SExperiment experiment = Experiment();
  experiment.TicksPerSecond = 1000;
  experiment.Length = 0.003;
  CTestWorld world(experiment);
  world.GetSimulator().SetRealTimeClock(true);
  world.GetLoopFunctions<CToyLoopFunctions>().OnPostStep = [] {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
  };
  world.GetSimulator().Execute();
  CHECK(world.GetSpace().GetSimulationClock() == 3);
  CHECK_THAT(TakeLogErr(), Contains("[WARNING]") && Contains("late"));
}

}  // namespace simulator_simulator_test
