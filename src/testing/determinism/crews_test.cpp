// Gripping robots and flying robots: readings determine their actions.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/testing/determinism/crews.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <vector>

namespace crews_test {

using namespace argos;

namespace {

constexpr UInt32 kTicks = 100;

SExperiment Crew(bool flies, bool noisy) {
  // more robots than a thread processes in a run
  return flies ? Flyers(70, noisy) : Holders(35, noisy);
}

// digests of the world after each tick, followed by the digest of each robot's readings
std::vector<UInt64> Run(CTestWorld& world) {
  std::vector<UInt64> digests = RecordDigests(world, kTicks);
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    digests.push_back(dynamic_cast<CRecorder&>(robot->GetController()).GetRead());
  }
  return digests;
}

const std::vector<UInt64>& Reference(bool flies) {
  static const std::vector<UInt64> holders = [] {
    CTestWorld world(Crew(false, true));
    return Run(world);
  }();
  static const std::vector<UInt64> flyers = [] {
    CTestWorld world(Crew(true, true));
    return Run(world);
  }();
  return flies ? flyers : holders;
}

}  // namespace

TEST_CASE("crews: every tick is equal for any number of threads, also after a reset",
          "[determinism][sensors]") {
  const bool flies = GENERATE(false, true);
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({0U, 1U, 4U})));
  CAPTURE(flies, threads);
  SExperiment experiment = Crew(flies, true);
  experiment.Threads = threads;
  CTestWorld world(experiment);
  CHECK(Run(world) == Reference(flies));
  world.GetSimulator().Reset();
  CHECK(Run(world) == Reference(flies));
}

TEST_CASE("crews: readings affect the run and differ between robots", "[determinism][sensors]") {
  const bool flies = GENERATE(false, true);
  CAPTURE(flies);
  CTestWorld world(Crew(flies, false));
  const std::vector<UInt64> digests = Run(world);
  CHECK(digests.front() == Reference(flies).front());
  CHECK(digests[kTicks] != Reference(flies)[kTicks]);
  CHECK(Reference(flies)[kTicks + 1] != Reference(flies)[kTicks + 2]);
}

TEST_CASE("crews: loads are gripped and released", "[determinism][sensors]") {
  CTestWorld world(Holders(35, true));
  size_t held = 0;
  size_t changes = 0;
  std::vector<bool> before;
  for (UInt32 tick = 0; tick < kTicks; ++tick) {
    world.Step();
    std::vector<bool> now;
    for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
      auto& root = dynamic_cast<CComposableEntity&>(robot->GetRootEntity());
      now.push_back(root.GetComponent<CGripperEquippedEntity>("gripper").IsGripping());
      held += now.back() ? 1 : 0;
      changes += !before.empty() && before[now.size() - 1] != now.back() ? 1 : 0;
    }
    before = now;
  }
  // the 70 robots hold something a third of the time, and each grips and releases at least once
  CHECK(held > 70 * kTicks / 3);
  CHECK(changes > 60 * 2);
}

TEST_CASE("crews: a tick in steady state allocates nothing", "[determinism][sensors][allocation]") {
  const bool flies = GENERATE(false, true);
  const UInt32 threads = GENERATE(0U, 2U);
  const bool noisy = GENERATE(true, false);
  CAPTURE(flies, threads, noisy);
  SExperiment experiment = flies ? Flyers(30, noisy) : Holders(15, noisy);
  experiment.Threads = threads;
  CTestWorld world(experiment);
  CheckSettledTicks(world, 300, 100);
}

}  // namespace crews_test
