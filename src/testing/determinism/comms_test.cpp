// Robots that talk: the same for every number of threads, and nothing allocated once settled.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/testing/determinism/comms_swarm.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <set>
#include <vector>

using namespace argos;

namespace {

constexpr UInt32 kRobots = 200;
constexpr UInt32 kTicks = 40;

std::vector<UInt64> Run(CTestWorld& world) {
  std::vector<UInt64> digests = {world.ComputeDigest()};
  for (UInt32 tick = 0; tick < kTicks; ++tick) {
    world.Step();
    digests.push_back(world.ComputeDigest());
  }
  return digests;
}

// computed once: the main thread does all
const std::vector<UInt64>& Reference() {
  static const std::vector<UInt64> reference = [] {
    CTestWorld world(CommsSwarm(kRobots));
    return Run(world);
  }();
  return reference;
}

}  // namespace

TEST_CASE("comms determinism: every tick is the same to the bit for every number of threads",
          "[determinism][threads]") {
  const UInt32 threads = GENERATE(1U, 2U, 4U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  SExperiment experiment = CommsSwarm(kRobots);
  experiment.Threads = threads;
  experiment.Method = method;
  CTestWorld world(experiment);
  CHECK(Run(world) == Reference());
}

TEST_CASE("comms determinism: ... and for every index of the media", "[determinism]") {
  const std::string index = GENERATE("index='hash'", "grid_size='3,50,1'");
  CAPTURE(index);
  CTestWorld world(CommsSwarm(kRobots, true, index));
  CHECK(Run(world) == Reference());
}

TEST_CASE("comms determinism: after a reset the run repeats itself", "[determinism]") {
  CTestWorld world(CommsSwarm(kRobots));
  world.Step(17);
  world.GetSimulator().Reset();
  CHECK(Run(world) == Reference());
}

TEST_CASE("comms determinism: the runs that are compared are worth it", "[determinism]") {
  CHECK(std::set<UInt64>(Reference().begin(), Reference().end()).size() == Reference().size());
  // what robots hear is what moves them: without noise they go elsewhere
  CTestWorld quiet(CommsSwarm(kRobots, false));
  CHECK(Run(quiet) != Reference());
}

TEST_CASE("no allocation: neither does a tick of robots that talk", "[determinism][allocation]") {
  WarnUnlessAllocationsAreCounted();
  const UInt32 threads = GENERATE(0U, 2U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  SExperiment experiment = CommsSwarm(200, true, "", false);
  experiment.Threads = threads;
  experiment.Method = method;
  // an engine in which nothing moves: the test puts the robots where they are to be
  experiment.Engines = "<toy_engine id='engine'/>";
  CTestWorld world(experiment);
  const CSimulator::CScope scope(world.GetSimulator());
  size_t counted = 0;
  std::string first;
  // a robot that hears more than ever before makes room for it: so every place twice
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
