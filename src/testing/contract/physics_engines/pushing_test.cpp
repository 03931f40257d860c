// Several contacts decide together: robots that push objects, against closed forms, in copies of
// each scene that are turned and mirrored, and for any number of substeps.

#include <argos3/testing/contract/physics_engines/push_scene.h>
#include <argos3/testing/support/polygons.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace argos::pushing_test {

using Catch::Matchers::WithinAbs;

namespace {

/**
 * The way (m) in a time (s) of an object of a mass (kg) that robots push: after an impact without
 * rebound, the force of the drives less the friction accelerates all, up to the speed of the
 * drives. Without momentum: all or nothing.
 */
Real ComputeWay(const SEngineType& engine, const SPusher& robot, UInt32 count, Real mass,
                Real friction, Real time) {
  const Real force = count * robot.Force;
  if (!engine.HasMomentum) {
    return force > friction ? kPushSpeed * time : 0.0;
  }
  const Real both = count * robot.Mass + mass;
  const Real start = kPushSpeed * count * robot.Mass / both;
  const Real acceleration = (force - friction) / both;
  // until it has the speed of the drives, or stops
  const Real change =
      std::min(time, (acceleration > 0.0 ? kPushSpeed - start : -start) / acceleration);
  const Real end = start + acceleration * change;
  return 0.5 * (start + end) * change + (acceleration > 0.0 ? end * (time - change) : 0.0);
}

// m: the impact may be anywhere in a substep, of which there are 2 or more
Real ImpactError(UInt32 iterations) {
  return kPushSpeed * kPushTick / (iterations > 0 ? iterations : 2);
}

const std::vector<SEngineType> kEnginesThatPush{kDynamics2D, kKinematics2D};

constexpr Real kArmOfCouple = 0.4;  // m, from the middle of the bar

// a bar "b", which two foot-bots on opposite sides turn
CPushScene MakeCouple(bool isMirrored) {
  const Real beside = 0.05 + 0.005 + kFootBot.Radius;
  CPushScene scene(0.0, isMirrored);
  scene.AddBox("b", 0.0, 0.0, 1.0, 0.1, 1.0);
  scene.AddRobot(kFootBot, "r0", kArmOfCouple, -beside, 90.0);
  scene.AddRobot(kFootBot, "r1", -kArmOfCouple, beside, -90.0);
  return scene;
}

}  // namespace

TEST_CASE("pushing: near the limit of one drive, the way of an object is the closed form",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 2, 5, 10, 50);
  const Real mass = GENERATE(0.5, 2.0, 5.0);
  const Real gap = GENERATE(0.02, 0.023, 0.026);  // the phase of the impact in a tick
  CAPTURE(engine, iterations, mass, gap);
  constexpr Real kRadius = 0.1;
  CPushScene scene(0.0, false);
  scene.AddRobot(kEPuck, "r", 0.0, 0.0, 0.0);
  const Real start = kEPuck.Radius + gap + kRadius;
  scene.AddCylinder("c", start, 0.0, kRadius, mass);
  const SFriction friction = {1.49, 1.49};
  CDriveWorld world(MakePushEngine(engine, iterations, friction), scene.GetArena());
  world.Step(100);
  const Real way =
      ComputeWay(engine, kEPuck, 1, mass, friction.Force, 100 * kPushTick - gap / kPushSpeed);
  CHECK_THAT(world.Position("c").GetX() - start, WithinAbs(way, 0.02 * way));
}

TEST_CASE("pushing: several robots move what their forces together move", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5, 10);
  const UInt32 count = GENERATE(1, 2, 3, 10);
  const Real share = GENERATE(0.5, 0.9, 1.1, 2.0, 1e6);  // of friction in the force of the drives
  const Real mass = GENERATE(0.01, 1.0, 1000.0);
  const Real degrees = GENERATE(0.0, 37.0);
  CAPTURE(engine, iterations, count, share, mass, degrees);
  if (kHasAddressSanitizer && (count > 2 || iterations > 1)) {
    return;  // more of the same code, slowly
  }
  constexpr Real kGap = 0.005;
  constexpr Real kHalf = 0.1;
  constexpr Real kDistance = 0.2;  // of robots side by side
  CPushScene scene(degrees, degrees > 0.0);
  for (UInt32 i = 0; i < count; ++i) {
    scene.AddRobot(kFootBot, "r" + std::to_string(i), -kHalf - kGap - kFootBot.Radius,
                   kDistance * (i - 0.5 * (count - 1.0)), 0.0);
  }
  scene.AddBox("b", 0.0, 0.0, 2.0 * kHalf, kDistance * count, mass);
  const Real force = share * count * kFootBot.Force;
  CDriveWorld world(MakePushEngine(engine, iterations, {force, force}), scene.GetArena());
  // the robots drive from the second tick on
  const Real exact =
      ComputeWay(engine, kFootBot, count, mass, force, 49 * kPushTick - kGap / kPushSpeed);
  scene.CheckWay(world, "b", 50, exact, 0.03 * exact + ImpactError(iterations));
}

