// Metrics that sensors, controllers and hooks record: equal to the bit for any number of threads.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/control_interface/ci_sensor.h>
#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/core/simulator/space/metrics.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/sanitizers.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <bit>
#include <cmath>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace determinism_metrics_test {

using namespace argos;
using Catch::Contains;

namespace {

constexpr UInt32 kSide = 14;
constexpr UInt32 kRobots = kSide * kSide;  // more than three runs of robots
constexpr UInt32 kTicks = 8;
constexpr UInt32 kLateTick = 4;

CMetrics& Metrics() {
  return CSimulator::GetInstance().GetMetrics();
}

UInt32 NumberOf(const std::string& id) {
  return static_cast<UInt32>(std::stoul(id.substr(1)));
}

// of such different sizes that a sum depends on the order
Real ValueOf(UInt32 robot, UInt32 tick, UInt32 call) {
  const Real x = std::sin(1.0 + robot * 7.0 + tick * 3.0 + call);
  return x * std::pow(10.0, static_cast<int>(robot * 5 % 13) - 6);
}

class CMetricSensor : public CSimulatedSensor, public CCI_Sensor {
 public:
  void SetRobot(CComposableEntity& robot) override { m_number = NumberOf(robot.GetId()); }
  void Init(TConfigurationNode& tree) override {
    CCI_Sensor::Init(tree);
    Enable();
  }
  void Update() override {
    const UInt32 tick = CSimulator::GetInstance().GetSpace().GetSimulationClock();
    Metrics().Record("value", ValueOf(m_number, tick, 0), "m");
  }
  void Reset() override {}
#ifdef ARGOS_WITH_LUA
  void CreateLuaState(lua_State*) override {}
  void ReadingsToLuaState(lua_State*) override {}
#endif

 private:
  UInt32 m_number = 0;
};
REGISTER_SENSOR(CMetricSensor, "metric_recorder", "default", "", "", "", "", "")

// the threads that have run robots, if they are noted
std::atomic<bool> areThreadsNoted{false};
std::mutex threadsMutex;
std::set<std::thread::id> threadsOfRobots;

void NoteThread() {
  if (!areThreadsNoted) {
    return;
  }
  const std::lock_guard<std::mutex> lock(threadsMutex);
  threadsOfRobots.insert(std::this_thread::get_id());
}

/* What it records is chosen by the parameter "records". */
class CMetricRecorder : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    GetNodeAttributeOrDefault(params, "records", m_records, m_records);
    m_number = NumberOf(GetId());
  }
  void Reset() override { Metrics().Record("resets", m_number); }
  void ControlStep() override {
    NoteThread();
    const UInt32 tick = CSimulator::GetInstance().GetSpace().GetSimulationClock();
    if (m_records == "nan") {
      Metrics().Record("value", m_number == 3 ? std::log(-1.0) : 1.0);
    } else if (m_records == "units") {
      Metrics().Record("value", m_number, m_number == 5 || m_number == 7 ? "cm" : "m");
    } else if (m_records == "set") {
      Metrics().Set("value", 1.0);
    } else {
      RecordAll(tick);
    }
  }

 private:
  void RecordAll(UInt32 tick) const {
    Metrics().Record("value", ValueOf(m_number, tick, 1));
    Metrics().Record("value", ValueOf(m_number, tick, 2));
    if ((m_number + tick) % 3 == 0) {
      Metrics().Record("some_of_the_robots", ValueOf(m_number, tick, 3));
    }
    if (tick == kLateTick) {
      static const std::string names[] = {"late_a", "late_b", "late_c", "late_d", "late_e"};
      Metrics().Record(names[(m_number * 3 + 2) % 5], ValueOf(m_number, tick, 4));
    }
  }

  std::string m_records = "all";
  UInt32 m_number = 0;
};
REGISTER_CONTROLLER(CMetricRecorder, "metric_recorder")

SExperiment Recorders(const std::string& records = "all", const std::string& onError = "end_run") {
  SExperiment experiment;
  experiment.Controllers =
      "<metric_recorder id='c' on_error='" + onError +
      "'><actuators/><sensors>"
      "<metric_recorder implementation='default'/></sensors><params records='" +
      records + "'/></metric_recorder>";
  if (records != "all") {
    const std::string sensor = "<metric_recorder implementation='default'/>";
    experiment.Controllers.erase(experiment.Controllers.find(sensor), sensor.size());
  }
  experiment.LoopFunctions = "<loop_functions label='toy_loop_functions'/>";
  experiment.Engines = "<toy_engine id='toy'/>";
  const std::string side = std::to_string(kSide);
  experiment.Arena =
      "<distribute><position method='grid' center='0,0,0' distances='0.3,0.3,1' "
      "layout='" +
      side + "," + side + ",1'/><orientation method='constant' values='0,0,0'/><entity quantity='" +
      std::to_string(kRobots) +
      "' max_trials='1'><toy-robot id='r'><controller config='c'/></toy-robot>"
      "</entity></distribute>";
  return experiment;
}

