// Compares the forces of grippers with closed forms.

#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/contract/physics_engines/grip_world.h>
#include <argos3/testing/support/closed_form/differential_drive.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/plugins/robots/e-puck/simulator/epuck_entity.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <memory>

namespace argos::gripping_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using testing::IntegrateDifferentialDrive;
using testing::SPose;

namespace {

constexpr Real kRadius = kFootBotRadius;
constexpr Real kHalf = 0.1;  // m, of a load
constexpr Real kGap = 0.005;  // m: in reach, but without contact
constexpr Real kTick = 0.1;  // s
constexpr Real kFriction = 1.49;  // N, the engine's default
constexpr Real kRigidity = 1e4;  // N/m, the engine's default
// position of a load that the robot at the origin can grip
constexpr Real kAhead = kRadius + kGap + kHalf;

const std::string kSlippery =
    "<dynamics2d id='e'><friction box_linear_friction='0' box_angular_friction='0' "
    "cylinder_linear_friction='0' cylinder_angular_friction='0'/></dynamics2d>";

// the speed along x during a tick, m/s
Real Speed(CGripWorld& world, const std::string& id) {
  const Real before = world.Position(id).GetX();
  world.Step();
  return (world.Position(id).GetX() - before) / kTick;
}

}  // namespace

TEST_CASE(
    "grip: a load moves at the robot's speed, and the grip stretches according to its stiffness",
    "[contract][engine][grip]") {
  const Real mass = GENERATE(0.1, 1.0, 5.0);
  const Real speed = GENERATE(-0.05, 0.05);  // m/s
  const UInt32 ticksPerSecond = GENERATE(10U, 100U);
  CAPTURE(mass, speed, ticksPerSecond);
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, mass),
                   {.TicksPerSecond = ticksPerSecond});
  const CGripGauge gauge = CGripGauge::Grip(world, "r", "box");
  CHECK_THAT(gauge.Stretch(), WithinAbs(0.0, 1e-6));
  world.Drive("r", 100.0 * speed, 100.0 * speed);
  world.Step(4 * ticksPerSecond);
  const CVector3 robot = world.Position("r");
  const CVector3 box = world.Position("box");
  world.Step(2 * ticksPerSecond);
  // single precision errs by 1e-7 m per substep
  CHECK_THAT(world.Position("r").GetX() - robot.GetX(), WithinAbs(2.0 * speed, 1e-4));
  CHECK_THAT(world.Position("box").GetX() - box.GetX(), WithinAbs(2.0 * speed, 1e-4));
  CHECK_THAT(world.Position("box").GetY(), WithinAbs(0.0, 1e-5));
  CHECK_THAT(world.Yaw("box"), WithinAbs(0.0, 1e-4));
  // friction F changes the length of the spring by F / k
  CHECK_THAT(gauge.Stretch(), WithinAbs((speed < 0.0 ? 1.0 : -1.0) * kFriction / kRigidity, 5e-6));
}

TEST_CASE("grip: softer grips stretch more", "[contract][engine][grip]") {
  const Real rigidity = GENERATE(200.0, 1000.0);  // N/m
  CAPTURE(rigidity);
  CGripWorld world(
      GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, 1.0),
      {.Engine = "<dynamics2d id='e' gripping_rigidity='" + std::to_string(rigidity) + "'/>"});
  const CGripGauge gauge = CGripGauge::Grip(world, "r", "box");
  world.Drive("r", -5, -5);
  world.Step(100);
  CHECK_THAT(gauge.Stretch(), WithinRel(kFriction / rigidity, 0.02));
}

TEST_CASE("grip: without stiffness nothing is held", "[contract][engine][grip]") {
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, 1.0),
                   {.Engine = "<dynamics2d id='e' gripping_rigidity='0'/>"});
  world.Drive("r", -5, -5);
  world.Step(20);
  CHECK(world.HeldBy("r").empty());
  CHECK(world.Position("box").GetX() == kAhead);
}

TEST_CASE("grip: unlocking releases the load at once, and friction stops it",
          "[contract][engine][grip]") {
  constexpr Real kMass = 10.0;  // kg
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, kMass));
  world.Drive("r", -10, -10);
  world.Step(40);
  REQUIRE_THAT(Speed(world, "box"), WithinAbs(-0.1, 1e-4));
  world.Driver("r").Lock = false;
  // the order is given in this tick and executed in the next
  CHECK_THAT(Speed(world, "box"), WithinAbs(-0.1, 1e-4));
  REQUIRE(world.HeldBy("r") == "box");
  const Real perTick = kFriction / kMass * kTick;  // m/s
  Real last = Speed(world, "box");
  CHECK(world.HeldBy("r").empty());
  // the first of these ticks starts at 0.1 m/s
  CHECK_THAT(last, WithinAbs(-0.1 + 0.5 * perTick, 2e-5));
  for (int tick = 0; tick < 4; ++tick) {
    const Real speed = Speed(world, "box");
    CHECK_THAT(speed - last, WithinAbs(perTick, 2e-5));
    last = speed;
  }
  world.Step(10);
  CHECK_THAT(Speed(world, "box"), WithinAbs(0.0, 1e-6));
  CHECK_THAT(Speed(world, "r"), WithinAbs(-0.1, 1e-6));
}

