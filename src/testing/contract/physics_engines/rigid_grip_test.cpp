// Grippers and turrets in three dimensions.

#include <argos3/testing/contract/physics_engines/grip_world.h>
#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/sanitizers.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::rigid_grip_test {

using Catch::Matchers::WithinAbs;
using TModes = CCI_FootBotTurretActuator::ETurretModes;

namespace {

// m: centre of a load of 0.2 m x 0.2 m in front of a robot at the origin
constexpr Real kLoadAt = kFootBotRadius + 0.1 + 0.002;

CGripWorld::SOptions Options(UInt32 threads = 0, const std::string& engine = GroundedEngine()) {
  return {engine, 10, threads};
}

void StepUntilHeld(CGripWorld& world) {
  world.Step(3);
  REQUIRE(world.HeldBy("r") == "load");
}

// two engines with a border at x = 0
std::string TwoEngines() {
  const auto part = [](const std::string& id, const std::string& from, const std::string& to) {
    return "<dynamics3d id='" + id +
           "'><floor/><gravity g='9.81'/><boundaries><sides><vertex point='" + from +
           ",-10'/><vertex point='" + to + ",-10'/><vertex point='" + to + ",10'/><vertex point='" +
           from + ",10'/></sides></boundaries></dynamics3d>";
  };
  return part("west", "-10", "0") + part("east", "0", "10");
}

// robots and loads in a row, with random orders
std::string CrowdXml() {
  std::string arena;
  for (int i = 0; i < 6; ++i) {
    arena += GripperXml("r" + std::to_string(i), 0.5 * (i % 3) - 0.5, 0.6 * (i / 3) - 0.3, 60.0 * i,
                        "random='true'");
    arena +=
        LoadXml("l" + std::to_string(i), 0.5 * (i % 3) - 0.3, 0.6 * (i / 3) + 0.0, 0.3, 15.0 * i);
  }
  return arena;
}

}  // namespace

TEST_CASE("rigid grip: a gripped load is dragged along, and stays when the gripper unlocks",
          "[contract][engine][rigid][grip]") {
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("load", kLoadAt, 0, 0.5),
                   Options());
  StepUntilHeld(world);
  world.Drive("r", -10, -10);
  world.Step(30);
  const CVector3 robot = world.Position("r");
  const CVector3 load = world.Position("load");
  CHECK(robot.GetX() < -0.25);
  // It is pulled 8.5 cm above the floor, where friction acts, so the load tilts slightly forward.
  CHECK_THAT(load.GetX() - robot.GetX(), WithinAbs(kLoadAt, 0.015));
  CHECK_THAT(load.GetY() - robot.GetY(), WithinAbs(0.0, 5e-3));
  world.Driver("r").Lock = false;
  world.Step(10);
  CHECK(world.HeldBy("r").empty());
  CHECK_THAT(world.Position("load").GetX(), WithinAbs(load.GetX(), 0.02));
  CHECK(world.Position("r").GetX() < robot.GetX() - 0.08);
}

TEST_CASE("rigid grip: a body too far away or too low is not gripped",
          "[contract][engine][rigid][grip]") {
  CGripWorld world(
      GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("far", kLoadAt + 0.02, 0, 0.5) +
          GripperXml("s", 0, 2, 0, "lock='true'") +
          "<box id='low' size='0.2,0.2,0.05' movable='true' mass='0.5'><body position='0.187,2,0'/>"
          "</box>",
      Options());
  world.Step(5);
  CHECK(world.HeldBy("r").empty());
  CHECK(world.HeldBy("s").empty());
}

TEST_CASE("rigid grip: the turret swings its load around the robot",
          "[contract][engine][rigid][grip]") {
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("load", kLoadAt, 0, 0.3),
                   Options());
  StepUntilHeld(world);
  const CVector3 before = world.Position("load") - world.Position("r");
  world.Driver("r").Mode = TModes::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = 2;
  world.Step(51);
  // 2 turns a minute for 5 s, while the wheels brake the base
  const Real turned = 2.0 * 2.0 * ARGOS_PI / 60.0 * 5.0;
  const CVector3 arm = world.Position("load") - world.Position("r");
  const Real direction = std::atan2(arm.GetY(), arm.GetX());
  CHECK_THAT(world.Turret("r").GetRotation().GetValue(), WithinAbs(turned, 0.03));
  // the load lags slightly because of its friction on the floor
  CHECK_THAT(direction - world.Yaw("r"), WithinAbs(turned, 0.15));
  CHECK_THAT(arm.Length(), WithinAbs(before.Length(), 0.01));
  CHECK(world.HeldBy("r") == "load");
}