TEST_CASE("pushing: columns of robots that touch push as each column would alone",
          "[contract][engine]") {
  // together they are one cluster of several strips, which threads solve
  const Real share = GENERATE(0.8, 1.2);  // of friction in the force of the drives of a column
  CAPTURE(share);
  constexpr int kColumns = 40;
  constexpr int kRows = 15;
  constexpr Real kGap = 1e-4;
  constexpr Real kHalf = 0.08;
  constexpr Real kMass = 1.0;
  CPushScene scene(0.0, false);
  for (int column = 0; column < kColumns; ++column) {
    const Real y = (2.0 * kFootBot.Radius + kGap) * (column - 0.5 * kColumns);
    for (int row = 0; row < kRows; ++row) {
      scene.AddRobot(kFootBot, "r" + std::to_string(column) + "_" + std::to_string(row),
                     -kHalf - kGap - kFootBot.Radius - row * (2.0 * kFootBot.Radius + kGap), y,
                     0.0);
    }
    scene.AddBox("b" + std::to_string(column), 0.0, y, 2.0 * kHalf, 2.0 * kHalf, kMass);
  }
  const Real force = share * kRows * kFootBot.Force;
  CDriveWorld world(MakePushEngine(kDynamics2D, 0, {force, force}), scene.GetArena());
  constexpr int kTicks = 20;
  world.Step(kTicks);
  const Real exact = ComputeWay(kDynamics2D, kFootBot, kRows, kMass, force, kTicks * kPushTick);
  for (int column = 0; column < kColumns; ++column) {
    CAPTURE(column);
    const CVector3 way = scene.PlaceOf(world, "b" + std::to_string(column));
    // the impacts of the rows, and the speed of a substep of half a tick
    CHECK_THAT(way.GetX(),
               WithinAbs(exact, 0.03 * exact + kRows * kGap + 0.5 * kPushSpeed * kPushTick));
  }
}

TEST_CASE("pushing: a robot moves as many objects in a row as its force moves",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5);
  const bool isBox = GENERATE(true, false);
  const int count = GENERATE(2, 6, 9);
  const Real share = GENERATE(0.9, 1.1);
  // round objects without friction on each other buckle, unless they are in line to the last digit
  const Real degrees = isBox || engine.HasMomentum ? 122.0 : 0.0;
  CAPTURE(engine, iterations, isBox, count, share, degrees);
  constexpr Real kHalf = 0.1;
  CPushScene scene(degrees, false);
  scene.AddRobot(kFootBot, "r", -kHalf - 0.005 - kFootBot.Radius, 0.0, 0.0);
  for (int i = 0; i < count; ++i) {
    const Real x = 2.02 * kHalf * i;
    if (isBox) {
      scene.AddBox("o" + std::to_string(i), x, 0.0, 2.0 * kHalf, 2.0 * kHalf, 0.5);
    } else {
      scene.AddCylinder("o" + std::to_string(i), x, 0.0, kHalf, 0.5);
    }
  }
  const Real force = share * kFootBot.Force / count;
  CDriveWorld world(MakePushEngine(engine, iterations, {force, force}), scene.GetArena());
  world.Step(60);
  const std::string last = "o" + std::to_string(count - 1);
  const Real before = scene.PlaceOf(world, last).GetX();
  world.Step(20);
  const Real way = scene.PlaceOf(world, last).GetX() - before;
  CHECK_THAT(way, WithinAbs(share < 1.0 ? 20 * kPushTick * kPushSpeed : 0.0, 2e-3));
}

