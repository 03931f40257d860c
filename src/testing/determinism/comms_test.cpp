// Communicating robots: results are equal for any number of threads, and ticks in
// steady state allocate nothing.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/determinism/comms_swarm.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <set>
#include <vector>

namespace comms_test {

using namespace argos;

namespace {

constexpr UInt32 kRobots = 200;
constexpr UInt32 kTicks = 40;

// computed once, by the main thread alone
const std::vector<UInt64>& Reference() {
  static const std::vector<UInt64> reference = [] {
    CTestWorld world(CommsSwarm(kRobots));
    return RecordDigests(world, kTicks);
  }();
  return reference;
}

}  // namespace

TEST_CASE("comms determinism: every tick is equal bit by bit for any number of threads",
          "[determinism][threads]") {
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({1U, 2U, 4U})));
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  SExperiment experiment = CommsSwarm(kRobots);
  experiment.Threads = threads;
  experiment.Method = method;
  CTestWorld world(experiment);
  CHECK(RecordDigests(world, kTicks) == Reference());
}

TEST_CASE("comms determinism: every tick is equal for every index of the media", "[determinism]") {
  const std::string index = GENERATE("index='hash'", "grid_size='3,50,1'");
  CAPTURE(index);
  CTestWorld world(CommsSwarm(kRobots, true, index));
  CHECK(RecordDigests(world, kTicks) == Reference());
}

TEST_CASE("comms determinism: after a reset the run repeats", "[determinism]") {
  CTestWorld world(CommsSwarm(kRobots));
  world.Step(17);
  world.GetSimulator().Reset();
  CHECK(RecordDigests(world, kTicks) == Reference());
}

TEST_CASE("comms determinism: the compared runs change in every tick, and with the noise",
          "[determinism]") {
  CHECK(std::set<UInt64>(Reference().begin(), Reference().end()).size() == Reference().size());
  // readings affect the motion: without noise robots take other paths
  CTestWorld quiet(CommsSwarm(kRobots, false));
  CHECK(RecordDigests(quiet, kTicks) != Reference());
}

TEST_CASE("no allocation: a tick of communicating robots in steady state allocates nothing",
          "[determinism][allocation]") {
  WarnUnlessAllocationsAreCounted();
  const UInt32 threads = GENERATE(0U, 2U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  SExperiment experiment = CommsSwarm(200, true, "", false);
  experiment.Threads = threads;
  experiment.Method = method;
  // an engine without motion: the test moves the robots
  experiment.Engines = "<toy_engine id='engine'/>";
  CTestWorld world(experiment);
  const CSimulator::CScope scope(world.GetSimulator());
  size_t counted = 0;
  std::string first;
  // A robot that receives more packets than ever before enlarges its list,
  // so each place is visited twice.
  for (const bool isSettled : {false, true}) {
    world.GetSimulator().Reset();
    CRandomStream random(1, "test", "comms", "places");
    for (int tick = 0; tick < 20; ++tick) {
      for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
        auto& body = dynamic_cast<CComposableEntity&>(robot->GetRootEntity())
                         .GetComponent<CEmbodiedEntity>("body");
        body.MoveTo(CVector3(random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0), 0.0),
                    CQuaternion(), false, true);
      }
      if (!isSettled) {
        world.Step();
        continue;
      }
      const CAllocationCount count;
      world.Step();
      counted += count.GetCount();
      first = first.empty() ? count.DescribeFirst() : first;
    }
  }
  INFO("the first allocation was made by\n" << first);
  CHECK(counted == 0);
}

}  // namespace comms_test