// what the metrics of a tick are, to the bit
std::vector<std::string> Snapshot(const CMetrics& metrics) {
  std::vector<std::string> all;
  for (const CMetrics::SMetric& metric : metrics.GetAll()) {
    std::string text = metric.Name + ' ' + metric.Unit + ' ' + std::to_string(metric.Count);
    if (metric.IsReproducible) {
      text += ' ' + std::to_string(metric.Tick);
      for (const Real number : {metric.Value, metric.Sum, metric.Min, metric.Max, metric.Last}) {
        text += ' ' + std::to_string(std::bit_cast<UInt64>(number));
      }
    }
    all.push_back(text);
  }
  return all;
}

using TRun = std::vector<std::vector<std::string>>;

TRun Run(CTestWorld& world) {
  const CSimulator::CScope scope(world.GetSimulator());
  auto& hooks = world.GetLoopFunctions<CToyLoopFunctions>();
  hooks.OnPreStep = [&] {
    hooks.IterateOverControllableEntities([&](CControllableEntity* robot) {
      const UInt32 tick = world.GetSpace().GetSimulationClock();
      Metrics().Record("iterated", ValueOf(NumberOf(robot->GetRootEntity().GetId()), tick, 5));
    });
    // a robot's sensor is the next to record this
    if (world.GetSpace().GetSimulationClock() > 1) {
      Metrics().Record("value", 1.0 / 3.0);
    }
  };
  TRun run = {Snapshot(Metrics())};
  for (UInt32 tick = 0; tick < kTicks; ++tick) {
    world.Step();
    run.push_back(Snapshot(Metrics()));
  }
  return run;
}

SExperiment RecordersOn(UInt32 threads, const std::string& method) {
  SExperiment experiment = Recorders();
  experiment.Threads = threads;
  experiment.Method = method;
  return experiment;
}

// otherwise so little work would be done by one thread
void UseShortRuns(CSimulator& simulator) {
  simulator.AddOverride("framework/system/@grain", "8");
}

void EnableBuiltIns(CTestWorld& world) {
  for (const char* const name :
       {"dispersion", "collisions", "real_time_factor", "speedup", "resident_memory"}) {
    world.GetSimulator().GetMetrics().EnableBuiltIn(name);
  }
}

TRun RunTwice(CTestWorld& world) {
  EnableBuiltIns(world);
  TRun run = Run(world);
  world.GetSimulator().Reset();
  for (std::vector<std::string>& tick : Run(world)) {
    run.push_back(std::move(tick));
  }
  return run;
}

const TRun& Reference() {
  static const TRun reference = [] {
    CTestWorld world(Recorders());
    return RunTwice(world);
  }();
  return reference;
}

}  // namespace

TEST_CASE("metrics: equal to the bit for any number of threads and schedule",
          "[determinism][metrics]") {
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({0U, 1U, 4U, 15U})));
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  CTestWorld world(RecordersOn(threads, method), UseShortRuns);
  const TRun& reference = Reference();
  threadsOfRobots.clear();
  areThreadsNoted = true;
  const TRun run = RunTwice(world);
  areThreadsNoted = false;
  CHECK(run == reference);
  if (method == "balance_quantity") {
    // 25 runs of robots: not every one of 15 threads has some
    CHECK(threadsOfRobots.size() > threads / 2);
  }
}