TEST_CASE("pushing: couples turn nothing that friction holds", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5, 10);
  const bool isMirrored = GENERATE(false, true);
  const Real torque = GENERATE(15.0, 1e6);  // N m; the couple is 12 N m
  CAPTURE(engine, iterations, isMirrored, torque);
  const CPushScene scene = MakeCouple(isMirrored);
  CDriveWorld world(MakePushEngine(engine, iterations, {1.49, torque}), scene.GetArena());
  world.Step(60);
  // the robots' momentum at the impact turns it a little
  CHECK_THAT(scene.TurnOf(world, "b"), WithinAbs(0.0, torque > 1e3 ? 1e-4 : 0.03));
  CHECK_THAT(scene.PlaceOf(world, "b").Length(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("pushing: a couple turns what friction does not hold, at the speed of its robots",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5);
  const bool isMirrored = GENERATE(false, true);
  CAPTURE(engine, iterations, isMirrored);
  const CPushScene scene = MakeCouple(isMirrored);
  CDriveWorld world(MakePushEngine(engine, iterations, {1.49, 1.49}), scene.GetArena());
  world.Step(10);
  // the robots, which start beside the bar, have rolled on by 95 mm beside its middle
  const Real turn = (isMirrored ? -1.0 : 1.0) * scene.TurnOf(world, "b");
  CHECK_THAT(turn, WithinAbs(std::atan(0.095 / kArmOfCouple), 0.02));
  CHECK_THAT(scene.PlaceOf(world, "b").Length(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("pushing: what robots squeeze against a wall stays between them", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5);
  const Real mass = GENERATE(0.01, 0.05, 0.5, 50.0);
  CAPTURE(engine, iterations, mass);
  constexpr int kRobots = 10;
  CPushScene scene(0.0, false);
  scene.AddBox("wall", 0.2, 0.0, 0.2, 3.0, 0.0);
  scene.AddBox("b", 0.0, 0.0, 0.2, 2.0, mass);
  for (int i = 0; i < kRobots; ++i) {
    scene.AddRobot(kFootBot, "r" + std::to_string(i), -0.1 - 0.01 - kFootBot.Radius,
                   0.19 * (i - 0.5 * (kRobots - 1)), 0.0);
  }
  CDriveWorld world(MakePushEngine(engine, iterations, {1.49, 1.49}), scene.GetArena());
  Real deepest = 0.0;
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    deepest = std::max(deepest, world.Position("b").GetX());
    for (int i = 0; i < kRobots; ++i) {
      const Real front = world.Position("r" + std::to_string(i)).GetX() + kFootBot.Radius;
      deepest = std::max(deepest, front - (world.Position("b").GetX() - 0.1));
    }
  }
  // 1 % of the radius of a robot
  CHECK(deepest <= 0.01 * kFootBot.Radius);
}

TEST_CASE("pushing: equal robots balance over an object, and one more moves it",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5);
  const Real mass = GENERATE(0.01, 0.3, 5.0);
  const int more = GENERATE(0, 1);
  const bool isMirrored = GENERATE(false, true);
  CAPTURE(engine, iterations, mass, more, isMirrored);
  constexpr int kLeft = 2;
  const Real beside = 0.1 + 0.005 + kFootBot.Radius;
  CPushScene scene(90.0, isMirrored);
  scene.AddBox("b", 0.0, 0.0, 0.2, 0.8, mass);
  for (int i = 0; i < kLeft; ++i) {
    scene.AddRobot(kFootBot, "left" + std::to_string(i), -beside, 0.3 * (i - 0.5), 0.0);
  }
  for (int i = 0; i < kLeft + more; ++i) {
    scene.AddRobot(kFootBot, "right" + std::to_string(i), beside,
                   0.2 * (i - 0.5 * (kLeft + more - 1)), 180.0);
  }
  CDriveWorld world(MakePushEngine(engine, iterations, {1.49, 1.49}), scene.GetArena());
  world.Step(30);
  scene.CheckBalance(world, "b", 20, more > 0);
}

namespace {

// One or three robots push an object against another one, askew.
CPushScene MakeAskew(int number) {
  CPushScene scene(30.0, number % 2 == 1);
  switch (number) {
    case 0:
      scene.AddBox("a", 0.0, 0.031, 0.382, 0.471, 2.8, 13.4);
      scene.AddCylinder("b", 0.418, -0.036, 0.112, 0.02);
      scene.AddRobot(kFootBot, "r", -0.401, 0.0, 7.1);
      break;
    case 1:
      scene.AddBox("a", 0.0, 0.009, 0.201, 0.494, 24.4);
      scene.AddBox("b", 0.378, -0.003, 0.232, 0.498, 0.1, 9.4);
      scene.AddRobot(kFootBot, "r", -0.222, 0.003, -9.8);
      break;
    default:
      scene.AddCylinder("a", 0.0, -0.016, 0.138, 31.0);
      scene.AddBox("b", 0.401, -0.006, 0.24, 0.462, 2.1, -12.3);
      scene.AddRobot(kFootBot, "r", -0.229, -0.179, 5.4);
      scene.AddRobot(kFootBot, "s", -0.249, 0.001, -2.4);
      scene.AddRobot(kFootBot, "t", -0.246, 0.182, 8.8);
  }
  return scene;
}

std::vector<CVector3> FindAskew(const SEngineType& engine, int number, UInt32 iterations) {
  const CPushScene scene = MakeAskew(number);
  CDriveWorld world(MakePushEngine(engine, iterations, {4.0, 0.66}), scene.GetArena());
  world.Step(40);
  return {scene.PlaceOf(world, "a"), scene.PlaceOf(world, "b"), scene.PlaceOf(world, "r")};
}

}  // namespace

TEST_CASE("pushing: an object that turns against another one blocks it in no number of substeps",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const int number = GENERATE(0, 1, 2);
  const std::vector<CVector3> exact = FindAskew(engine, number, 50);
  // both are pushed on
  CHECK(exact[0].GetX() > 0.15);
  CHECK(exact[1].GetX() > 0.45);
  const UInt32 iterations = GENERATE(0, 1, 2, 5);
  CAPTURE(engine, number, iterations);
  const std::vector<CVector3> found = FindAskew(engine, number, iterations);
  for (size_t i = 0; i < exact.size(); ++i) {
    CAPTURE(i, exact[i], found[i]);
    // 5 % of the way of the robots
    CHECK(Distance(found[i], exact[i]) < 0.02);
  }
}

namespace {

// One or two foot-bots push an object beside its middle, which friction lets slide and turn.
CPushScene MakeLever(int number, Real degrees, bool isMirrored) {
  CPushScene scene(degrees, isMirrored);
  switch (number) {
    case 0:
      scene.AddBox("a", 0.0, 0.0, 0.2, 0.5, 1.0);
      scene.AddRobot(kFootBot, "r", -0.2, 0.12, 0.0);
      break;
    case 1:
      scene.AddPrism("a", 0.0, 0.0, RegularPolygon(3, 0.2), 1.0);
      scene.AddRobot(kFootBot, "r", -0.2, 0.09, 0.0);
      break;
    case 2:
      scene.AddPrism("a", 0.0, 0.0, RegularPolygon(5, 0.2), 0.1, 36.0);
      scene.AddRobot(kFootBot, "r", -0.26, -0.1, 0.0);
      break;
    case 3:
      scene.AddPrism("a", 0.0, 0.0, RegularPolygon(6, 0.25), 10.0, 30.0);
      scene.AddRobot(kFootBot, "r", -0.32, 0.11, 0.0);
      break;
    default:
      scene.AddBox("a", 0.0, 0.0, 0.15, 0.6, 0.5, 10.0);
      scene.AddRobot(kFootBot, "r", -0.21, 0.24, 0.0);
      scene.AddRobot(kFootBot, "s", -0.18, -0.08, 5.0);
  }
  return scene;
}

// place and turn
std::pair<CVector3, Real> PushLever(const SEngineType& engine, int number, UInt32 iterations,
                                    Real degrees, bool isMirrored) {
  const CPushScene scene = MakeLever(number, degrees, isMirrored);
  CDriveWorld world(MakePushEngine(engine, iterations, {4.0, 0.3}), scene.GetArena());
  scene.Shape(world);
  const Real start = scene.TurnOf(world, "a");
  world.Step(35);
  const Real turn = std::remainder(scene.TurnOf(world, "a") - start, 2.0 * std::numbers::pi);
  return {scene.PlaceOf(world, "a"), isMirrored ? -turn : turn};
}

}  // namespace

TEST_CASE("pushing: what is pushed beside its middle turns alike in any number of substeps",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const int number = GENERATE(0, 1, 2, 3, 4);
  const auto [exact, exactTurn] = PushLever(engine, number, 50, 0.0, false);
  CHECK(exact.Length() > 0.08);
  const UInt32 iterations = GENERATE(0, 1, 2, 5, 10);
  const bool isCopy = GENERATE(false, true);
  CAPTURE(engine, number, iterations, isCopy);
  const auto [place, turn] = PushLever(engine, number, iterations, isCopy ? 63.0 : 0.0, isCopy);
  CAPTURE(place, exact);
  // 2 % of the way of the robots
  CHECK(Distance(place, exact) < 0.007);
  CHECK_THAT(turn, WithinAbs(exactTurn, 0.035));
}

TEST_CASE("pushing: a light box at a wall is not shot aside", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5);
  const Real aside = GENERATE(0.0, 0.01, -0.02);  // of the box from the path of the robot, m
  CAPTURE(engine, iterations, aside);
  CPushScene scene(0.0, false);
  scene.AddBox("wall", 0.2, 0.0, 0.2, 1.0, 0.0);
  scene.AddBox("b", 0.05, aside, 0.1, 0.1, 0.01);
  scene.AddRobot(kFootBot, "r", -0.02 - kFootBot.Radius, 0.0, 0.0);
  CDriveWorld world(MakePushEngine(engine, iterations, {1.49, 1.49}), scene.GetArena());
  world.Step(50);
  CHECK_THAT(world.Position("b").GetY(), WithinAbs(aside, 1e-3));
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.05, 1e-3));
}