TEST_CASE("grip: a load without friction keeps its momentum when it is released",
          "[contract][engine][grip]") {
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + RollXml("roll", kAhead, 0, 2.0),
                   {.Engine = kSlippery});
  world.Drive("r", 10, 10);
  world.Step(40);
  REQUIRE(world.HeldBy("r") == "roll");
  const Real held = Speed(world, "roll");
  CHECK_THAT(held, WithinAbs(0.1, 1e-4));
  world.Driver("r").Lock = false;
  world.Step();
  world.Drive("r", 0, 0);
  world.Step(2);
  for (int tick = 0; tick < 20; ++tick) {
    CHECK_THAT(Speed(world, "roll"), WithinAbs(held, 1e-5));
  }
  CHECK_THAT(Speed(world, "r"), WithinAbs(0.0, 1e-6));
}

TEST_CASE("grip: without a body in reach a locked gripper has no effect",
          "[contract][engine][grip]") {
  // walls, e-pucks and bodies more than 1 cm away cannot be gripped
  const std::string nearby = GENERATE(
      as<std::string>(), "", "e-puck",
      "<box id='x' size='0.2,0.2,0.1' movable='false'><body position='0.19,0,0'/></box>",
      "<box id='x' size='0.2,0.2,0.1' movable='true' mass='1'><body position='0.1965,0,0'/></box>");
  CAPTURE(nearby);
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true' left='-6' right='-5'") +
                   (nearby == "e-puck" ? "" : nearby));
  if (nearby == "e-puck") {
    world.GetSimulator().GetLoopFunctions().AddEntity(
        *std::make_unique<CEPuckEntity>("x", "", CVector3(0.125, 0, 0)).release());
  }
  world.Step();
  for (int tick = 1; tick <= 50; ++tick) {
    world.Step();
    REQUIRE(world.HeldBy("r").empty());
    const Real time = kTick * (tick - kDynamics2D.GetLag());
    const SPose exact = IntegrateDifferentialDrive({}, -0.06, -0.05, 0.14, time);
    REQUIRE_THAT(world.Position("r").GetX(), WithinAbs(exact.X, 1e-9));
    REQUIRE_THAT(world.Position("r").GetY(), WithinAbs(exact.Y, 1e-9));
  }
}

TEST_CASE("grip: only the nearest body in reach is gripped", "[contract][engine][grip]") {
  // two boxes side by side; the one on the right is nearer
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("far", kAhead, 0.104, 1.0) +
                   LoadXml("near", kAhead, -0.102, 1.0));
  world.Step(2);
  CHECK(world.HeldBy("r") == "near");
  world.Drive("r", -5, -5);
  world.Step(20);
  CHECK(world.HeldBy("r") == "near");
  CHECK(world.Position("far").GetX() == kAhead);
  CHECK(world.Position("near").GetX() < kAhead - 0.08);
}

TEST_CASE("grip: of two robots that pull a load apart the stronger one prevails",
          "[contract][engine][grip]") {
  const Real weaker = GENERATE(5.0, 12.0);  // N, against 15 N
  CAPTURE(weaker);
  CGripWorld world(GripperXml("strong", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, 1.0) +
                   GripperXml("weak", 2.0 * kAhead, 0, 180, "lock='true'", weaker));
  const CGripWorld::TPoses start = world.GetPoses();
  world.Step(2);
  REQUIRE(world.HeldBy("strong") == "box");
  REQUIRE(world.HeldBy("weak") == "box");
  const CGripGauge strong(world, "strong", start);
  const CGripGauge weak(world, "weak", start);
  world.Drive("strong", -5, -5);
  world.Drive("weak", -5, -5);
  world.Step(40);
  // at the speed of its wheels, because its force suffices
  CHECK_THAT(Speed(world, "strong"), WithinAbs(-0.05, 1e-4));
  CHECK_THAT(Speed(world, "weak"), WithinAbs(-0.05, 1e-4));
  CHECK_THAT(weak.Stretch(), WithinAbs(weaker / kRigidity, 1e-5));
  CHECK_THAT(strong.Stretch(), WithinAbs((weaker + kFriction) / kRigidity, 1e-5));
}