TEST_CASE("rigid grip: a turret without a load turns as ordered",
          "[contract][engine][rigid][grip]") {
  CGripWorld world(GripperXml("r", 0, 0, 0, "left='5' right='-5'"), Options());
  world.Driver("r").Mode = TModes::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = 4;
  world.Step(11);
  CHECK_THAT(world.Turret("r").GetRotation().GetValue(),
             WithinAbs(4.0 * 2.0 * ARGOS_PI / 60.0, 1e-9));
}

TEST_CASE("rigid grip: a force beyond its strength breaks a grip",
          "[contract][engine][rigid][grip]") {
  const Real most = GENERATE(0.5, 100.0);  // N
  CAPTURE(most);
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("load", kLoadAt, 0, 0.5),
                   Options());
  CEmbodiedEntity& body = world.Body("r");
  auto description = std::make_shared<SBodyDescription>(*body.GetBodyDescription());
  description->Gripper->MaxForce = most;
  world.GetSpace().RemoveEntityFromPhysicsEngines(body);
  body.SetBodyDescription(std::move(description));
  world.GetSpace().AddEntityToPhysicsEngine(body);
  world.Step(3);
  world.Drive("r", -10, -10);
  world.Step(30);
  // friction holds the load with 5 N
  const Real moved = kLoadAt - world.Position("load").GetX();
  if (most < 1.0) {
    CHECK(moved < 0.1);
    CHECK(world.HeldBy("r").empty());
  } else {
    CHECK(moved > 0.25);
  }
}

TEST_CASE(
    "rigid grip: random orders give equal results after resets and with any number of threads",
    "[contract][engine][rigid][grip]") {
  const std::string engine = GENERATE(GroundedEngine(), TwoEngines());
  CAPTURE(engine);
  CGripWorld world(CrowdXml(), Options(0, engine));
  const std::vector<UInt64> first = RecordDigests(world, 300);
  world.GetSimulator().Reset();
  CHECK(RecordDigests(world, 300) == first);
  CGripWorld threaded(CrowdXml(), Options(4, engine));
  CHECK(RecordDigests(threaded, 300) == first);
}

// Two grips and the touch of two robots share forces along the same line, which must not grow
// without bound.
TEST_CASE("rigid grip: robots that hold each other are not thrown by any commands",
          "[contract][engine][rigid][grip]") {
  constexpr int kPairs = 10;
  constexpr UInt32 kTicksPerCommand = 7;
  std::string arena;
  const auto nameOf = [](int robot) { return "r" + std::to_string(robot); };
  for (int robot = 0; robot < 2 * kPairs; ++robot) {
    const bool isLeft = robot % 2 == 0;
    const Real x = (isLeft ? -1.0 : 1.0) * (kFootBotRadius + 5e-4);
    arena += GripperXml(nameOf(robot), x, robot / 2, isLeft ? 0.0 : 180.0, "lock='true'");
  }
  CGripWorld world(arena, Options());
  world.Step();
  CRandomStream random(1, "test", "pairs", "commands");
  const UInt32 ticks = FewerIfSanitized(300);
  CGripWorld::TPoses before = world.GetPoses();
  UInt32 held = 0;
  Real highest = 0.0;  // m
  Real farthest = 0.0;  // m, of the ways in a tick
  for (UInt32 tick = 0; tick < ticks; ++tick) {
    for (int robot = 0; tick % kTicksPerCommand == 0 && robot < 2 * kPairs; ++robot) {
      CContractGripper& driver = world.Driver(nameOf(robot));
      driver.Left = random.Uniform(-15.0, 15.0);
      driver.Right = random.Uniform(-15.0, 15.0);
      driver.Mode = static_cast<TModes>(random.UniformInteger(UInt64(4)));
      driver.TurretSpeed = static_cast<SInt32>(random.UniformInteger(SInt64(-4), SInt64(4)));
      driver.TurretRotation = CRadians(random.Uniform(-ARGOS_PI, ARGOS_PI));
    }
    world.Step();
    CGripWorld::TPoses after = world.GetPoses();
    for (const auto& [id, pose] : after) {
      farthest = std::max(farthest, Distance(pose.Position, before[id].Position));
      highest = std::max(highest, pose.Position.GetZ());
      held += world.Gripper(id).IsGripping() ? 1 : 0;
    }
    before = std::move(after);
  }
  // only a thrown robot breaks a grip, which bears 10 kN
  CHECK(held == 2 * kPairs * ticks);
  // a drive lifts the edge of a robot at most this far, and no wheel turns at more than 15 cm/s
  CHECK(highest < 0.03);
  CHECK(farthest < 0.05);
}

}  // namespace argos::rigid_grip_test