namespace {

// A copy of a scene.
struct SCopy {
  Real Degrees;
  bool IsMirrored;
};
const std::vector<SCopy> kCopies{{0.0, false}, {0.0, true}, {37.0, false}, {122.0, true}};

const std::vector<SEngineType> kAllThatPush{kDynamics2D, kKinematics2D, kDynamics3D};

}  // namespace

TEST_CASE("pushing: robots move a prism by what their forces together move", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kAllThatPush));
  const UInt32 iterations = GENERATE(0, 5);
  const UInt32 count = GENERATE(1, 3);
  const Real share = GENERATE(0.5, 0.9, 1.1, 2.0);  // of friction in the force of the drives
  const SCopy copy = GENERATE(from_range(kCopies));
  CAPTURE(engine, iterations, count, share, copy.Degrees, copy.IsMirrored);
  SPusher robot = kFootBot;
  if (engine.Ground == EGround::Weight) {
    robot.Force = 0.8 * kFootBot.Mass * kEngineGravity;  // what its wheels bear
  }
  constexpr Real kGap = 0.005;
  const Real half = 0.1 * count;
  CPushScene scene(copy.Degrees, copy.IsMirrored);
  for (UInt32 i = 0; i < count; ++i) {
    scene.AddRobot(robot, "r" + std::to_string(i), -0.1 - kGap - robot.Radius,
                   0.2 * (i - 0.5 * (count - 1.0)), 0.0);
  }
  const Real force = share * count * robot.Force;
  const Real mass = engine.Ground == EGround::Weight ? force / kEngineGravity : 1.0;
  // a house that lies on its side
  scene.AddPrism("p", 0.0, 0.0,
                 {CVector2(-0.1, -half), CVector2(0.1, -half), CVector2(0.1 + 0.5 * half, 0.0),
                  CVector2(0.1, half), CVector2(-0.1, half)},
                 mass);
  CDriveWorld world(MakePushGround(engine, iterations, force), scene.GetArena());
  scene.Shape(world);
  const Real exact =
      ComputeWay(engine, robot, count, mass, force, 50 * kPushTick - kGap / kPushSpeed);
  scene.CheckWay(world, "p", 50, exact, 0.03 * exact + ImpactError(iterations));
}

