// Collisions between robots of an engine of rigid bodies and robots of other engines.

#include <argos3/testing/contract/physics_engines/flight_world.h>
#include <argos3/testing/contract/physics_engines/grip_world.h>
#include <argos3/testing/contract/physics_engines/regions.h>
#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/no_allocation.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::rigid_ghosts_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

Real RadiusOf(const std::string& tag) {
  return tag == "e-puck" ? kEPuckRadius : kFootBotRadius;
}

/** Engines on both sides of the border at x = 0. */
struct SSides {
  SEngineType West;
  SEngineType East;

  /** @param ofWest  attributes of the engine in the west. */
  std::string ToXml(const std::string& ofWest = "") const {
    return RegionXml(West, "west", {{-20, -20}, {0, -20}, {0, 20}, {-20, 20}}, ofWest) +
           RegionXml(East, "east", {{0, -20}, {20, -20}, {20, 20}, {0, 20}});
  }
};

SSides AnySides() {
  return GENERATE(SSides{kDynamics3D, kDynamics3D}, SSides{kDynamics2D, kDynamics3D},
                  SSides{kDynamics3D, kDynamics2D});
}

// "a" and "b" on the x axis, m; "a" drives at a speed, cm/s, "b" stands still
std::string FootBotsXml(Real a, Real b, Real speed = 0.0) {
  return DriverXml("foot-bot", "a", a, 0, 0, speed, speed) +
         DriverXml("foot-bot", "b", b, 0, 0, 0, 0);
}

}  // namespace

TEST_CASE("rigid ghosts: robots that drive head-on at a border do not overlap",
          "[contract][engine][rigid][partition]") {
  const SSides sides = AnySides();
  const std::string tagA = GENERATE(as<std::string>(), "e-puck", "foot-bot");
  const std::string tagB = GENERATE(as<std::string>(), "e-puck", "foot-bot");
  const Real speed = GENERATE(3.0, 10.0, 30.0);  // cm/s
  const Real shift = GENERATE(0.0, 0.011);  // m, distance of a's centre from the border
  CAPTURE(sides.West, sides.East, tagA, tagB, speed, shift);
  CRigidScene world(sides.ToXml(), DriverXml(tagA, "a", -0.4 - shift, 0, 0, speed, speed) +
                                       DriverXml(tagB, "b", 0.4 - shift, 0, 180, speed, speed));
  const Real radii = RadiusOf(tagA) + RadiusOf(tagB);
  Real deepest = -HUGE_VAL;
  // runs until one has pushed the other across the border, so that both are in one engine
  for (int tick = 0; tick < 200 && world.EngineOf("a") != world.EngineOf("b"); ++tick) {
    world.Step();
    deepest = std::max(deepest, radii - Distance(world.Foot("a"), world.Foot("b")));
  }
  // they have met, and overlap within the limit of engines only
  CHECK(deepest > -0.005);
  CHECK(deepest <= 0.02 * std::min(RadiusOf(tagA), RadiusOf(tagB)));
}

TEST_CASE("rigid ghosts: a robot that presses against a resting one does not move it",
          "[contract][engine][rigid][partition]") {
  const SSides sides = AnySides();
  CAPTURE(sides.West, sides.East);
  CRigidScene world(sides.ToXml(), FootBotsXml(-0.5, 0.07, 10));
  const CVector3 start = world.Position("b");
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    REQUIRE(Distance(world.Position("a"), world.Position("b")) >= 1.98 * kFootBotRadius);
  }
  CHECK(Distance(world.Position("b"), start) <= 0.02 * kFootBotRadius);
  CHECK(world.EngineOf("a") == "west");
}

TEST_CASE("rigid ghosts: robots placed inside each other are separated, asleep or not",
          "[contract][engine][rigid][partition]") {
  const SSides sides = AnySides();
  CAPTURE(sides.West, sides.East);
  CRigidScene world(sides.ToXml(), FootBotsXml(-0.08, 0.5));
  // long enough for bodies to fall asleep
  world.Step(20);
  // 1 cm deep; a moved body wakes up, but the move does not wake bodies of the other engine
  world.Body("b").MoveTo(CVector3(0.08, 0, 0), CQuaternion(), false, true);
  REQUIRE(world.Position("b").GetX() == 0.08);
  world.Step(20);
  CHECK(Distance(world.Position("a"), world.Position("b")) >= 1.98 * kFootBotRadius);
  // each has moved by half of the overlap
  CHECK_THAT(world.Position("a").GetX(), WithinAbs(-kFootBotRadius, 0.02 * kFootBotRadius));
}

