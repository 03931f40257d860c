// Allocations that fail at any place of loading, running and resetting: an error that says so, and
// the process can load the experiment again.

#include "failing_allocation.h"
#include "fault_experiment.h"

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <functional>
#include <memory>
#include <optional>

namespace allocation_test {

using namespace argos;
using Catch::Contains;

namespace {

// places in each range that are tried
constexpr size_t kTrials = 150;
constexpr UInt32 kTicks = 3;

std::string Experiment(const std::string& engine) {
  SFaultExperiment experiment;
  experiment.Engine = "<" + engine + " id='engine'/>";
  experiment.Sensors =
      "<epuck_proximity implementation='default'/>"
      "<range_and_bearing implementation='medium' medium='rab'/>";
  experiment.Actuators = "<leds implementation='default' medium='leds'/>";
  experiment.Media = "<led id='leds'/><range_and_bearing id='rab'/>";
  experiment.Entities =
      "<box id='wall' size='1,0.1,0.5' movable='false'><body position='5,5,0'/></box>"
      "<light id='lamp' position='1,1,1' orientation='0,0,0' color='yellow' intensity='1' "
      "medium='leds'/>";
  return experiment.ToXml();
}

UInt64 DigestOfRun(const std::string& xml) {
  CTestWorld world(xml);
  world.Step(kTicks);
  return world.ComputeDigest();
}

// calls a step with allocations that fail; its exception, if there is one, must say why
// @return the number of allocations
size_t TryStep(size_t first, size_t number, const std::function<void()>& step) {
  // not in the catch block: checking allocates
  std::optional<std::string> error;
  size_t count = 0;
  {
    const CFailingAllocation failing(first, number);
    try {
      step();
    } catch (const std::bad_alloc&) {
      // without a text there was no memory for a text
    } catch (const std::exception& exception) {
      const CFailingAllocation noMore(0, 0);
      error = exception.what();
    }
    count = failing.GetCount();
  }
  if (error) {
    // streams of the standard library turn a lack of memory into a malformed text
    CHECK_THAT(*error, Contains("memory") || Contains("expected"));
  }
  return count;
}

}  // namespace

TEST_CASE("memory: an allocation that fails at the n-th call while loading, running or resetting",
          "[faults][memory]") {
  const std::string engine = GENERATE("dynamics2d", "kinematics2d", "dynamics3d", "pointmass3d");
  // one call, or all calls of some time
  const size_t number = GENERATE(1, 30);
  CAPTURE(engine, number);
  const std::string xml = Experiment(engine);
  const UInt64 digest = DigestOfRun(xml);
  TakeLogErr();

  // @param prepare  what precedes the step. @param step  in which allocations fail
  const auto tryEverywhere = [&](const std::string& what, auto&& prepare, auto&& step) {
    CAPTURE(what);
    const size_t none = ~size_t(0) / 2;
    auto first = prepare();
    const size_t count = TryStep(none, 0, [&] { step(first); });
    first.reset();
    const size_t stride = std::max<size_t>(1, count / kTrials);
    for (size_t n = 0; n < count; n += stride) {
      CAPTURE(n, count);
      auto world = prepare();
      TryStep(n, number, [&] { step(world); });
      world.reset();
    }
    TakeLogErr();
    TakeLog();
    CHECK(DigestOfRun(xml) == digest);
  };
  using TWorld = std::unique_ptr<CTestWorld>;
  tryEverywhere(
      "loading", [] { return TWorld(); },
      [&xml](TWorld& world) { world = std::make_unique<CTestWorld>(xml); });
  tryEverywhere(
      "running", [&xml] { return std::make_unique<CTestWorld>(xml); },
      [](TWorld& world) { world->Step(kTicks); });
  tryEverywhere(
      "resetting",
      [&xml] {
        auto world = std::make_unique<CTestWorld>(xml);
        world->Step(kTicks);
        return world;
      },
      [](TWorld& world) { world->GetSimulator().Reset(); });
}

}  // namespace allocation_test
