// Adding, moving, removing and resetting during a run.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/geometry/body_index.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::lifecycle_test {

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

TEST_CASE("lifecycle: a robot added during a run drives, and is gone after its removal",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToPromptXml(), Square());
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

TEST_CASE("lifecycle: a robot can be moved to free places only", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "a", 0, 0, 0, 10, 10) +
                                        DriverXml("e-puck", "b", 5, 5, 0, 0, 0));
  world.Step(3);
  // a free place is accepted, an occupied one refused
  CHECK(world.Body("b").MoveTo(CVector3(0.3, 0, 0), CQuaternion()));
  CHECK_FALSE(world.Body("b").MoveTo(world.Position("a"), CQuaternion()));
  CHECK(world.Position("b") == CVector3(0.3, 0, 0));
  CHECK_FALSE(world.Body("b").IsCollidingWithSomething());
  // where collisions are ignored, every place is accepted, as in ARGoS 3
  const CVector3 taken = world.Position("a");
  CHECK(world.Body("b").MoveTo(taken, CQuaternion(), true, true));
  CHECK(world.Position("b") == CVector3(0.3, 0, 0));
  CHECK(world.Body("b").MoveTo(taken, CQuaternion(), false, true));
  CHECK(world.Position("b") == taken);
  CHECK(world.Body("b").MoveTo(CVector3(0.3, 0, 0), CQuaternion()));
  if (IsSkipped(engine, engine.HasContacts, "contacts")) {
    return;
  }
  world.Step(40);
  // a pushes b with half its force against b's brakes: they stay apart
  CHECK(world.Position("b").GetX() - world.Position("a").GetX() >= 0.07 * 0.98);
}

TEST_CASE("lifecycle: a moved robot drives on from its new pose", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToPromptXml(), DriverXml("foot-bot", "r", 0, 0, 0, 10, 10));
  world.Step(11);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.1, 1e-9 + engine.Slack));
  // a quarter turn to the left
  const CQuaternion left(CRadians::PI_OVER_TWO, CVector3::Z);
  CHECK(world.Body("r").MoveTo(CVector3(2, 3, 0), left));
  CHECK(world.Position("r") == CVector3(2, 3, 0));
  CHECK(world.Body("r").GetOriginAnchor().Orientation == left);
  CHECK_THAT(world.Body("r").GetBoundingBox().MinCorner.GetX(),
             WithinAbs(2 - kFootBotRadius, 1e-9));
  world.Step(10);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(2.0, 1e-9 + engine.Slack));
  // in dynamics2d it accelerates from rest, with 15 N on 1.6 kg: within the first tick
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(3.1, engine.HasMomentum ? 0.01 : 1e-9));
  CHECK_THAT(world.Yaw("r"), WithinAbs(0.5 * ARGOS_PI, 1e-12 + engine.Slack));
}

TEST_CASE("lifecycle: what is moved off the plane of an engine is put on it, upright",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "a", 0, 0, 0, 10, 10) +
                                        "<box id='wall' size='0.2,1,0.5' movable='false'><body "
                                        "position='5,5,0'/></box>");
  world.Step(2);
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  const CQuaternion yaw(CRadians(0.1), CVector3::Z);
  const CQuaternion tilted = yaw * CQuaternion(CRadians(0.3), CVector3::X);
  CHECK(functions.MoveEntity(world.Body("wall"), CVector3(0.4, 0, 0.25), tilted));
  CHECK(world.Position("wall") == CVector3(0.4, 0, engine.IsPlane ? 0.0 : 0.25));
  // half of 0.3 rad, about x
  CHECK_THAT(world.Body("wall").GetOriginAnchor().Orientation.GetX(),
             WithinAbs(engine.IsPlane ? 0.0 : std::sin(0.15) * std::cos(0.05), 1e-12));
  if (!engine.IsPlane) {
    return;
  }
  CHECK_THAT(world.Yaw("wall"), WithinAbs(0.1, 1e-12));
  // what stops the robot is what its sensors measure
  const CBodyIndex& index = world.GetSpace().GetBodyIndex();
  world.Step(60);
  CHECK(world.Position("a").GetX() < 0.4 - 0.1 - 0.9 * kEPuckRadius);
  const CRay3 ahead(CVector3(0, 0, 0.05), CVector3(1, 0, 0.05));
  TEmbodiedEntityIntersectionData hits;
  index.FindAllHits(hits, ahead);
  CHECK(std::any_of(hits.begin(), hits.end(),
                    [&](const auto& hit) { return hit.IntersectedEntity == &world.Body("wall"); }));
}

