// What users' code may call in ControlStep(), in other phases of a tick and in hooks: what is done
// at the end of the tick, and what is refused with the robot or hook and the tick.

#include "fault_experiment.h"

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/experiment.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

namespace phases_test {

using namespace argos;
using Catch::Contains;

namespace {

// more robots than one thread handles in a row
constexpr UInt32 kManyRobots = 150;

std::string ErrorOfSteps(CTestWorld& world, UInt32 ticks) {
  try {
    world.Step(ticks);
  } catch (const CARGoSException& error) {
    return error.what();
  }
  return "";
}

std::vector<std::string> RootIds(CTestWorld& world) {
  std::vector<std::string> ids;
  for (const CEntity* root : world.GetSpace().GetRootEntityVector()) {
    ids.push_back(root->GetId());
  }
  return ids;
}

// runs five ticks; the result must not depend on threads
std::vector<std::string> RootsAfterDeed(SFaultExperiment experiment) {
  std::vector<std::string> ids;
  UInt64 digest = 0;
  for (const UInt32 threads : {0, 2, 3}) {
    CAPTURE(threads);
    experiment.Threads = threads;
    CTestWorld world(experiment.ToXml());
    world.Step(5);
    if (threads == 0) {
      ids = RootIds(world);
      digest = world.ComputeDigest();
    }
    CHECK(RootIds(world) == ids);
    CHECK(world.ComputeDigest() == digest);
  }
  TakeLogErr();
  return ids;
}

}  // namespace

TEST_CASE("faults: a robot that removes itself in its step is removed at the end of the tick",
          "[faults][threads]") {
  SFaultExperiment experiment;
  experiment.Robots = kManyRobots;
  experiment.Params = "where='step' what='remove_self' tick='3'";
  SECTION("one") {
    experiment.Params += " robot='ep70'";
    const std::vector<std::string> ids = RootsAfterDeed(experiment);
    CHECK(ids.size() == kManyRobots - 1);
    CHECK(std::count(ids.begin(), ids.end(), "ep70") == 0);
  }
  SECTION("all") {
    CHECK(RootsAfterDeed(experiment).empty());
  }
}

TEST_CASE("faults: a robot is still there in the tick in which it removes itself", "[faults]") {
  SFaultExperiment experiment;
  experiment.Params = "where='step' what='remove_self' tick='3' robot='ep0'";
  // PostStep() of the same tick finds the robot
  experiment.Loop = "where='post_step' what='set_controller' tick='3'";
  CTestWorld world(experiment.ToXml());
  world.Step(3);
  CHECK(RootIds(world).size() == experiment.Robots - 1);
}

TEST_CASE("faults: robots that remove all robots in their steps", "[faults][threads]") {
  SFaultExperiment experiment;
  experiment.Robots = kManyRobots;
  experiment.Params = "where='step' what='remove_all' tick='3'";
  CHECK(RootsAfterDeed(experiment).empty());
}

TEST_CASE("faults: sensors, actuators and media remove robots at the end of the tick",
          "[faults][threads]") {
  SFaultExperiment experiment;
  experiment.Robots = kManyRobots;
  const std::string removes = "where='update' what='remove_self' tick='2'";
  SECTION("sensors") {
    experiment.Sensors = "<test_misbehaving implementation='default' " + removes + "/>";
    CHECK(RootsAfterDeed(experiment).empty());
  }
  SECTION("actuators") {
    experiment.Actuators = "<test_misbehaving implementation='default' " + removes + "/>";
    CHECK(RootsAfterDeed(experiment).empty());
  }
  SECTION("media") {
    experiment.Media =
        "<test_misbehaving_medium id='m' where='update' what='remove_all' tick='2'/>";
    CHECK(RootsAfterDeed(experiment).empty());
  }
}

TEST_CASE("faults: code that removes until nothing is left is an error, not an endless loop",
          "[faults]") {
  SFaultExperiment experiment;
  experiment.Params = "where='step' what='remove_until_empty' tick='3' robot='ep2'";
  CTestWorld world(experiment.ToXml());
  CHECK_THAT(ErrorOfSteps(world, 5),
             Contains("robot \"ep2\"") && Contains("tick 3") && Contains("at the end of the tick"));
  // nothing was removed
  CHECK(RootIds(world).size() == experiment.Robots);
}

TEST_CASE("faults: entities that robots add in their steps are added in the robots' order",
          "[faults][threads]") {
  SFaultExperiment experiment;
  experiment.Robots = kManyRobots;
  SECTION("boxes") {
    experiment.Params = "where='step' what='add_box' tick='3'";
    const std::vector<std::string> ids = RootsAfterDeed(experiment);
    REQUIRE(ids.size() == 2 * kManyRobots);
    for (UInt32 i = 0; i < kManyRobots; ++i) {
      CHECK(ids[kManyRobots + i] == "box_of_ep" + std::to_string(i));
    }
  }
  SECTION("a robot, which gets its controller") {
    experiment.Params = "where='step' what='add_robot' tick='3' robot='ep70'";
    CHECK(RootsAfterDeed(experiment).back() == "child_of_ep70");
    CTestWorld world(experiment.ToXml());
    world.Step(4);
    CHECK(world.GetSpace().GetControllableEntities().back()->GetController().GetId() ==
          "child_of_ep70");
  }
}

TEST_CASE("faults: an entity that cannot be added at the end of the tick is named with its robot",
          "[faults]") {
  SFaultExperiment experiment;
  experiment.Params = "where='step' what='add_box' robot='ep1'";
  CTestWorld world(experiment.ToXml());
  // in the second tick the id is taken
  CHECK_THAT(ErrorOfSteps(world, 5), Contains("robot \"ep1\"") && Contains("ControlStep()") &&
                                         Contains("tick 2") && Contains("box_of_ep1"));
}

TEST_CASE("faults: calls that a robot must not make name it and the tick", "[faults][threads]") {
  const auto [what, name] = GENERATE(table<std::string, std::string>(
      {{"destroy", "CSimulator::Destroy()"},
       {"reset", "CSimulator::Reset()"},
       {"update_space", "CSimulator::UpdateSpace()"},
       {"update_of_space", "UpdateSpace()"},
       {"reset_of_space", "CSpace::Reset()"},
       {"destroy_of_space", "CSpace::Destroy()"},
       {"execute", "CSimulator::Execute()"},
       {"load", "CSimulator::LoadExperiment()"},
       {"iterate", "IterateOverControllableEntities()"},
       {"set_controller", "SetController()"},
       {"remove_by_operation", "an operation that adds or removes entities"}}));
  const UInt32 threads = GENERATE(0, 2);
  CAPTURE(what, threads);
  SFaultExperiment experiment;
  experiment.Robots = kManyRobots;
  experiment.Threads = threads;
  experiment.Params = "where='step' what='" + what + "' tick='3' robot='ep100'";
  CTestWorld world(experiment.ToXml());
  CHECK_THAT(ErrorOfSteps(world, 5),
             Contains("robot \"ep100\"") && Contains(name) && Contains("tick 3"));
  // nothing was changed: the run can go on
  CHECK(RootIds(world).size() == kManyRobots);
  CHECK(ErrorOfSteps(world, 2) == "");
  CHECK(world.GetSpace().GetSimulationClock() == 5);
}

TEST_CASE("faults: hooks of a tick add, remove and reset at once", "[faults]") {
  const std::string hook = GENERATE("pre_step", "post_step");
  CAPTURE(hook);
  SFaultExperiment experiment;
  const auto run = [&](const std::string& what) {
    experiment.Loop = "where='" + hook + "' what='" + what + "' tick='3'";
    CTestWorld world(experiment.ToXml());
    world.Step(4);
    return RootIds(world).size();
  };
  CHECK(run("remove_self") == 4);
  CHECK_THAT(TakeLog(), Contains("from 5 to 4 roots"));
  CHECK(run("remove_until_empty") == 0);
  CHECK(run("add_robot") == 6);
  CHECK_THAT(TakeLog(), Contains("from 5 to 6 roots"));
  CHECK(run("reset") == 5);
  CHECK(run("iterate") == 5);
}

TEST_CASE("faults: calls that a hook must not make name it and the tick", "[faults]") {
  const std::string hook = GENERATE("pre_step", "post_step");
  const auto [what, name] =
      GENERATE(table<std::string, std::string>({{"destroy", "CSimulator::Destroy()"},
                                                {"update_space", "UpdateSpace()"},
                                                {"execute", "CSimulator::Execute()"},
                                                {"load", "CSimulator::LoadExperiment()"}}));
  CAPTURE(hook, what);
  SFaultExperiment experiment;
  experiment.Loop = "where='" + hook + "' what='" + what + "' tick='3'";
  CTestWorld world(experiment.ToXml());
  CHECK_THAT(ErrorOfSteps(world, 5), Contains(hook == "pre_step" ? "PreStep()" : "PostStep()") &&
                                         Contains("tick 3") && Contains(name));
  CHECK(RootIds(world).size() == 5);
}

TEST_CASE("faults: the hooks of Execute() must not destroy the experiment", "[faults]") {
  const std::string hook = GENERATE("is_experiment_finished", "post_experiment");
  CAPTURE(hook);
  SFaultExperiment experiment;
  experiment.Loop = "where='" + hook + "' what='destroy'";
  CTestWorld world(experiment.ToXml());
  CHECK_THROWS_WITH(world.GetSimulator().Execute(), Contains("CSimulator::Destroy()"));
  CHECK(RootIds(world).size() == 5);
}

TEST_CASE("faults: robots that remove themselves when they are reset or destroyed", "[faults]") {
  SFaultExperiment experiment;
  SECTION("in Reset()") {
    experiment.Params = "where='reset' what='remove_self' robot='ep1'";
    CTestWorld world(experiment.ToXml());
    world.Step(2);
    world.GetSimulator().Reset();
    CHECK(RootIds(world) == std::vector<std::string>{"ep0", "ep2", "ep3", "ep4"});
    world.Step(2);
  }
  SECTION("in Destroy(), at the end") {
    experiment.Params = "where='destroy' what='remove_self'";
    CTestWorld world(experiment.ToXml());
    world.Step(2);
    world.GetSimulator().Destroy();
    CHECK(RootIds(world).empty());
  }
  SECTION("in Destroy(), when the loop functions remove them") {
    experiment.Params = "where='destroy' what='remove_all' tick='2'";
    experiment.Loop = "where='post_step' what='remove_self' tick='2'";
    CTestWorld world(experiment.ToXml());
    world.Step(3);
    CHECK(RootIds(world).empty());
  }
}

}  // namespace phases_test
