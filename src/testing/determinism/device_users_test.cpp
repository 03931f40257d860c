// Foot-bots, e-pucks and eye-bots with every device that they support, all in use: readings
// determine their actions.

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/testing/support/device_user.h>
#include <argos3/testing/support/device_world.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <map>
#include <set>

namespace device_users_test {

using namespace argos;

namespace {

constexpr UInt32 kRobots = 150;  // more than two runs of robots that a thread processes
constexpr UInt32 kTicks = FewerIfSanitized(60);

SExperiment Experiment(bool noisy = true) {
  SDeviceWorld world;
  world.Robots = kRobots;
  world.IsNoisy = noisy;
  return world.ToExperiment();
}

CDeviceUser& UserOf(CControllableEntity& robot) {
  return dynamic_cast<CDeviceUser&>(robot.GetController());
}

// digests of the world after each tick, followed by the digest of each robot's readings
std::vector<UInt64> Run(CTestWorld& world) {
  std::vector<UInt64> digests = RecordDigests(world, kTicks);
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    digests.push_back(UserOf(*robot).GetReadingsDigest());
  }
  return digests;
}

const std::vector<UInt64>& Reference() {
  static const std::vector<UInt64> reference = [] {
    CTestWorld world(Experiment());
    return Run(world);
  }();
  return reference;
}

}  // namespace

TEST_CASE("all devices: every tick is equal for any number of threads and schedule",
          "[determinism][threads][devices]") {
  const UInt32 threads = GENERATE(from_range(MostIfSanitized({0U, 1U, 2U, 4U})));
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  SExperiment experiment = Experiment();
  experiment.Threads = threads;
  experiment.Method = method;
  CTestWorld world(experiment);
  // also if the previous run was interrupted
  world.Step(13);
  world.GetSimulator().Reset();
  CHECK(Run(world) == Reference());
  world.GetSimulator().Reset();
  CHECK(Run(world) == Reference());
}

TEST_CASE("all devices: the compared runs change in every tick, and with the noise",
          "[determinism][devices]") {
  const std::vector<UInt64>& reference = Reference();
  CHECK(std::set<UInt64>(reference.begin(), reference.end()).size() == reference.size());
  // noise changes the readings of the first tick, and the actions from the next tick on
  CTestWorld quiet(Experiment(false));
  const std::vector<UInt64> digests = Run(quiet);
  CHECK(digests.front() == reference.front());
  CHECK(digests[2] != reference[2]);
  CHECK(digests.back() != reference.back());

  // robots of each type had readings of variable length, and something was gripped
  CTestWorld world(Experiment());
  std::map<std::string, size_t> seen;
  size_t held = 0;
  for (UInt32 tick = 0; tick < kTicks; ++tick) {
    world.Step();
    for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
      seen[robot->GetRootEntity().GetTypeDescription()] += UserOf(*robot).CountSeen();
      if (auto* footBot = dynamic_cast<CFootBotEntity*>(&robot->GetRootEntity())) {
        held += footBot->GetGripperEquippedEntity().IsGripping() ? 1 : 0;
      }
    }
  }
  for (const char* type : {"foot-bot", "e-puck", "eye-bot"}) {
    CAPTURE(type);
    CHECK(seen[type] > 3 * kRobots / 3 * kTicks);
  }
  CHECK(held > kTicks);
}

TEST_CASE("all devices: a repeated run allocates nothing", "[determinism][allocation][devices]") {
  const UInt32 threads = GENERATE(0U, 2U);
  const bool noisy = GENERATE(true, false);
  CAPTURE(threads, noisy);
  SDeviceWorld devices;
  devices.IsNoisy = noisy;
  // the bytes of a message are allocated by the controller
  devices.Parameters = "radio_bytes='0'";
  SExperiment experiment = devices.ToExperiment();
  experiment.Threads = threads;
  CTestWorld world(experiment);
  // Lists keep their largest size. The run is repeated, so that they have reached it.
  world.Step(FewerIfSanitized(150));
  world.GetSimulator().Reset();
  CheckSettledTicks(world, 50, 100);
}

}  // namespace device_users_test
