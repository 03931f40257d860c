#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/entity/controllable_entity.h>
#include <argos3/core/simulator/entity/embodied_entity.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/testing/determinism/swarm.h>
#include <argos3/testing/support/experiment.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/rooms.h>
#include <argos3/testing/support/sanitizers.h>

#include <argos3/core/utility/plugins/dynamic_loading.h>
#include <argos3/testing/support/paths.h>

#include <catch2/catch.hpp>

namespace no_allocation_test {

using namespace argos;

namespace {

constexpr UInt32 kWarmUpTicks = 200;
constexpr UInt32 kCountedTicks = 100;

// the engine that contains each robot's body
std::vector<const CPhysicsEngine*> ListEngines(CTestWorld& world) {
  std::vector<const CPhysicsEngine*> engines;
  for (CControllableEntity* robot : world.GetSpace().GetControllableEntities()) {
    auto& root = dynamic_cast<CComposableEntity&>(robot->GetRootEntity());
    engines.push_back(&root.GetComponent<CEmbodiedEntity>("body").GetPhysicsModel(0).GetEngine());
  }
  return engines;
}

// noisy robots that push objects, with and without threads in each of two types of engines
SExperiment AnySwarm(UInt32 enginesPerSide) {
  const UInt32 threads = GENERATE(0U, 2U);
  const std::string engine = GENERATE("dynamics2d", "kinematics2d");
  SExperiment experiment = Swarm(200, enginesPerSide, false, engine);
  experiment.Threads = threads;
  return experiment;
}

}  // namespace

TEST_CASE("no allocation: a tick of the benchmark in steady state allocates nothing",
          "[determinism][allocation]") {
  const UInt32 threads = GENERATE(0U, 2U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  const std::string engine = GENERATE("dynamics2d", "kinematics2d");
  CAPTURE(threads, method, engine);
  CDynamicLoading::LoadLibrary(InBuildTree("experiments/libepuck_diffusion"));
  testing::SRoomsWorld rooms;
  rooms.Robots = 1000;
  rooms.Side = testing::SRoomsWorld::SideAtSameDensity(rooms.Robots);
  rooms.Threads = threads;
  rooms.Method = method;
  rooms.Engine = engine;
  CTestWorld world(rooms.ToXML());
  CheckSettledTicks(world, kWarmUpTicks, kCountedTicks);
}

TEST_CASE("no allocation: a tick of noisy robots that push objects allocates nothing",
          "[determinism][allocation]") {
  const SExperiment experiment = AnySwarm(1);
  CAPTURE(experiment.Threads, experiment.Engines);
  CTestWorld world(experiment);
  CheckSettledTicks(world, 500, kCountedTicks);
}

TEST_CASE("no allocation: ticks with robots that cross between engines allocate nothing",
          "[determinism][allocation]") {
  // dense enough for contacts, so that robots with and without them cross borders, and crates too
  const SExperiment experiment = AnySwarm(2);
  CAPTURE(experiment.Threads, experiment.Engines);
  CTestWorld world(experiment);
  world.Step(FewerIfSanitized(500));
  size_t crossings = 0;
  for (UInt32 part = 0; part < FewerIfSanitized(50); ++part) {
    const auto before = ListEngines(world);
    CheckSettledTicks(world, 0, 10);
    const auto after = ListEngines(world);
    for (size_t i = 0; i < before.size(); ++i) {
      crossings += before[i] != after[i] ? 1 : 0;
    }
  }
  // several per engine; the few ticks with sanitizers begin before the robots have mixed
  CHECK(crossings > (kHasAddressSanitizer || kHasThreadSanitizer ? 0 : 40));
}

TEST_CASE("no allocation: a tick of moving robots with LEDs in a medium allocates nothing",
          "[determinism][allocation]") {
  const std::string index = GENERATE("grid", "hash");
  CAPTURE(index);
  // 1,000 foot-bots that change their colours, and a few obstacles
  SExperiment experiment = Swarm(1000, 1, true);
  experiment.Controllers.erase(experiment.Controllers.find("<walker id='e-puck'>"));
  std::string& arena = experiment.Arena;
  for (size_t at = arena.find("<e-puck id='ep'>"); at != std::string::npos;
       at = arena.find("<e-puck id='ep'>")) {
    const size_t end = arena.find("</e-puck>", at) + 9;
    arena.replace(at, end - at, "<foot-bot id='fc'> <controller config='foot-bot' /> </foot-bot>");
  }
  experiment.Media = "<led id='leds' index='" + index + "' />";
  CTestWorld world(experiment);
  REQUIRE(world.GetSpace().GetEntitiesByType("foot-bot").size() == 1000);
  CheckSettledTicks(world, kWarmUpTicks, 0);
  // all robots move during the counted ticks, and some LEDs are lit
  const auto places = [&world] {
    std::vector<CVector3> positions;
    for (const auto& [id, robot] : world.GetSpace().GetEntitiesByType("foot-bot")) {
      const SAnchor& origin =
          any_cast<CFootBotEntity*>(robot)->GetEmbodiedEntity().GetOriginAnchor();
      positions.push_back(origin.Position);
    }
    return positions;
  };
  const auto before = places();
  CheckSettledTicks(world, 0, kCountedTicks);
  const auto after = places();
  size_t moved = 0;
  for (size_t i = 0; i < before.size(); ++i) {
    moved += Distance(before[i], after[i]) > 0.01 ? 1 : 0;
  }
  CHECK(moved > 900);
}

}  // namespace no_allocation_test
