// Robots with cameras: readings determine their actions.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/testing/determinism/watchers.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

namespace watchers_test {

using namespace argos;

namespace {

constexpr UInt32 kRobots = 130;  // more than two runs of robots that a thread processes
constexpr UInt32 kTicks = FewerIfSanitized(60);

const std::vector<UInt64>& Reference() {
  static const std::vector<UInt64> reference = [] {
    CTestWorld world(Watchers(kRobots, true, true));
    return RecordDigests(world, kTicks);
  }();
  return reference;
}

// sum over all robots
CWatcher::SSights CountSights(CTestWorld& world) {
  CWatcher::SSights sights;
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    const CWatcher::SSights seen = dynamic_cast<CWatcher&>(robot->GetController()).CountSights();
    sights.LEDs += seen.LEDs;
    sights.Signals += seen.Signals;
    sights.Tags += seen.Tags;
  }
  return sights;
}

}  // namespace

TEST_CASE("watchers: every tick is equal for any number of threads and schedule",
          "[determinism][cameras]") {
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({1U, 4U})));
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  SExperiment experiment = Watchers(kRobots, true, true);
  experiment.Threads = threads;
  experiment.Method = method;
  CTestWorld world(experiment);
  CHECK(RecordDigests(world, kTicks) == Reference());
  const CWatcher::SSights sights = CountSights(world);
  CHECK(sights.LEDs > kRobots * kTicks / 6);
  CHECK(sights.Signals > kRobots * kTicks / 60);
  CHECK(sights.Tags > kRobots * kTicks / 120);
  world.GetSimulator().Reset();
  CHECK(RecordDigests(world, kTicks) == Reference());
}

TEST_CASE("watchers: readings of cameras affect the run", "[determinism][cameras]") {
  // without noise the run differs from the first tick with other readings on
  CTestWorld world(Watchers(kRobots, true, false));
  const std::vector<UInt64> digests = RecordDigests(world, kTicks);
  CHECK(digests.front() == Reference().front());
  CHECK(digests.back() != Reference().back());
}

TEST_CASE("watchers: a tick in steady state allocates nothing",
          "[determinism][cameras][allocation]") {
  const UInt32 threads = GENERATE(0U, 2U);
  CAPTURE(threads);
  SExperiment experiment = Watchers(30, false, true);
  experiment.Threads = threads;
  CTestWorld world(experiment);
  // Lists keep their largest size. The run is repeated, so that they have reached it.
  world.Step(FewerIfSanitized(400));
  world.GetSimulator().Reset();
  CheckSettledTicks(world, 300, 100);
  CHECK(CountSights(world).LEDs > FewerIfSanitized(300));
  CHECK(CountSights(world).Tags > FewerIfSanitized(15));
}

}  // namespace watchers_test