TEST_CASE("rigid ghosts: a sleeping robot wakes up when a robot is placed in it",
          "[contract][engine][rigid][partition]") {
  // robots that ODE moves fall asleep; those that roll freely are checked in every tick
  const SSides sides = GENERATE(SSides{kDynamics3D, kDynamics3D}, SSides{kDynamics3D, kDynamics2D});
  CAPTURE(sides.East);
  CRigidScene world(sides.ToXml("free_robots='false'"), FootBotsXml(-0.08, 0.5));
  world.Step(40);
  world.Body("b").MoveTo(CVector3(0.08, 0, 0), CQuaternion(), false, true);
  world.Step(20);
  // each moves by half of the overlap
  CHECK_THAT(world.Position("a").GetX(), WithinAbs(-kFootBotRadius, 0.02 * kFootBotRadius));
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(kFootBotRadius, 0.02 * kFootBotRadius));
}

TEST_CASE("rigid ghosts: a robot that tows a load over a border wakes the object that it pushes",
          "[contract][engine][rigid][partition]") {
  // The object, on a plate, is too high for the plane of the east, and bodies that grips connect
  // stay in their engine until the first of them has crossed the border: so the robot is a ghost
  // when it meets the object.
  constexpr Real kGap = 0.005;
  CGripWorld::SOptions options;
  options.Engine = SSides{kDynamics3D, kDynamics2D}.ToXml();
  constexpr Real kStart = 0.4;
  CGripWorld world(
      LoadXml("load", kStart + kFootBotRadius + kGap + 0.1, 0, 0.1) +
          GripperXml("robot", kStart, 0, 0, "lock='true'") +
          SBoxXml{"plate", CVector3(0.5, 0.5, 0.03), CVector3(-0.57, 0, 0), CVector3(), 0.0}
              .ToXml() +
          SBoxXml{"object", CVector3(0.3, 0.1, 0.1), CVector3(-0.35, 0, 0.03), CVector3(), 0.2}
              .ToXml(),
      options);
  world.Step(2);
  REQUIRE(world.HeldBy("robot") == "load");
  world.Drive("robot", -10, -10);
  const auto isInEast = [&] {
    return world.Body("robot").GetPhysicsModel(size_t(0)).GetEngine().GetId() == "east";
  };
  while (world.Position("load").GetX() > 0.0 && isInEast()) {
    world.Step();
    const Real gap =
        world.Position("robot").GetX() - kFootBotRadius - (world.Position("object").GetX() + 0.15);
    // the object gives way to where the robot was at the start of the tick, 1 cm back
    REQUIRE(gap >= -0.01 - 0.02 * kFootBotRadius);
  }
  CHECK(world.HeldBy("robot") == "load");
  CHECK(world.Position("object").GetX() < -0.35 - 0.05);
}

TEST_CASE("rigid ghosts: a sleeping object at a border is pushed by a robot from the other side",
          "[contract][engine][rigid][partition]") {
  const SEngineType east = GENERATE(kDynamics2D, kDynamics3D);
  CAPTURE(east);
  CRigidScene world(
      SSides{kDynamics3D, east}.ToXml(),
      DriverXml("foot-bot", "a", 0.5, 0, 180, 10, 10) +
          SBoxXml{"b", CVector3(0.1, 0.3, 0.1), CVector3(-0.051, 0, 0), CVector3(), 0.3}.ToXml());
  for (int tick = 0; tick < 120; ++tick) {
    world.Step();
    const Real gap =
        world.Position("a").GetX() - world.Position("b").GetX() - 0.05 - kFootBotRadius;
    // the object stops at the robot's position at the start of the
    // tick: 1 cm, and 2 % of the radius
    REQUIRE(gap >= -0.01 - 0.02 * kFootBotRadius);
  }
  CHECK(world.Position("a").GetX() < -0.5);
  CHECK(world.Position("b").GetX() < world.Position("a").GetX());
}