TEST_CASE("pushing: robots in line turn no box that they push in its middle",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kAllThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5);
  const UInt32 count = GENERATE(1, 2, 3);
  const bool isLight = GENERATE(true, false);
  const SCopy copy = GENERATE(from_range(kCopies));
  CAPTURE(engine, iterations, count, isLight, copy.Degrees);
  // robots do not push each other in kinematics2d
  const Real force = (isLight ? 0.5 : 0.9) * (engine.HasMomentum ? count : 1) * kEPuck.Force;
  constexpr Real kHalf = 0.05;
  CPushScene scene(copy.Degrees, copy.IsMirrored);
  for (UInt32 i = 0; i < count; ++i) {
    scene.AddRobot(kEPuck, "r" + std::to_string(i),
                   -kHalf - 0.007 - kEPuck.Radius - i * (2.0 * kEPuck.Radius + 1e-5), 0.0, 0.0);
  }
  scene.AddBox("b", 0.0, 0.0, 2.0 * kHalf, 2.0 * kHalf, force / kEngineGravity);
  CDriveWorld world(MakePushGround(engine, iterations, force), scene.GetArena());
  world.Step(40);
  CHECK(scene.PlaceOf(world, "b").GetX() > 0.36);
  CHECK_THAT(scene.PlaceOf(world, "b").GetY(), WithinAbs(0.0, 2e-4));
  // mechanics lets every slight turn grow
  CHECK_THAT(scene.TurnOf(world, "b"), WithinAbs(0.0, 2e-3));
}