TEST_CASE("grip: robots of equal strength that pull a load apart hold each other",
          "[contract][engine][grip]") {
  CGripWorld world(GripperXml("a", 0, 0, 0, "lock='true'") + LoadXml("box", kAhead, 0, 1.0) +
                   GripperXml("b", 2.0 * kAhead, 0, 180, "lock='true'"));
  const CGripWorld::TPoses start = world.GetPoses();
  world.Step(2);
  const CGripGauge a(world, "a", start);
  const CGripGauge b(world, "b", start);
  world.Drive("a", -5, -5);
  world.Drive("b", -5, -5);
  world.Step(100);
  // the wheels of both slip with 15 N, and nothing moves
  CHECK_THAT(a.Stretch(), WithinAbs(15.0 / kRigidity, 1e-5));
  CHECK_THAT(b.Stretch(), WithinAbs(15.0 / kRigidity, 1e-5));
  const Real before = world.Position("box").GetX();
  world.Step(100);
  CHECK_THAT(world.Position("box").GetX(), WithinAbs(before, 1e-4));
}

TEST_CASE("grip: a force beyond its strength breaks a grip", "[contract][engine][grip]") {
  // a grip bears 10 kN; the robots pull with twice that
  CGripWorld world(GripperXml("a", 0, 0, 0, "lock='true'", 2e4) + LoadXml("box", kAhead, 0, 1.0) +
                   GripperXml("b", 2.0 * kAhead, 0, 180, "lock='true'", 2e4));
  world.Step(2);
  REQUIRE(world.HeldBy("a") == "box");
  world.Drive("a", -10, -10);
  world.Drive("b", -10, -10);
  Real longest = 0.0;  // m, from a robot's centre to that of the held box
  bool slipped = false;
  for (int tick = 0; tick < 200; ++tick) {
    world.Step();
    for (const std::string id : {"a", "b"}) {
      if (world.HeldBy(id).empty()) {
        slipped = true;
      } else {
        longest = std::max(longest, Distance(world.Position(id), world.Position("box")));
      }
    }
  }
  CHECK(slipped);
  // 10 kN stretch the grip by 1 m; in a tick it may grow by the path of a robot
  CHECK(longest <= kAhead + 1.0 + 0.02);
  CHECK(longest >= kAhead + 0.9);
}

TEST_CASE("grip: a chain of robots pulls with the sum of forces", "[contract][engine][grip]") {
  // each faces the back of the next; the first pulls, the others brake with their full force
  constexpr Real kPitch = 2.0 * kRadius + kGap;
  CGripWorld world(GripperXml("a", 0, 0, 0, "lock='true'") +
                   GripperXml("b", kPitch, 0, 0, "lock='true'", 2.0) +
                   GripperXml("c", 2.0 * kPitch, 0, 0, "lock='true'", 3.0) +
                   LoadXml("box", 2.0 * kPitch + kAhead, 0, 1.0));
  const CGripWorld::TPoses start = world.GetPoses();
  world.Step(2);
  REQUIRE(world.HeldBy("a") == "b");
  REQUIRE(world.HeldBy("b") == "c");
  REQUIRE(world.HeldBy("c") == "box");
  const CGripGauge a(world, "a", start);
  const CGripGauge b(world, "b", start);
  const CGripGauge c(world, "c", start);
  world.Drive("a", -5, -5);
  world.Step(60);
  for (const std::string id : {"a", "b", "c", "box"}) {
    CAPTURE(id);
    CHECK_THAT(Speed(world, id), WithinAbs(-0.05, 1e-4));
  }
  CHECK_THAT(c.Stretch(), WithinAbs(kFriction / kRigidity, 1e-5));
  CHECK_THAT(b.Stretch(), WithinAbs((kFriction + 3.0) / kRigidity, 1e-5));
  CHECK_THAT(a.Stretch(), WithinAbs((kFriction + 3.0 + 2.0) / kRigidity, 1e-5));
}

TEST_CASE("grip: a load held by several robots moves with all of them",
          "[contract][engine][grip]") {
  // there is no room for eight robots around a cylinder of radius 0.1 m: five fit
  constexpr int kRobots = 5;
  std::string arena = RollXml("roll", 0, 0, 1.0);
  for (int i = 0; i < kRobots; ++i) {
    const Real angle = 2.0 * ARGOS_PI * i / kRobots;
    arena += GripperXml("r" + std::to_string(i), kAhead * std::cos(angle), kAhead * std::sin(angle),
                        angle * 180.0 / ARGOS_PI + 180.0, "lock='true'");
  }
  CGripWorld world(arena);
  world.Step(2);
  for (int i = 0; i < kRobots; ++i) {
    REQUIRE(world.HeldBy("r" + std::to_string(i)) == "roll");
  }
  for (int i = 0; i < kRobots; ++i) {
    world.Drive("r" + std::to_string(i), -2, -2);
  }
  world.Step(40);
  // they pull outwards equally: nothing moves
  CHECK_THAT(world.Position("roll").Length(), WithinAbs(0.0, 1e-3));
  // one of them pulls alone
  for (int i = 1; i < kRobots; ++i) {
    world.Driver("r" + std::to_string(i)).Lock = false;
  }
  world.Step(20);
  CHECK_THAT(Speed(world, "roll"), WithinAbs(0.02, 1e-4));
}

}  // namespace argos::gripping_test
