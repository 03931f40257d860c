#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/testing/determinism/swarm.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/paths.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <map>
#include <set>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

namespace swarm_test {

using namespace argos;

namespace {

struct SSize {
  UInt32 Robots;
  UInt32 EnginesPerSide;
  UInt32 Ticks;
  std::string Engine = "dynamics2d";
};

constexpr UInt32 kManyTicks = FewerIfSanitized(200);
constexpr UInt32 kFewTicks = FewerIfSanitized(50);
// ten robots for a long time, a thousand for a short time, and both in four engines
const std::vector<SSize> kSizes = {{10, 1, kManyTicks},
                                   {1000, 1, kFewTicks},
                                   {10, 2, kManyTicks},
                                   {1000, 2, kFewTicks},
                                   {10, 1, kManyTicks, "kinematics2d"},
                                   {1000, 1, kFewTicks, "kinematics2d"},
                                   {1000, 2, kFewTicks, "kinematics2d"}};

// computed once for each size, by the main thread alone
const std::vector<UInt64>& Reference(const SSize& size) {
  static std::map<std::tuple<UInt32, UInt32, std::string>, std::vector<UInt64>> references;
  std::vector<UInt64>& reference = references[{size.Robots, size.EnginesPerSide, size.Engine}];
  if (reference.empty()) {
    CTestWorld world(Swarm(size.Robots, size.EnginesPerSide, true, size.Engine));
    reference = RecordDigests(world, size.Ticks);
  }
  return reference;
}

// the first tick in which two runs differ; the number of digests if they are equal
size_t FirstDifference(const std::vector<UInt64>& a, const std::vector<UInt64>& b) {
  REQUIRE(a.size() == b.size());
  size_t tick = 0;
  while (tick < a.size() && a[tick] == b[tick]) {
    ++tick;
  }
  return tick;
}

void CheckSame(const std::vector<UInt64>& digests, const SSize& size) {
  CHECK(FirstDifference(digests, Reference(size)) == digests.size());
}

}  // namespace

TEST_CASE("determinism: every tick is equal bit by bit for any number of threads and schedule",
          "[determinism][threads]") {
  const SSize size = GENERATE(from_range(kSizes));
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({0U, 1U, 2U, 4U, 15U})));
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(size.Engine, size.Robots, size.EnginesPerSide, threads, method);
  SExperiment experiment = Swarm(size.Robots, size.EnginesPerSide, true, size.Engine);
  experiment.Threads = threads;
  experiment.Method = method;
  CTestWorld world(experiment);
  CheckSame(RecordDigests(world, size.Ticks), size);
}

TEST_CASE("determinism: after a reset the run repeats", "[determinism]") {
  const SSize size = GENERATE(from_range(kSizes));
  const UInt32 threads = GENERATE(0U, 4U);
  CAPTURE(size.Engine, size.Robots, size.EnginesPerSide, threads);
  SExperiment experiment = Swarm(size.Robots, size.EnginesPerSide, true, size.Engine);
  experiment.Threads = threads;
  CTestWorld world(experiment);
  // also if the previous run was interrupted, and a second time
  world.Step(size.Ticks / 3);
  world.GetSimulator().Reset();
  CheckSame(RecordDigests(world, size.Ticks), size);
  world.GetSimulator().Reset();
  CheckSame(RecordDigests(world, size.Ticks), size);
}

TEST_CASE("determinism: the compared runs change in every tick, and with the seed",
          "[determinism]") {
  for (const SSize& size : kSizes) {
    CAPTURE(size.Engine, size.Robots, size.EnginesPerSide);
    // the digest changes in every tick
    const std::vector<UInt64>& reference = Reference(size);
    CHECK(std::set<UInt64>(reference.begin(), reference.end()).size() == reference.size());
    // with another seed every digest differs
    SExperiment experiment = Swarm(size.Robots, size.EnginesPerSide, true, size.Engine);
    experiment.Seed = 2;
    CTestWorld world(experiment);
    CHECK(world.ComputeDigest() != reference.front());
  }
  // robots cross between engines
  CTestWorld world(Swarm(1000, 2));
  const auto engines = [&] {
    std::vector<const CPhysicsEngine*> found;
    for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
      auto& root = dynamic_cast<CComposableEntity&>(robot->GetRootEntity());
      found.push_back(&root.GetComponent<CEmbodiedEntity>("body").GetPhysicsModel(0).GetEngine());
    }
    return found;
  };
  const auto before = engines();
  world.Step(50);
  const auto after = engines();
  int crossed = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    crossed += before[i] != after[i] ? 1 : 0;
  }
  CHECK(crossed >= 5);
  CHECK(std::set<const CPhysicsEngine*>(after.begin(), after.end()).size() == 4);
}

TEST_CASE("determinism: queries do not change the run", "[determinism]") {
  const SSize size = kSizes[0];
  CTestWorld world(Swarm(size.Robots, size.EnginesPerSide, true, size.Engine));
  std::vector<UInt64> digests = {world.ComputeDigest()};
  for (UInt32 tick = 0; tick < size.Ticks; ++tick) {
    world.Step();
    // creates the lists for users and the LED entities
    REQUIRE(world.GetSpace().GetEntitiesByType("led").size() >= 5 * 13 + 5 * 8);
    REQUIRE(world.GetSpace().GetNumberEntities() > 100);
    digests.push_back(world.ComputeDigest());
  }
  CheckSame(digests, size);
}

TEST_CASE("determinism: simulators that run concurrently do not affect each other",
          "[determinism][threads]") {
  const SSize size = kSizes[0];
  Reference(size);
  std::vector<std::vector<UInt64>> digests(4);
  std::vector<std::thread> threads;
  for (size_t i = 0; i < digests.size(); ++i) {
    threads.emplace_back([&, i] {
      SExperiment experiment = Swarm(size.Robots, size.EnginesPerSide, true, size.Engine);
      experiment.Threads = static_cast<UInt32>(i);
      // all of them load a library, although only one can be the first
      experiment.Controllers += "<epuck_diffusion_controller id='unused' library='" +
                                InBuildTree("experiments/libepuck_diffusion") + "' />";
      CTestWorld world(experiment);
      digests[i] = RecordDigests(world, size.Ticks);
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (const std::vector<UInt64>& run : digests) {
    CheckSame(run, size);
  }
}

}  // namespace swarm_test
