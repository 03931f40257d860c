// Adding and removing robots with all devices during the experiment.

#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>
#include <argos3/testing/determinism/population.h>
#include <argos3/testing/support/device_world.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/sanitizers.h>
#include <argos3/testing/support/toy_world.h>

#include <catch2/catch.hpp>

#include <set>

namespace add_remove_test {

using namespace argos;
using Catch::Matchers::Contains;

namespace {

SExperiment Experiment(UInt32 robots, bool noisy, const std::string& parameters = "") {
  SDeviceWorld devices;
  devices.Robots = robots;
  devices.IsNoisy = noisy;
  devices.Parameters = parameters;
  devices.HasBareControllers = true;
  SExperiment experiment = devices.ToExperiment();
  experiment.LoopFunctions = "<loop_functions label='toy_loop_functions'/>";
  return experiment;
}

// two foot-bots half a metre apart, each within the view of the other's cameras
SExperiment ViewerAndVictim() {
  SExperiment experiment = Experiment(3, false, "reads='false'");
  // the other robots are far away
  const CVector3 place(-3.0, -3.0, 0.0);
  experiment.Arena +=
      // the cameras look ahead, all around and backwards
      DeviceUserRobotText("foot-bot", "fb_viewer", place, 180.0) +
      DeviceUserRobotText("foot-bot", "fb_victim", place + CVector3(0.5, 0.0, 0.0), 180.0);
  return experiment;
}

CToyLoopFunctions& Hooks(CTestWorld& world) {
  return world.GetLoopFunctions<CToyLoopFunctions>();
}

CGripperEquippedEntity& Gripper(CTestWorld& world, const std::string& id) {
  return world.Get<CFootBotEntity>(id).GetGripperEquippedEntity();
}

// adds robots of all types at random places, from XML or by constructors in turns
void AddSome(CPopulation& population, CRandomStream& random, UInt32 number, UInt32 firstNumber) {
  static const char* const prefixes[] = {"fb", "ep", "eb"};
  for (UInt32 i = firstNumber; i < firstNumber + number; ++i) {
    const UInt32 type = i % 3;
    const CVector3 place(random.Uniform(-4.0, 4.0), random.Uniform(-4.0, 4.0),
                         type == 2 ? 0.8 : 0.0);
    const std::string id = prefixes[type] + std::string("_new") + std::to_string(i);
    const Real yaw = random.Uniform(-180.0, 180.0);
    i % 2 == 0 ? population.AddFromText(id, place, yaw) : population.AddFromProgram(id, place, yaw);
  }
}

void RemoveSome(CPopulation& population, CRandomStream& random, UInt32 number) {
  for (UInt32 i = 0; i < number; ++i) {
    const std::vector<std::string> robots = population.GetRobotIds();
    population.Remove(robots[static_cast<size_t>(random.Uniform(0.0, 1.0) * robots.size())]);
  }
}

}  // namespace

TEST_CASE("add and remove: a robot removed before the others sense is not sensed",
          "[determinism][devices][space]") {
  CTestWorld untouched(ViewerAndVictim());
  CPopulation(untouched).CheckViews();
  untouched.Step(5);
  // LEDs, directional LEDs, a tag, a packet, a message, and beams that end on the body
  const size_t seen = CPopulation(untouched).GetUser("fb_viewer").CountSeen();
  CHECK(seen >= 6);

  CTestWorld world(ViewerAndVictim());
  CPopulation population(world);
  SECTION("during PreStep, after the update of the media") {
    world.Step(4);
    Hooks(world).OnPreStep = [&] {
      population.Remove("fb_victim");
      population.CheckViews();
      Hooks(world).OnPreStep = {};
    };
    world.Step();
    population.CheckViews();
    // the message of a radio was delivered before the removal
    CHECK(population.GetUser("fb_viewer").CountSeen() == 1);
  }
  SECTION("during PostStep, with a packet and a message in transit") {
    world.Step(4);
    Hooks(world).OnPostStep = [&] {
      population.Remove("fb_victim");
      population.CheckViews();
      Hooks(world).OnPostStep = {};
    };
    world.Step();
    // the readings of that step are unchanged
    CHECK(population.GetUser("fb_viewer").CountSeen() == seen);
  }
  SECTION("between two steps") {
    world.Step(5);
    population.Remove("fb_victim");
  }
  world.Step();
  population.CheckViews();
  CHECK(population.GetUser("fb_viewer").CountSeen() == 0);
  world.GetSimulator().Reset();
  population.CheckViews();
  world.Step(5);
  CHECK(population.GetUser("fb_viewer").CountSeen() == 0);
  // a robot added in the same place is sensed like the removed one
  population.AddFromText("fb_victim", CVector3(-2.5, -3.0, 0.0), 180.0);
  world.GetSimulator().Reset();
  world.Step(5);
  CHECK(population.GetUser("fb_viewer").CountSeen() == seen);
}

TEST_CASE("add and remove: of two robots connected by a grip either may be removed",
          "[determinism][devices][space]") {
  const std::string first = GENERATE("fb_holder", "fb_held");
  CAPTURE(first);
  const std::string second = first == "fb_held" ? "fb_holder" : "fb_held";
  SExperiment experiment = Experiment(9, true, "reads='false'");
  const CVector3 place(3.0, 3.0, 0.0);
  const CVector3 ahead(2.0 * kFootBotRadius + 0.002, 0.0, 0.0);
  experiment.Arena += DeviceUserRobotText("foot-bot", "fb_holder", place, 0.0) +
                      DeviceUserRobotText("foot-bot", "fb_held", place + ahead, 0.0);
  CTestWorld world(experiment);
  CPopulation population(world);
  world.Step(3);
  REQUIRE(Gripper(world, "fb_holder").IsGripping());
  REQUIRE(Gripper(world, "fb_holder").GetGrippedEntity().GetRootEntity().GetId() == "fb_held");
  population.Remove(first);
  population.CheckViews();
  CHECK_FALSE(Gripper(world, second).IsGripping());
  world.Step(3);
  CHECK_FALSE(Gripper(world, second).IsGripping());
  // the remaining robot can grip and be gripped again
  population.AddFromText(first, first == "fb_held" ? place + ahead : place, 0.0);
  world.GetSimulator().Reset();
  population.CheckViews();
  world.Step(3);
  REQUIRE(Gripper(world, "fb_holder").IsGripping());
  population.Remove("fb_held");
  population.Remove("fb_holder");
  population.CheckViews();
  world.Step(3);
}

TEST_CASE("add and remove: an id can be reused after a removal, but not before",
          "[determinism][devices][space]") {
  const bool fromText = GENERATE(true, false);
  CAPTURE(fromText);
  CTestWorld world(Experiment(12, true));
  CPopulation population(world);
  const auto add = [&](const std::string& id) {
    const CVector3 place(3.0, -3.0, RobotOf(id) == "eye-bot" ? 1.0 : 0.0);
    fromText ? population.AddFromText(id, place, 30.0) : population.AddFromProgram(id, place, 30.0);
  };
  for (const std::string id : {"fb0", "ep1", "eb2"}) {
    CAPTURE(id);
    world.Step(2);
    const UInt64 digest = world.ComputeDigest();
    CHECK_THROWS_WITH(add(id), Contains("already an entity with id \"" + id + "\""));
    population.CheckViews();
    CHECK(world.ComputeDigest() == digest);
    population.Remove(id);
    add(id);
    population.CheckViews();
    world.Step(2);
    population.CheckViews();
    CHECK(population.GetUser(id).GetReadingsDigest() != 0);
    population.Remove(id);
    population.CheckViews();
  }
}

TEST_CASE("add and remove: all entities may be removed, and others added",
          "[determinism][devices][space]") {
  CTestWorld world(Experiment(30, true));
  CPopulation population(world);
  world.Step(5);
  const std::vector<std::string> ids = population.GetIds();
  for (const std::string& id : ids) {
    if (id != "floor") {
      population.Remove(id);
    }
  }
  population.CheckViews();
  world.Step(2);
  world.GetSimulator().Reset();
  population.CheckViews();
  world.Step(2);
  population.Remove("floor");
  CHECK(world.GetSpace().GetRootEntityVector().empty());
  CHECK_THROWS_WITH(world.GetSpace().GetFloorEntity(), Contains("no floor"));
  world.Step(2);
  world.GetSimulator().Reset();
  population.CheckViews();
  // eye-bots need no floor
  population.AddFromText("eb_new", CVector3(0.0, 0.0, 1.0), 0.0);
  population.AddFromProgram("eb_other", CVector3(0.6, 0.0, 1.0), 0.0);
  population.CheckViews();
  world.Step(3);
  population.CheckViews();
  CHECK(population.GetUser("eb_new").CountSeen() > 0);
}

TEST_CASE("add and remove: a hundred robots are removed and added in each tick",
          "[determinism][devices][space][threads]") {
  constexpr UInt32 kTicks = FewerIfSanitized(100);
  constexpr UInt32 kEach = 100;
  const auto run = [&](UInt32 threads) {
    SExperiment experiment = Experiment(120, true);
    experiment.Threads = threads;
    CTestWorld world(experiment);
    CPopulation population(world);
    CRandomStream random(1, "test", "population", "changes");
    UInt32 next = 0;
    const auto change = [&] {
      RemoveSome(population, random, kEach);
      AddSome(population, random, kEach, next);
      next += kEach;
    };
    std::vector<UInt64> digests;
    for (UInt32 tick = 0; tick < kTicks; ++tick) {
      Hooks(world).OnPreStep = {};
      Hooks(world).OnPostStep = {};
      if (tick % 3 == 0) {
        Hooks(world).OnPreStep = change;
      } else if (tick % 3 == 1) {
        Hooks(world).OnPostStep = change;
      } else {
        change();
      }
      world.Step();
      if (tick % 20 < 3) {
        population.CheckViews();
      }
      digests.push_back(world.ComputeDigest());
    }
    // after a reset the remaining robots start afresh, and repeat their run
    Hooks(world).OnPreStep = {};
    Hooks(world).OnPostStep = {};
    for (int repetition = 0; repetition < 2; ++repetition) {
      world.GetSimulator().Reset();
      population.CheckViews();
      std::vector<UInt64> repeated;
      for (int tick = 0; tick < 10; ++tick) {
        world.Step();
        repeated.push_back(world.ComputeDigest());
      }
      if (repetition == 1) {
        CHECK(std::equal(repeated.begin(), repeated.end(), digests.end() - 10));
      }
      digests.insert(digests.end(), repeated.begin(), repeated.end());
    }
    return digests;
  };
  const std::vector<UInt64> alone = run(0);
  CHECK(std::set<UInt64>(alone.begin(), alone.end() - 10).size() == kTicks + 10);
  CHECK(run(4) == alone);
}

}  // namespace add_remove_test