TEST_CASE("rigid ghosts: a robot that flies over a robot of the other side does not touch it",
          "[contract][engine][rigid][partition]") {
  SFlightExperiment experiment;
  experiment.Engines = SSides{kDynamics3D, kDynamics3D}.ToXml();
  experiment.Arena = EyeBotXml("r", CVector3(-0.6, 0, 0.8)) + EyeBotXml("f", CVector3(0.1, 0, 0));
  CFlightWorld world(experiment);
  const Real top = world.Body("f").GetPhysicsModel(0).GetBoundingBox().MaxCorner.GetZ();
  REQUIRE(top < 0.75);
  world.Places("r").SetAbsolutePosition(CVector3(-0.01, 0, 0.8));
  world.Places("f").SetAbsolutePosition(CVector3(0.1, 0, 0));
  world.Step(100);
  CHECK(Distance(world.Position("r"), CVector3(-0.01, 0, 0.8)) < 1e-3);
  // a robot that descends onto it stops at its top
  world.Places("r").SetAbsolutePosition(CVector3(-0.01, 0, 0.0));
  Real lowest = HUGE_VAL;
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    lowest = std::min(lowest, world.Position("r").GetZ());
  }
  CHECK_THAT(lowest, WithinAbs(top, 5e-3));
}

TEST_CASE("rigid ghosts: without ghosts, and away from borders, nothing changes",
          "[contract][engine][rigid][partition]") {
  // robots that meet 3 m from the border behave equally with and without an engine beyond it
  const std::string robots = DriverXml("foot-bot", "a", -3.5, 0, 0, 10, 10) +
                             DriverXml("foot-bot", "b", -3.0, 0.03, 180, 10, 10) +
                             DriverXml("foot-bot", "far", 5.0, 0, 0, 10, 10);
  CRigidScene with(SSides{kDynamics3D, kDynamics3D}.ToXml(), robots);
  const std::string off = "ghosts='false'";
  CRigidScene without(
      RegionXml(kDynamics3D, "west", {{-20, -20}, {0, -20}, {0, 20}, {-20, 20}}, off) +
          RegionXml(kDynamics3D, "east", {{0, -20}, {20, -20}, {20, 20}, {0, 20}}, off),
      robots);
  for (int tick = 0; tick < 60; ++tick) {
    with.Step();
    without.Step();
    REQUIRE(with.ComputeDigest() == without.ComputeDigest());
  }
}

TEST_CASE("rigid ghosts: equal bit by bit for any number of threads, and after a reset",
          "[contract][engine][rigid][partition]") {
  SExperiment experiment;
  experiment.ArenaSize = "40,40,2";
  experiment.Controllers =
      "<contract_driver id='driver'><actuators><differential_steering implementation='default'/>"
      "</actuators><sensors/></contract_driver>";
  experiment.Engines = SSides{kDynamics2D, kDynamics3D}.ToXml();
  for (int i = 0; i < 24; ++i) {
    const bool isEast = i % 2 == 1;
    experiment.Arena += DriverXml(i % 3 == 0 ? "foot-bot" : "e-puck", "r" + std::to_string(i),
                                  (isEast ? 0.3 : -0.3) + 0.01 * (i % 5), 0.12 * i - 1.5,
                                  isEast ? 180 + 7 * i : 7 * i, 8 + 0.1 * i, 10);
  }
  CTestWorld reference(experiment);
  const std::vector<UInt64> expected = RecordDigests(reference, 100);
  reference.GetSimulator().Reset();
  CHECK(RecordDigests(reference, 100) == expected);
  for (const UInt32 threads : {1U, 4U}) {
    experiment.Threads = threads;
    CTestWorld world(experiment);
    CHECK(RecordDigests(world, 100) == expected);
  }
}