TEST_CASE("lifecycle: a wall is lifted off the plane of one engine if another one has it, too",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(kDynamics2D, kKinematics2D);
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml("plane") + "<pointmass3d id='space'/>",
                    DriverXml("e-puck", "a", 0, 0, 0, 10, 10) +
                        "<box id='wall' size='0.2,1,0.5' movable='false'><body "
                        "position='0.4,0,0'/></box>");
  CHECK(world.Body("wall").GetPhysicsModelsNum() == 2);
  CHECK(world.Body("wall").MoveTo(CVector3(0.4, 0, 0.5), CQuaternion()));
  CHECK(world.Position("wall").GetZ() == 0.5);
  CHECK(world.EngineOf("wall") == "space");
  world.Step(60);
  // it drives under the wall
  CHECK(world.Position("a").GetX() > 0.5);
  CHECK(world.Body("wall").MoveTo(CVector3(2, 0, 0), CQuaternion()));
  CHECK(world.Body("wall").GetPhysicsModelsNum() == 2);
}

TEST_CASE("lifecycle: a reset of the space alone puts bodies at rest where they started",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  const bool whole = GENERATE(true, false);
  CAPTURE(engine, whole);
  CDriveWorld world(
      engine.ToXml(),
      DriverXml("foot-bot", "a", 0, 0, 0, 10, 10) + DriverXml("foot-bot", "b", 0, 1, 0, 10, 10) +
          "<box id='box' size='0.2,0.2,0.2' movable='true' mass='0.5'><body "
          "position='0.25,0,0'/></box>"
          "<box id='wall' size='0.1,0.5,0.2' movable='false'><body position='0,3,0'/></box>");
  const std::vector<std::string> ids = {"a", "b", "box", "wall"};
  std::vector<CVector3> start;
  std::vector<CVector3> end;
  const auto run = [&] {
    world.Driver("a").Left = world.Driver("a").Right = 10.0;
    world.Driver("b").Left = world.Driver("b").Right = 10.0;
    std::vector<CVector3> positions;
    world.Step(20);
    for (const std::string& id : ids) {
      positions.push_back(world.Position(id));
    }
    return positions;
  };
  for (const std::string& id : ids) {
    start.push_back(world.Position(id));
  }
  end = run();
  CHECK(end[1].GetX() > 0.15);
  // they come to rest
  world.Driver("a").Left = world.Driver("a").Right = 0.0;
  world.Driver("b").Left = world.Driver("b").Right = 0.0;
  CHECK(world.Body("wall").MoveTo(CVector3(0.5, 1, 0), CQuaternion()));
  world.Step(10);
  if (whole) {
    world.GetSpace().Reset();
  } else {
    for (const std::string& id : ids) {
      world.GetSpace().GetEntity(id).Reset();
    }
  }
  world.Step(20);
  for (size_t i = 0; i < ids.size(); ++i) {
    CAPTURE(ids[i]);
    CHECK(Distance(world.Position(ids[i]), start[i]) <= 1e-9 + engine.Slack);
  }
  // the place where "b" was is free, and the place where it is now is not
  const CEmbodiedEntity& body = world.Body("b");
  const CBodyIndex& index = world.GetSpace().GetBodyIndex();
  const auto find = [&](const CVector3& place) {
    return index.FindOverlap(*body.GetBodyDescription(), place, CQuaternion(), CBodyIndex::kNoBody);
  };
  CHECK(find(CVector3(end[1].GetX(), 1, 0)) == CBodyIndex::kNoBody);
  CHECK(find(CVector3(0.0, 1, 0)) == body.GetBodyNumber());
  // engines move them from there: as in the first run
  const std::vector<CVector3> again = run();
  for (size_t i = 0; i < ids.size(); ++i) {
    CAPTURE(ids[i]);
    // bodies that have settled start lower
    CHECK(Distance(again[i], end[i]) <= 1e-6 + engine.Slack + 0.3 * engine.Slip);
  }
}

TEST_CASE("lifecycle: after a reset the run repeats bit by bit", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), Square());
  const std::vector<UInt64> first = RecordDigests(world, 120);
  world.GetSimulator().Reset();
  CHECK(RecordDigests(world, 120) == first);
}

TEST_CASE("lifecycle: a body that leaves its engine's region is transferred to the next engine",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToTwoXml(0.0, engine.GetPromptness()),
                    DriverXml("foot-bot", "r", -0.5, 0, 0, 10, 10));
  CHECK(world.EngineOf("r") == "west");
  world.Step(101);
  CHECK(world.EngineOf("r") == "east");
  CHECK(world.Body("r").GetPhysicsModelsNum() == 1);
  // the border does not affect its path
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.5, 1e-6 + engine.Slack));
}

