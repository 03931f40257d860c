// How robots are dealt to threads: no effect on results and on the error that is reported.

#include <argos3/core/control_interface/ci_controller.h>
#include <argos3/core/simulator/sensor.h>
#include <argos3/core/simulator/simulator.h>
#include <argos3/testing/determinism/swarm.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <memory>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace grain_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

std::string WithGrain(const SExperiment& experiment, const std::string& grain) {
  std::string xml = experiment.ToXml();
  const std::string tag = "<system ";
  REQUIRE(xml.find(tag) != std::string::npos);
  return xml.replace(xml.find(tag), tag.size(), tag + "grain=\"" + grain + "\" ");
}

std::string ToyRobot(const std::string& id, Real y, const std::string& controller = "c") {
  return "<toy-robot id='" + id + "'><body position='0," + std::to_string(y) +
         ",0'/><controller config='" + controller + "'/></toy-robot>";
}

std::string LoadErrorOf(const std::string& xml) {
  try {
    CTestWorld world(xml);
  } catch (const CARGoSException& error) {
    return error.what();
  }
  return "";
}

/** Fails in its sensor ("sense") or in its step ("control"), or not. */
class CFailing : public CCI_Controller {
 public:
  void Init(TConfigurationNode& params) override {
    std::string failure;
    GetNodeAttribute(params, "in", failure);
    m_failsInControl = failure == "control";
    auto sensor = std::make_unique<SSensor>();
    sensor->Fails = failure == "sense";
    AddSensor("failing", sensor.release());
  }
  void ControlStep() override {
    if (m_failsInControl) {
      THROW_ARGOSEXCEPTION("as intended");
    }
  }

 private:
  struct SSensor : CSimulatedSensor, CCI_Sensor {
    void SetRobot(CComposableEntity&) override {}
    void Update() override {
      if (Fails) {
        THROW_ARGOSEXCEPTION("as intended");
      }
    }
    bool Fails = false;
  };

  bool m_failsInControl = false;
};

REGISTER_CONTROLLER(CFailing, "failing_robot")

}  // namespace

TEST_CASE("grain: results are the same for every grain, number of threads and schedule",
          "[determinism][threads]") {
  constexpr UInt32 kTicks = 40;
  const auto run = [](SExperiment experiment, const std::string& grain, UInt32 threads,
                      const std::string& method) {
    experiment.Threads = threads;
    experiment.Method = method;
    CTestWorld world(WithGrain(experiment, grain));
    return RecordDigests(world, kTicks);
  };
  const SExperiment swarm = Swarm(60);
  const std::vector<UInt64> alone = run(swarm, "auto", 0, "balance_quantity");
  CHECK(std::set<UInt64>(alone.begin(), alone.end()).size() == kTicks + 1);
  for (const std::string grain : {"1", "7", "64", "1000", "auto"}) {
    for (const UInt32 threads : {1U, 2U, 4U}) {
      for (const std::string method : {"balance_quantity", "balance_length"}) {
        CAPTURE(grain, threads, method);
        CHECK(run(swarm, grain, threads, method) == alone);
      }
    }
  }
}

TEST_CASE("grain: robots are dealt to threads in runs of that length", "[determinism][threads]") {
  // two threads: the first one gets the larger half of the runs
  const auto [grain, ofFirst] = GENERATE(
      table<std::string, size_t>({{"1", 3}, {"2", 4}, {"4", 4}, {"5", 5}, {"6", 6}, {"64", 6}}));
  CAPTURE(grain);
  SExperiment experiment;
  experiment.Threads = 2;
  experiment.Controllers =
      "<toy_controller id='c'><actuators/><sensors/><params/></toy_controller>";
  experiment.Engines = "<toy_engine id='toy'/>";
  for (int i = 0; i < 6; ++i) {
    experiment.Arena += ToyRobot("r" + std::to_string(i), i - 3);
  }
  CTestWorld world(WithGrain(experiment, grain));
  std::vector<std::thread::id> threads(6);
  for (size_t i = 0; i < threads.size(); ++i) {
    auto& controller =
        dynamic_cast<CToyController&>(world.Get<CToyRobotEntity>("r" + std::to_string(i))
                                          .GetControllableEntity()
                                          .GetController());
    controller.OnStep = [&threads, i](CToyController&) { threads[i] = std::this_thread::get_id(); };
  }
  world.Step();
  for (size_t i = 0; i < threads.size(); ++i) {
    CAPTURE(i);
    CHECK((threads[i] == std::this_thread::get_id()) == (i < ofFirst));
  }
}

TEST_CASE("grain: of several robots that fail, the first is reported for every grain",
          "[determinism][threads][errors]") {
  const std::string grain = GENERATE("1", "2", "64", "auto");
  const UInt32 threads = GENERATE(0U, 4U);
  CAPTURE(grain, threads);
  SExperiment experiment;
  experiment.Threads = threads;
  for (const std::string failure : {"none", "sense", "control"}) {
    experiment.Controllers += "<failing_robot id='" + failure +
                              "'><actuators/><sensors/><params in='" + failure +
                              "'/></failing_robot>";
  }
  experiment.Engines = "<toy_engine id='toy'/>";
  // the phase would sense of r5 before it controls r3, if one thread had both
  const std::vector<std::string> failures = {"none", "none",  "none",    "control",
                                             "none", "sense", "control", "none"};
  for (size_t i = 0; i < failures.size(); ++i) {
    experiment.Arena += ToyRobot("r" + std::to_string(i), static_cast<Real>(i) - 4.0, failures[i]);
  }
  CTestWorld world(WithGrain(experiment, grain));
  CHECK_THROWS_WITH(world.Step(), Contains("\"r3\"") && Contains("ControlStep()"));
}

TEST_CASE("grain: an invalid value is an error with its line", "[determinism][errors]") {
  const std::string grain = GENERATE("0", "-1", "some", "1.5", "");
  CAPTURE(grain);
  SExperiment experiment;
  experiment.Threads = 2;
  CHECK_THAT(LoadErrorOf(WithGrain(experiment, grain)),
             Contains("test.argos:") && Contains("\"grain\" must be \"auto\" or a whole number") &&
                 Contains("\"" + grain + "\""));
}

}  // namespace grain_test