TEST_CASE("rigid ghosts: a tick in steady state allocates nothing",
          "[contract][engine][rigid][partition]") {
  std::string robots =
      SBoxXml{"b", CVector3(0.1, 0.1, 0.1), CVector3(-0.3, 3.1, 0), CVector3(), 0.2}.ToXml();
  for (int i = 0; i < 10; ++i) {
    const std::string id = std::to_string(i);
    robots += DriverXml("foot-bot", "a" + id, -0.4, 0.3 * i, 0, 10, 10) +
              DriverXml("foot-bot", "b" + id, 0.4, 0.3 * i, 180, 10, 10);
  }
  CRigidScene world(SSides{kDynamics3D, kDynamics3D}.ToXml(), robots);
  // both press against each other; later, because their wheels slip, they slide past each other
  world.Step(60);
  CheckAllocatesNothing([&] { world.Step(20); });
}

TEST_CASE("rigid borders: a slightly tilted or raised body is set down on a plane",
          "[contract][engine][rigid][partition]") {
  const Real degrees = GENERATE(0.0, 2.0, 8.0);
  const Real height = GENERATE(0.0, 0.003, 0.009);
  CAPTURE(degrees, height);
  const SSides sides{kDynamics2D, {"dynamics3d", true, true, "<gravity g='0'/>"}};
  CRigidScene world(sides.ToXml(), SBoxXml{"b", CVector3(0.1, 0.1, 0.1), CVector3(0.5, 0, height),
                                           CVector3(30, degrees, 0)}
                                       .ToXml());
  const Real yaw = world.Yaw("b");
  // moved across the border by the test
  world.Body("b").SetOriginPose(CVector3(-0.3, 0, height), world.Orientation("b"));
  world.Step(2);
  CHECK(world.EngineOf("b") == "west");
  CHECK(world.Position("b") == CVector3(-0.3, 0, 0));
  CHECK(world.Tilt("b") < 1e-6);
  CHECK_THAT(world.Yaw("b"), WithinAbs(yaw, 1e-3 + 2e-4 * degrees * degrees));
}

TEST_CASE(
    "rigid borders: a body that no plane accepts stays, is reported, and is transferred later",
    "[contract][engine][rigid][partition]") {
  const SSides sides{kDynamics2D, kDynamics3D};
  CRigidScene world(sides.ToXml(),
                    SBoxXml{"b", CVector3(0.1, 0.1, 0.1), CVector3(0.5, 0, 0)}.ToXml() +
                        SBoxXml{"c", CVector3(0.1, 0.1, 0.3), CVector3(0.5, 1, 0)}.ToXml());
  world.Step();
  TakeLogErr();
  // a body in the air, which falls down, and a body on its side
  REQUIRE(world.Body("b").MoveTo(CVector3(-0.3, 0, 0.5), CQuaternion()));
  REQUIRE(world.Body("c").MoveTo(CVector3(-0.3, 1, 0.05),
                                 CQuaternion(CRadians(0.5 * ARGOS_PI), CVector3::Y)));
  world.Step(2);
  CHECK(world.EngineOf("b") == "east");
  CHECK(world.EngineOf("c") == "east");
  // the warning reports the first one, once
  const std::string told = TakeLogErr();
  CHECK_THAT(told, Contains("\"b\" has left the region of \"east\" at (-0.3,0,0.") &&
                       Contains("the plane of \"west\"") && Contains("within 0.01 m of z = 0 m") &&
                       Contains("less than 10 degrees"));
  CHECK_THAT(told, !Contains("\"c\""));
  world.Step(20);
  CHECK(world.EngineOf("b") == "west");
  CHECK(world.Position("b").GetZ() == 0.0);
  CHECK(world.EngineOf("c") == "east");
  CHECK_THAT(world.Position("c").GetZ(), WithinAbs(0.05, 1e-3));
  CHECK(TakeLogErr().empty());
}

TEST_CASE("rigid borders: a body outside all regions ends the run with its position",
          "[contract][engine][rigid][partition]") {
  CRigidScene world(RegionXml(kDynamics3D, "pen", {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}),
                    DriverXml("foot-bot", "r", 0.9, 0, 0, 10, 10));
  CHECK_THROWS_WITH(world.Step(30), Contains("\"r\"") && Contains("\"pen\"") && Contains("region"));
}

}  // namespace argos::rigid_ghosts_test