TEST_CASE("lifecycle: a reset returns each body to its first engine", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  // bodies that leave the first engine are transferred to the second, which
  // has no borders and so keeps them
  CDriveWorld world(
      engine.ToXml("west", "",
                   "<boundaries><sides><vertex point='-10,-10'/><vertex point='1,-10'/><vertex "
                   "point='1,10'/><vertex point='-10,10'/></sides></boundaries>") +
          engine.ToXml("east"),
      DriverXml("e-puck", "r", 0.5, 0, 0, 12, 12) +
          DriverXml("e-puck", "s", 0.5, 0.5, 180, 12, 12) +
          "<box id='post' size='2,0.2,0.2' movable='false'><body "
          "position='-1.5,0.5,0'/></box>");
  std::vector<UInt64> first = {world.ComputeDigest()};
  const auto engineCount = [&world](const std::string& id) {
    return world.GetSimulator().GetPhysicsEngine(id).GetNumPhysicsModels();
  };
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    first.push_back(world.ComputeDigest());
  }
  CHECK(world.EngineOf("r") == "east");
  CHECK(world.EngineOf("s") == "west");
  if (engine.HasContacts) {
    // the face of the post is at x = -0.5; the robot drives against it at full speed
    CHECK_THAT(world.Position("s").GetX(), WithinAbs(-0.5 + kEPuckRadius, 1e-3));
  }
  for (int repetition = 0; repetition < 2; ++repetition) {
    world.GetSimulator().Reset();
    CHECK(world.EngineOf("r") == "west");
    CHECK(engineCount("west") == 3);
    CHECK(engineCount("east") == 1);  // the post
    CHECK(world.ComputeDigest() == first[0]);
    for (int tick = 0; tick < 100; ++tick) {
      world.Step();
      REQUIRE(world.ComputeDigest() == first[tick + 1]);
    }
  }
  // including a body that a test has moved since
  CHECK(world.Body("s").MoveTo(CVector3(5, 5, 0), CQuaternion()));
  world.Step();
  CHECK(world.EngineOf("s") == "east");
  world.GetSimulator().Reset();
  CHECK(world.EngineOf("s") == "west");
}

TEST_CASE("lifecycle: after a reset a body is in the engine in which it started",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToTwoXml(0.0), DriverXml("foot-bot", "r", -0.05, 0, 20, 10, 9));
  std::vector<UInt64> first;
  for (int tick = 0; tick < 30; ++tick) {
    world.Step();
    first.push_back(world.ComputeDigest());
  }
  REQUIRE(world.EngineOf("r") == "east");
  world.GetSimulator().Reset();
  for (int tick = 0; tick < 30; ++tick) {
    world.Step();
    CHECK(world.EngineOf("r") == (tick < 6 ? "west" : "east"));
    REQUIRE(world.ComputeDigest() == first[tick]);
  }
}

TEST_CASE("lifecycle: after moves, additions and removals a reset starts the same run",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  const std::string solver = GENERATE_COPY(from_range(engine.Solvers));
  CAPTURE(engine, solver);
  CDriveWorld world(engine.ToXml("e", "", solver), Square());
  const std::vector<UInt64> first = RecordDigests(world, 60);
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  world.GetSimulator().Reset();
  world.Step(30);
  // while the robots press against each other
  CHECK(world.Body("box").MoveTo(CVector3(2, 2, 0), CQuaternion(CRadians(1.0), CVector3::Z)));
  CHECK(world.Body("c").MoveTo(CVector3(1, -1, 0), CQuaternion()));
  functions.AddEntity(
      *std::make_unique<CEPuckEntity>("new", "driver", CVector3(-1, 1, 0)).release());
  world.Step(10);
  functions.RemoveEntity("new");
  world.Step(10);
  for (int repetition = 0; repetition < 2; ++repetition) {
    world.GetSimulator().Reset();
    REQUIRE(world.ComputeDigest() == first[0]);
    for (int tick = 1; tick <= 60; ++tick) {
      world.Step();
      REQUIRE(world.ComputeDigest() == first[tick]);
    }
  }
}

TEST_CASE("lifecycle: a body removed in contact does not obstruct others any more",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  // a robot stopped by an immovable box, stopped by a robot of its type, or pushing an object
  const std::string what = GENERATE(
      as<std::string>(),
      "<box id='x' size='0.2,0.5,0.2' movable='false'><body position='0.3,0,0'/></box>",
      "<box id='x' size='0.2,0.2,0.1' movable='true' mass='0.5'><body position='0.3,0,0'/></box>",
      "robot");
  CAPTURE(what);
  CDriveWorld world(engine.ToXml(),
                    DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) +
                        (what == "robot" ? DriverXml("foot-bot", "x", 0.3, 0, 180, 10, 10) : what));
  world.Step(50);
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  functions.RemoveEntity("x");
  CHECK(world.GetSimulator().GetPhysicsEngines().front()->GetNumPhysicsModels() == 1);
  // after a tick of acceleration it moves freely
  world.Step(2);
  const CVector3 before = world.Position("r");
  const Real yaw = world.Yaw("r");
  world.Step(20);
  const CVector3 moved = world.Position("r") - before;
  CHECK_THAT(moved.Length(), WithinAbs(0.2, 1e-6 + engine.Slack));
  CHECK_THAT(std::atan2(moved.GetY(), moved.GetX()), WithinAbs(yaw, 1e-5 + engine.Slack));
}

