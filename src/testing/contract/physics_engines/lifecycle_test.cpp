// Adding, moving, removing and resetting while an engine runs.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

std::string Square() {
  return DriverXml("e-puck", "a", 0, 0, 0, 10, 10) + DriverXml("e-puck", "b", 1, 0, 180, 10, 10) +
         DriverXml("foot-bot", "c", 0.5, 0.6, 270, 8, 10) +
         "<box id='box' size='0.2,0.2,0.1' movable='true' mass='0.5'><body "
         "position='0.5,0.2,0'/></box>";
}

}  // namespace

TEST_CASE("lifecycle: a robot added in a run drives, and is gone when removed",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), Square());
  world.Step(5);
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  functions.AddEntity(
      *std::make_unique<CEPuckEntity>("new", "driver", CVector3(3, 3, 0)).release());
  world.Driver("new").Left = world.Driver("new").Right = 10.0;
  world.Step(11);
  CHECK_THAT(world.Position("new").GetX(), WithinAbs(3.1, 1e-6 + engine.Slack));
  CHECK(world.GetSimulator().GetPhysicsEngines().front()->GetNumPhysicsModels() == 5);

  functions.RemoveEntity("new");
  CHECK(world.GetSimulator().GetPhysicsEngines().front()->GetNumPhysicsModels() == 4);
  CHECK_THROWS_WITH(world.GetSpace().GetEntity("new"), Contains("\"new\""));
  world.Step(5);
}

TEST_CASE("lifecycle: a robot is put where there is room, not where there is none",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "a", 0, 0, 0, 10, 10) +
                                        DriverXml("e-puck", "b", 5, 5, 0, 0, 0));
  world.Step(3);
  // a free place is taken, an occupied one refused
  CHECK(world.Body("b").MoveTo(CVector3(0.3, 0, 0), CQuaternion()));
  CHECK_FALSE(world.Body("b").MoveTo(world.Position("a"), CQuaternion()));
  CHECK(world.Position("b") == CVector3(0.3, 0, 0));
  CHECK_FALSE(world.Body("b").IsCollidingWithSomething());
  if (IsSkipped(engine, engine.HasContacts, "contacts")) {
    return;
  }
  world.Step(40);
  // a pushes b with half its force against b's brakes: they stay apart
  CHECK(world.Position("b").GetX() - world.Position("a").GetX() >= 0.07 * 0.98);
}

TEST_CASE("lifecycle: a robot that is moved drives on from there, as it was turned",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "r", 0, 0, 0, 10, 10));
  world.Step(11);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.1, 1e-9 + engine.Slack));
  // a quarter turn to the left
  const CQuaternion left(CRadians::PI_OVER_TWO, CVector3::Z);
  CHECK(world.Body("r").MoveTo(CVector3(2, 3, 0), left));
  CHECK(world.Position("r") == CVector3(2, 3, 0));
  CHECK(world.Body("r").GetOriginAnchor().Orientation == left);
  CHECK_THAT(world.Body("r").GetBoundingBox().MinCorner.GetX(), WithinAbs(2 - 0.085036758, 1e-9));
  world.Step(10);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(2.0, 1e-9 + engine.Slack));
  // in dynamics2d it starts from rest, with 15 N on 1.6 kg: within the first tick
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(3.1, engine.HasMomentum ? 0.01 : 1e-9));
  CHECK_THAT(world.Yaw("r"), WithinAbs(0.5 * ARGOS_PI, 1e-12 + engine.Slack));
}

TEST_CASE("lifecycle: after a reset the run repeats to the bit", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), Square());
  std::vector<UInt64> first;
  for (int tick = 0; tick < 120; ++tick) {
    world.Step();
    first.push_back(world.ComputeDigest());
  }
  world.GetSimulator().Reset();
  for (int tick = 0; tick < 120; ++tick) {
    world.Step();
    REQUIRE(world.ComputeDigest() == first[tick]);
  }
}

TEST_CASE("lifecycle: a body that leaves its engine's region is taken over by the next",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToTwoXml(0.0), DriverXml("foot-bot", "r", -0.5, 0, 0, 10, 10));
  CHECK(world.Body("r").GetPhysicsModel(0).GetEngine().GetId() == "west");
  world.Step(101);
  CHECK(world.Body("r").GetPhysicsModel(0).GetEngine().GetId() == "east");
  CHECK(world.Body("r").GetPhysicsModelsNum() == 1);
  // the border does not disturb its path
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.5, 1e-6 + engine.Slack));
}

