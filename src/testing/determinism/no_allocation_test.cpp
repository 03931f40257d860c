#include <argos3/testing/determinism/swarm.h>
#include <argos3/testing/support/allocation_count.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/rooms.h>

#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

using namespace argos;

namespace {

constexpr UInt32 kWarmUpTicks = 200;
constexpr UInt32 kCountedTicks = 100;

void CheckSettledTicks(const std::string& xml, UInt32 warmUpTicks) {
  if (!CAllocationCount::IsAvailable()) {
    WARN("skipped: allocations cannot be counted with this C library");
    return;
  }
  CTestWorld world(xml);
  world.Step(warmUpTicks);
  size_t counted = 0;
  std::string first;
  {
    const CAllocationCount count;
    world.Step(kCountedTicks);
    counted = count.GetCount();
    first = count.DescribeFirst();
  }
  INFO("the first allocation was made by\n" << first);
  CHECK(counted == 0);
}

}  // namespace

TEST_CASE("no allocation: a settled tick of the benchmark allocates nothing",
          "[determinism][allocation]") {
  const UInt32 threads = GENERATE(0U, 2U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  CDynamicLoading::LoadLibrary(InBuildTree("experiments/libepuck_diffusion"));
  testing::SRoomsWorld rooms;
  rooms.Robots = 1000;
  rooms.Side = testing::SRoomsWorld::SideAtSameDensity(rooms.Robots);
  rooms.Threads = threads;
  rooms.Method = method;
  CheckSettledTicks(rooms.ToXML(), kWarmUpTicks);
}

TEST_CASE("no allocation: neither does one of noisy robots that push things",
          "[determinism][allocation]") {
  const UInt32 threads = GENERATE(0U, 2U);
  CAPTURE(threads);
  SExperiment experiment = Swarm(200, 1, false);
  experiment.Threads = threads;
  CheckSettledTicks(experiment.ToXml(), 500);
}