TEST_CASE("lifecycle: robots can be removed one after the other from the middle of a crowd",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  std::string arena;
  for (int i = 0; i < 25; ++i) {
    const Real x = 0.08 * (i % 5 - 2);
    const Real y = 0.08 * (i / 5 - 2);
    arena += DriverXml("e-puck", "r" + std::to_string(i), x, y,
                       std::atan2(-y, -x) * 180.0 / ARGOS_PI, 8, 8);
  }
  CDriveWorld world(engine.ToXml(), arena);
  world.Step(10);
  CLoopFunctions& functions = world.GetSimulator().GetLoopFunctions();
  CPhysicsEngine& only = *world.GetSimulator().GetPhysicsEngines().front();
  std::vector<int> left;
  for (int i = 0; i < 25; ++i) {
    if (i % 3 == 0) {
      functions.RemoveEntity("r" + std::to_string(i));
      world.Step();
    } else {
      left.push_back(i);
    }
  }
  CHECK(only.GetNumPhysicsModels() == left.size());
  world.Step(20);
  for (const int i : left) {
    // no robot was thrown out: they have driven for 4 s at most
    const CVector3 position = world.Position("r" + std::to_string(i));
    REQUIRE(position.Length() < 0.08 * std::sqrt(8.0) + 0.01 * 40);
    for (const int k : left) {
      const CVector3 other = world.Position("r" + std::to_string(k));
      REQUIRE((i == k || Distance(position, other) >=
                             2.0 * kEPuckRadius - 0.02 * kEPuckRadius - engine.Slack));
    }
  }
}

TEST_CASE(
    "limits: bodies and solver settings that an engine does not support are refused with a reason",
    "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CHECK_THROWS_WITH(
      CDriveWorld(engine.ToXml(), DriverXml("e-puck", "r", 10.0 * engine.Farthest, 0, 0, 0, 0)),
      Contains("\"r\"") && (Contains("too far away") || Contains("is farther than")));
  CHECK_THROWS_WITH(CDriveWorld(engine.ToXml("e", "iterations='4294967295'"), ""),
                    Contains("\"iterations\" must be at most 10000, found 4294967295"));
  CHECK_THROWS_WITH(CDriveWorld(engine.ToXml("e", "iterations='0'"), ""),
                    Contains("\"iterations\" must be at least 1, found 0"));
  if (IsSkipped(engine, engine.IsPlane, "limit of size")) {
    return;
  }
  CHECK_THROWS_WITH(
      CDriveWorld(engine.ToXml(),
                  "<box id='b' size='1e5,1,1' movable='false'><body position='9.9e5,0,0'/></box>"),
      Contains("\"b\" is too large or too far away"));
}

TEST_CASE("lifecycle: bodies are transferred between engines of the plane with their motion",
          "[contract][engine]") {
  const auto part = [](const SEngineType& engine, const std::string& from, const std::string& to) {
    const auto at = [](const std::string& x, const std::string& y) {
      return "<vertex point='" + x + "," + y + "'/>";
    };
    return engine.ToPromptXml(engine.Tag, "<boundaries><sides>" + at(from, "-10") + at(to, "-10") +
                                              at(to, "10") + at(from, "10") +
                                              "</sides></boundaries>");
  };
  CDriveWorld world(part(kDynamics2D, "-10", "0") + part(kKinematics2D, "0", "10"),
                    DriverXml("foot-bot", "there", -0.5, 0, 0, 10, 10) +
                        DriverXml("foot-bot", "back", 0.5, 1, 180, 10, 10) +
                        "<box id='box' size='0.1,0.1,0.1' movable='true' mass='1'><body "
                        "position='0.3,1,0'/></box>");
  world.Step(101);
  CHECK(world.EngineOf("there") == "kinematics2d");
  CHECK(world.EngineOf("back") == "dynamics2d");
  CHECK(world.EngineOf("box") == "dynamics2d");
  CHECK_THAT(world.Position("there").GetX(), WithinAbs(0.5, 1e-6));
  CHECK(world.Position("box").GetX() < -0.4);
}

}  // namespace argos::lifecycle_test