namespace {

// Three foot-bots push a pile of boxes, cylinders and prisms, of which the places after 4 s follow.
std::vector<CVector3> PushPile(const SEngineType& engine, UInt32 iterations, const SCopy& copy) {
  CPushScene scene(copy.Degrees, copy.IsMirrored);
  for (int i = 0; i < 3; ++i) {
    scene.AddRobot(kFootBot, "r" + std::to_string(i), -0.2, 0.18 * (i - 1), 0.0);
  }
  std::vector<std::string> ids;
  for (int i = 0; i < 9; ++i) {
    const std::string id = ids.emplace_back("o" + std::to_string(i));
    const Real x = 0.13 * (i % 3) + 0.005 * (i * 5 % 7);
    const Real y = 0.13 * (i / 3 - 1) + 0.004 * (i * 3 % 5);
    constexpr Real kMass = 0.15;
    if (i % 3 == 0) {
      scene.AddBox(id, x, y, 0.1, 0.09, kMass, 11.0 * i);
    } else if (i % 3 == 1) {
      scene.AddCylinder(id, x, y, 0.05, kMass);
    } else {
      scene.AddPrism(id, x, y, RegularPolygon(5, 0.055), kMass, 17.0 * i);
    }
  }
  CDriveWorld world(MakePushGround(engine, iterations, 1.49), scene.GetArena());
  scene.Shape(world);
  world.Step(40);
  std::vector<CVector3> places;
  for (const std::string& id : ids) {
    places.push_back(scene.PlaceOf(world, id));
  }
  return places;
}

Real FindFarthest(const std::vector<CVector3>& a, const std::vector<CVector3>& b) {
  Real farthest = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    farthest = std::max(farthest, Distance(a[i], b[i]));
  }
  return farthest;
}

}  // namespace

TEST_CASE("pushing: a pile moves alike in turned and mirrored copies, and over substeps",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kAllThatPush));
  CAPTURE(engine);
  const std::vector<CVector3> exact = PushPile(engine, 50, kCopies[0]);
  for (const UInt32 iterations : {0U, 1U, 5U}) {
    for (const SCopy& copy : kCopies) {
      CAPTURE(iterations, copy.Degrees, copy.IsMirrored);
      // a twelfth of the way of the robots
      CHECK(FindFarthest(PushPile(engine, iterations, copy), exact) < 0.03);
    }
  }
}

TEST_CASE("kinematics2d: robots that touch in a queue advance together in each tick",
          "[contract][engine]") {
  // each waits for the one ahead of it, which moves in the same tick
  std::string queue;
  for (int i = 0; i < 3; ++i) {
    queue += DriverXml("e-puck", "r" + std::to_string(i), -2.0 * kEPuck.Radius * i, 0, 0, 10, 10);
  }
  CDriveWorld world("<kinematics2d id='e' velocity_lag='0'/>", queue);
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    const Real first = world.Position("r0").GetX();
    for (int i = 1; i < 3; ++i) {
      CAPTURE(tick, i);
      // the tolerance of overlaps
      REQUIRE_THAT(world.Position("r" + std::to_string(i)).GetX(),
                   WithinAbs(first - 2.0 * kEPuck.Radius * i, 1e-6));
    }
  }
  CHECK_THAT(world.Position("r0").GetX(), WithinAbs(0.19, 1e-9));
}

}  // namespace argos::pushing_test