TEST_CASE("metrics: a sum is that over the robots in their order", "[determinism][metrics]") {
  SExperiment experiment = Recorders();
  experiment.Threads = 4;
  CTestWorld world(experiment);
  Run(world);
  const CMetrics& metrics = world.GetSimulator().GetMetrics();
  // PreStep(), then of each robot the sensor and two calls of the controller
  Real sum = 1.0 / 3.0;
  Real reversed = 1.0 / 3.0;
  for (UInt32 robot = 0; robot < kRobots; ++robot) {
    for (UInt32 call = 0; call < 3; ++call) {
      sum += ValueOf(robot, kTicks, call);
      reversed += ValueOf(kRobots - 1 - robot, kTicks, call);
    }
  }
  CHECK(sum != reversed);
  const CMetrics::SMetric& value = *metrics.Find("value");
  CHECK(value.Sum == sum);
  CHECK(value.Count == 3 * kRobots + 1);
  CHECK(value.Value == sum / (3.0 * kRobots + 1.0));
  CHECK(value.Last == ValueOf(kRobots - 1, kTicks, 2));
  CHECK(value.Min < -1e5);
  CHECK(value.Max > 1e5);
  CHECK(value.Unit == "m");
  // kept since the tick in which it was recorded
  CHECK(metrics.Find("late_a")->Tick == kLateTick);
  CHECK(metrics.Find("late_a")->Count == kRobots / 5);
  // in the order of the robots that recorded them first: (3 n + 2) mod 5
  std::vector<std::string> names;
  for (const CMetrics::SMetric& metric : metrics.GetAll()) {
    names.push_back(metric.Name);
  }
  CHECK(names == std::vector<std::string>{"iterated", "value", "some_of_the_robots", "late_c",
                                          "late_a", "late_d", "late_b", "late_e"});
}

TEST_CASE("metrics: what controllers record when they are reset belongs to tick 0",
          "[determinism][metrics]") {
  CTestWorld world(Recorders());
  world.Step();
  CHECK(world.GetSimulator().GetMetrics().Find("resets") == nullptr);
  world.GetSimulator().Reset();
  const CMetrics::SMetric* const resets = world.GetSimulator().GetMetrics().Find("resets");
  REQUIRE(resets != nullptr);
  CHECK(resets->Count == kRobots);
  CHECK(resets->Sum == kRobots * (kRobots - 1) / 2.0);
  CHECK(resets->Tick == 0);
  CHECK(std::isnan(world.GetSimulator().GetMetrics().Find("value")->Value));
}

TEST_CASE("metrics: a settled tick with metrics allocates nothing",
          "[determinism][metrics][allocation]") {
  const UInt32 threads = GENERATE(0U, 2U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  CTestWorld world(RecordersOn(threads, method), UseShortRuns);
  EnableBuiltIns(world);
  world.Step(20);
  CheckAllocatesNothing([&] { world.Step(50); });
  CHECK(world.GetSimulator().GetMetrics().Find("value")->Count == 3 * kRobots);
}

TEST_CASE("metrics: a value that is no number is an error of the robot", "[determinism][metrics]") {
  SExperiment experiment = Recorders("nan");
  experiment.Threads = GENERATE(0U, 4U);
  CTestWorld world(experiment);
  CHECK_THROWS_WITH(world.Step(), Contains("robot \"r3\": ControlStep() threw in tick 1") &&
                                      Contains("the metric \"value\" must be a finite number") &&
                                      Contains("nan"));
}

TEST_CASE("metrics: robots that disagree about the unit of a new metric fail in their order",
          "[determinism][metrics]") {
  const UInt32 threads = GENERATE(0U, 4U);
  CAPTURE(threads);
  SExperiment experiment = Recorders("units");
  experiment.Threads = threads;
  CTestWorld world(experiment);
  CHECK_THROWS_WITH(world.Step(), Contains("robot \"r5\": ControlStep() threw in tick 1") &&
                                      Contains("has the unit \"m\", found \"cm\""));

  SExperiment lenient = Recorders("units", "stop_robot");
  lenient.Threads = threads;
  CTestWorld goesOn(lenient);
  TakeLogErr();
  goesOn.Step(2);
  CHECK_THAT(TakeLogErr(), Contains("robot \"r5\"") && Contains("has the unit \"m\""));
  const CRobotFailures& failures = goesOn.GetSimulator().GetRobotFailures();
  REQUIRE(failures.GetErrors().size() == 1);
  CHECK(failures.GetErrors()[0].Robots == std::vector<std::string>{"r5", "r7"});
  CHECK(failures.GetErrors()[0].Count == 2);
  const CMetrics::SMetric& value = *goesOn.GetSimulator().GetMetrics().Find("value");
  CHECK(value.Count == kRobots - 2);
  CHECK(value.Sum == kRobots * (kRobots - 1) / 2.0 - 12.0);
}

TEST_CASE("metrics: robots cannot set metrics", "[determinism][metrics]") {
  CTestWorld world(Recorders("set"));
  CHECK_THROWS_WITH(world.Step(), Contains("ControlStep() in tick 1: CMetrics::Set() "
                                           "must not be called while robots") &&
                                      Contains("CMetrics::Record()"));
}

}  // namespace determinism_metrics_test
