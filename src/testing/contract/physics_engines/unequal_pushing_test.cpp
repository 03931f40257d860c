// Many robots and objects of unequal masses, where few sweeps of a solver are not enough: scenes
// whose answer is 0 or the speed of the robots.

#include <argos3/testing/contract/physics_engines/push_scene.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

namespace argos::unequal_pushing_test {

using Catch::Matchers::WithinAbs;

namespace {

const std::vector<SEngineType> kAllThatPush{kDynamics2D, kKinematics2D, kDynamics3D};

struct SCopy {
  Real Degrees;
  bool IsMirrored;
};
// one that is not turned would be exactly symmetric
const std::vector<SCopy> kCopies{{63.0, true}, {201.0, false}, {90.0, true}};

std::string Number(const std::string& id, UInt32 number) {
  return id + std::to_string(number);
}

// Robots abreast that drive to the right, or left, from x.
void AddRow(CPushScene& scene, const std::string& id, UInt32 count, Real x, bool isToLeft) {
  for (UInt32 i = 0; i < count; ++i) {
    scene.AddRobot(kFootBot, Number(id, i), x, 2.2 * kFootBot.Radius * (i - 0.5 * (count - 1.0)),
                   isToLeft ? 180.0 : 0.0);
  }
}

}  // namespace

TEST_CASE("unequal pushing: ten robots balance over objects of unequal masses, one more moves them",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kAllThatPush));
  const Real heaviest = GENERATE(0.01, 0.1, 1.0);  // kg; others are lighter by factors of 10
  const UInt32 more = GENERATE(0, 1);
  const SCopy copy = GENERATE(from_range(kCopies));
  CAPTURE(engine, heaviest, more, copy.Degrees);
  if (kHasAddressSanitizer && copy.Degrees != 63.0) {
    return;  // more of the same code, slowly
  }
  constexpr UInt32 kRobots = 10;
  constexpr UInt32 kObjects = 3;
  constexpr Real kHalf = 0.08;
  const Real beside = kHalf + 0.004 + kFootBot.Radius;
  CPushScene scene(copy.Degrees, copy.IsMirrored);
  for (UInt32 i = 0; i < kObjects; ++i) {
    scene.AddBox(Number("b", i), 2.0 * kHalf * i, 0.0, 2.0 * kHalf,
                 2.2 * kFootBot.Radius * (kRobots + 1),
                 std::max(0.01, heaviest * std::pow(10.0, -static_cast<Real>(i))));
  }
  AddRow(scene, "l", kRobots, -beside, false);
  AddRow(scene, "r", kRobots + more, 2.0 * kHalf * (kObjects - 1) + beside, true);
  CDriveWorld world(MakePushGround(engine, 0, 1.0), scene.GetArena());
  world.Step(20);
  scene.CheckBalance(world, "b0", 10, more > 0);
  // share of a robot's radius by which it may be in an object
  const Real deepest = engine.HasSlopes ? 0.02 : 0.01;
  for (UInt32 i = 0; i < kRobots; ++i) {
    const Real front = scene.PlaceOf(world, Number("l", i)).GetX() + kFootBot.Radius;
    const Real depth = front - (scene.PlaceOf(world, "b0").GetX() - kHalf);
    CHECK(depth <= deepest * kFootBot.Radius);
  }
}

TEST_CASE("unequal pushing: two and three e-pucks balance over an object, one more moves it",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kAllThatPush));
  const UInt32 iterations = GENERATE(0, 1, 5);
  const Real mass = GENERATE(0.01, 0.05, 0.1);
  const UInt32 robots = GENERATE(2, 3);
  const UInt32 more = GENERATE(0, 1);
  const SCopy copy = GENERATE(from_range(kCopies));
  CAPTURE(engine, iterations, mass, robots, more, copy.Degrees);
  if (kHasAddressSanitizer && copy.Degrees != 63.0) {
    return;  // more of the same code, slowly
  }
  // on wheels, those that are pushed back turn away after three seconds, as their motors cannot
  // hold their heading: see the README of dynamics3d
  const bool turnsAway = more > 0 && !engine.IsPlane;
  const unsigned start = turnsAway ? 6 : 30;
  const unsigned ticks = turnsAway ? 10 : 20;
  constexpr Real kHalf = 0.05;
  const Real beside = kHalf + 0.005 + kEPuck.Radius;
  CPushScene scene(copy.Degrees, copy.IsMirrored);
  scene.AddBox("b", 0.0, 0.0, 2.0 * kHalf, 0.4, mass);
  const auto addRow = [&](const std::string& id, UInt32 count, Real x, Real degrees) {
    for (UInt32 i = 0; i < count; ++i) {
      scene.AddRobot(kEPuck, Number(id, i), x, 0.08 * (i - 0.5 * (count - 1.0)), degrees);
    }
  };
  addRow("l", robots, -beside, 0.0);
  addRow("r", robots + more, beside, 180.0);
  CDriveWorld world(MakePushGround(engine, iterations, mass * kEngineGravity), scene.GetArena());
  world.Step(start);
  scene.CheckBalance(world, "b", ticks, more > 0);
}

TEST_CASE("unequal pushing: a row of light and heavy boxes moves if its friction is overcome",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kAllThatPush));
  const UInt32 robots = GENERATE(1, 3);
  const Real share = GENERATE(0.9, 1.1, 2.0);  // of friction in the force of the drives
  const SCopy copy = GENERATE(from_range(kCopies));
  CAPTURE(engine, robots, share, copy.Degrees);
  if (kHasAddressSanitizer && copy.Degrees != 63.0) {
    return;
  }
  constexpr UInt32 kObjects = 12;
  constexpr Real kHalf = 0.07;
  constexpr Real kGap = 1e-3;
  const bool isWeight = engine.Ground == EGround::Weight;
  const Real force =
      share * robots * (isWeight ? 0.8 * kFootBot.Mass * kEngineGravity : kFootBot.Force);
  // up to a hundred times as heavy as others
  const auto relative = [](UInt32 i) { return std::pow(10.0, 0.33 * (i * 5 % 7)); };
  Real sum = 0.0;
  for (UInt32 i = 0; i < kObjects; ++i) {
    sum += relative(i);
  }
  CPushScene scene(copy.Degrees, copy.IsMirrored);
  AddRow(scene, "r", robots, -kHalf - kGap - kFootBot.Radius, false);
  for (UInt32 i = 0; i < kObjects; ++i) {
    scene.AddBox(Number("b", i), (2.0 * kHalf + kGap) * i, 0.0, 2.0 * kHalf,
                 2.4 * kFootBot.Radius * robots,
                 relative(i) * (isWeight ? force / kEngineGravity / sum : 0.02));
  }
  CDriveWorld world(MakePushGround(engine, 0, force / kObjects), scene.GetArena());
  const std::string last = Number("b", kObjects - 1);
  world.Step(60);
  const Real before = scene.PlaceOf(world, last).GetX();
  world.Step(10);
  const Real way = scene.PlaceOf(world, last).GetX() - before;
  CHECK_THAT(way, WithinAbs(share < 1.0 ? 10 * kPushTick * kPushSpeed : 0.0, 1.5e-3));
}

}  // namespace argos::unequal_pushing_test
