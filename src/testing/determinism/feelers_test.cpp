// Robots with all sensors of a foot-bot: readings determine their actions.

#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/testing/determinism/feelers.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <vector>

namespace feelers_test {

using namespace argos;

namespace {

constexpr UInt32 kRobots = 130;  // more than two runs of robots that a thread processes
constexpr UInt32 kTicks = 40;

// digests of the world after each tick, followed by the digest of each robot's readings
std::vector<UInt64> Run(CTestWorld& world) {
  std::vector<UInt64> digests = RecordDigests(world, kTicks);
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    digests.push_back(dynamic_cast<CFeeler&>(robot->GetController()).GetReadingsDigest());
  }
  return digests;
}

const std::vector<UInt64>& Reference() {
  static const std::vector<UInt64> reference = [] {
    CTestWorld world(Feelers(kRobots, true));
    return Run(world);
  }();
  return reference;
}

}  // namespace

TEST_CASE("feelers: every tick is equal for any number of threads and schedule",
          "[determinism][sensors]") {
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({1U, 4U})));
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  SExperiment experiment = Feelers(kRobots, true);
  experiment.Threads = threads;
  experiment.Method = method;
  CTestWorld world(experiment);
  CHECK(Run(world) == Reference());
  world.GetSimulator().Reset();
  CHECK(Run(world) == Reference());
}

TEST_CASE("feelers: readings affect the run and differ between robots", "[determinism][sensors]") {
  CTestWorld world(Feelers(kRobots, false));
  const std::vector<UInt64> digests = Run(world);
  CHECK(digests.front() == Reference().front());
  CHECK(digests[kTicks] != Reference()[kTicks]);
  CHECK(digests[kTicks + 1] != digests[kTicks + 2]);
}

TEST_CASE("feelers: a tick in steady state allocates nothing",
          "[determinism][sensors][allocation]") {
  const UInt32 threads = GENERATE(0U, 2U);
  const bool noisy = GENERATE(true, false);
  CAPTURE(threads, noisy);
  SExperiment experiment = Feelers(60, noisy);
  experiment.Threads = threads;
  CTestWorld world(experiment);
  CheckSettledTicks(world, 200, 100);
}

}  // namespace feelers_test