TEST_CASE("lifecycle: a reset gives each body back to the engine that had it first",
          "[contract][engine]") {
  // what leaves the first one goes to the second, which has no borders and so keeps it
  CDriveWorld world(
      "<dynamics2d id='west'><boundaries><sides><vertex point='-10,-10'/><vertex point='1,-10'/>"
      "<vertex point='1,10'/><vertex point='-10,10'/></sides></boundaries></dynamics2d>"
      "<dynamics2d id='east'/>",
      DriverXml("e-puck", "r", 0.5, 0, 0, 12, 12) +
          DriverXml("e-puck", "s", 0.5, 0.5, 180, 12, 12) +
          "<box id='post' size='2,0.2,0.2' movable='false'><body "
          "position='-1.5,0.5,0'/></box>");
  const auto engineOf = [&world](const std::string& id) {
    return world.Body(id).GetPhysicsModel(0).GetEngine().GetId();
  };
  std::vector<UInt64> first = {world.ComputeDigest()};
  const auto engineCount = [&world](const std::string& id) {
    return world.GetSimulator().GetPhysicsEngine(id).GetNumPhysicsModels();
  };
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    first.push_back(world.ComputeDigest());
  }
  CHECK(engineOf("r") == "east");
  CHECK(engineOf("s") == "west");
  // the post's face is at x = -0.5; the robot at full speed stands against it
  CHECK_THAT(world.Position("s").GetX(), WithinAbs(-0.5 + 0.035, 1e-3));
  for (int repetition = 0; repetition < 2; ++repetition) {
    world.GetSimulator().Reset();
    CHECK(engineOf("r") == "west");
    CHECK(engineCount("west") == 3);
    CHECK(engineCount("east") == 1);  // the post
    CHECK(world.ComputeDigest() == first[0]);
    for (int tick = 0; tick < 100; ++tick) {
      world.Step();
      REQUIRE(world.ComputeDigest() == first[tick + 1]);
    }
  }
  // also one that a test has put elsewhere since
  CHECK(world.Body("s").MoveTo(CVector3(5, 5, 0), CQuaternion()));
  world.Step();
  CHECK(engineOf("s") == "east");
  world.GetSimulator().Reset();
  CHECK(engineOf("s") == "west");
}

TEST_CASE("lifecycle: after a reset a body is back in the engine in which it started",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToTwoXml(0.0), DriverXml("foot-bot", "r", -0.05, 0, 20, 10, 9));
  std::vector<UInt64> first;
  for (int tick = 0; tick < 30; ++tick) {
    world.Step();
    first.push_back(world.ComputeDigest());
  }
  REQUIRE(world.Body("r").GetPhysicsModel(0).GetEngine().GetId() == "east");
  world.GetSimulator().Reset();
  for (int tick = 0; tick < 30; ++tick) {
    world.Step();
    CHECK(world.Body("r").GetPhysicsModel(0).GetEngine().GetId() == (tick < 6 ? "west" : "east"));
    REQUIRE(world.ComputeDigest() == first[tick]);
  }
}

TEST_CASE("limits: what an engine cannot house, or finish, is refused with a reason",
          "[contract][engine]") {
  const std::string plane = kDynamics2D.ToXml();
  CHECK_THROWS_WITH(CDriveWorld(plane, DriverXml("e-puck", "r", 1e8, 0, 0, 0, 0)),
                    Contains("\"r\" is too large or too far away"));
  CHECK_THROWS_WITH(CDriveWorld(plane, "<box id='b' size='1e30,1,1' movable='false'><body/></box>"),
                    Contains("\"b\" is too large or too far away"));
  CHECK_THROWS_WITH(CDriveWorld(kPointMass3D.ToXml(), DriverXml("e-puck", "r", 1e10, 0, 0, 0, 0)),
                    Contains("\"r\" at (1e+10,0,0) is farther than 1e+09 m from the origin"));
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CHECK_THROWS_WITH(CDriveWorld(engine.ToXml("e", "iterations='4294967295'"), ""),
                    Contains("\"iterations\" must be at most 10000, found 4294967295"));
  CHECK_THROWS_WITH(CDriveWorld(engine.ToXml("e", "iterations='0'"), ""),
                    Contains("\"iterations\" must be at least 1, found 0"));
}

}  // namespace argos
