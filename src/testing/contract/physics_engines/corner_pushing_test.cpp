// Two robots push a box or a prism into a corner of two walls, where it turns along both.

#include <argos3/testing/contract/physics_engines/push_scene.h>
#include <argos3/testing/support/polygons.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace argos::corner_pushing_test {

using Catch::Matchers::WithinAbs;

namespace {

struct SStart {
  Real X, Y, Degrees;
};

/** An object and two foot-bots in front of the corner at (0.35, -0.2). */
struct SScene {
  int Corners;  // of a regular prism; 0: a box
  Real SizeX, SizeY;  // m, of a box
  Real Radius;  // m, of the circle around the object
  Real X, Y, Degrees;
  SStart Robots[2];
};

constexpr int kBoxes = 100;

// A random scene: a box or, from that number on, a prism. The robots stand side by side behind it,
// seen from the corner, and drive at different angles.
SScene Draw(int number) {
  std::mt19937 random(static_cast<UInt32>(number % kBoxes));
  const auto draw = [&random](Real low, Real high) {
    return low + (high - low) * (random() / 4294967296.0);
  };
  SScene scene;
  scene.Corners = number < kBoxes ? 0 : 3 + number % 4;
  scene.SizeX = draw(0.1, 0.3);
  scene.SizeY = draw(0.1, 0.3);
  scene.Radius = 0.5 * std::hypot(scene.SizeX, scene.SizeY);
  scene.Y = -0.2 + scene.Radius + draw(0.0, 0.1);
  scene.X = 0.35 - scene.Radius - draw(0.0, 0.15);
  scene.Degrees = draw(0.0, 90.0);
  const Real aim = draw(-60.0, -20.0);
  const Real x = std::cos(aim * std::numbers::pi / 180.0);
  const Real y = std::sin(aim * std::numbers::pi / 180.0);
  const Real behind = scene.Radius + kFootBot.Radius + 0.02;
  for (int i = 0; i < 2; ++i) {
    const Real beside = (i == 0 ? 1.0 : -1.0) * (kFootBot.Radius + 0.003);
    scene.Robots[i] = {scene.X - behind * x - beside * y, scene.Y - behind * y + beside * x,
                       aim + draw(-20.0, 20.0)};
  }
  return scene;
}

struct SEnd {
  CVector3 Object, Robots[2];
  Real Turn;  // rad
};

SEnd Push(const SScene& each, UInt32 iterations, Real degrees, bool isMirrored) {
  CPushScene scene(degrees, isMirrored);
  scene.AddBox("wall0", 0.45, 0.0, 0.2, 3.0, 0.0);
  scene.AddBox("wall1", 0.0, -0.3, 3.0, 0.2, 0.0);
  constexpr Real kMass = 0.5;
  if (each.Corners == 0) {
    scene.AddBox("o", each.X, each.Y, each.SizeX, each.SizeY, kMass, each.Degrees);
  } else {
    scene.AddPrism("o", each.X, each.Y, RegularPolygon(each.Corners, each.Radius), kMass,
                   each.Degrees);
  }
  for (int i = 0; i < 2; ++i) {
    const SStart& start = each.Robots[i];
    scene.AddRobot(kFootBot, "r" + std::to_string(i), start.X, start.Y, start.Degrees);
  }
  CDriveWorld world(MakePushEngine(kKinematics2D, iterations, {1.0, 0.1}), scene.GetArena());
  scene.Shape(world);
  const Real start = scene.TurnOf(world, "o");
  world.Step(60);
  const Real turn = std::remainder(scene.TurnOf(world, "o") - start, 2.0 * std::numbers::pi);
  return {scene.PlaceOf(world, "o"),
          {scene.PlaceOf(world, "r0"), scene.PlaceOf(world, "r1")},
          isMirrored ? -turn : turn};
}

}  // namespace

TEST_CASE("corner pushing: what robots push into a corner does not jam in any number of substeps",
          "[contract][engine]") {
  // Before the engine told corners apart and allowed for their arcs, all of these jammed with one
  // substep, and some with two.
  const int number = GENERATE(3, 7, 9, 11, 18, 39, 51, 54, 101, 105, 112, 117);
  const SScene scene = Draw(number);
  const SEnd exact = Push(scene, 50, 0.0, false);
  for (const UInt32 iterations : {0U, 1U, 2U, 5U, 10U}) {
    if (kHasAddressSanitizer && iterations > 1) {
      continue;  // more of the same code, slowly
    }
    for (const bool isCopy : {false, true}) {
      CAPTURE(number, iterations, isCopy);
      const SEnd found = Push(scene, iterations, isCopy ? 63.0 : 201.0, isCopy);
      // 1 % of the way of the robots
      CHECK(Distance(found.Object, exact.Object) < 0.006);
      CHECK(Distance(found.Robots[0], exact.Robots[0]) < 0.006);
      CHECK(Distance(found.Robots[1], exact.Robots[1]) < 0.006);
      CHECK_THAT(found.Turn, WithinAbs(exact.Turn, 0.02));
    }
  }
}

TEST_CASE("corner pushing: a box that turns past 45 degrees at a wall goes on until it is flat",
          "[contract][engine]") {
  // there, another side of the box turns towards the wall
  const UInt32 iterations = GENERATE(1, 2);
  const bool isCopy = GENERATE(false, true);
  CAPTURE(iterations, isCopy);
  const SScene scene = Draw(8);
  const SEnd end = Push(scene, iterations, isCopy ? 63.0 : 0.0, isCopy);
  const Real yaw = end.Turn + scene.Degrees * std::numbers::pi / 180.0;
  CHECK_THAT(std::remainder(yaw, 0.5 * std::numbers::pi), WithinAbs(0.0, 1e-3));
}

// figures of kinematics2d's README
TEST_CASE("corner pushing: table", "[.][table]") {
  constexpr int kScenes = 200;
  const std::vector<UInt32> substeps{1, 2, 5, 10};
  std::vector<int> numFar(substeps.size(), 0);
  int numSteady = 0;
  for (int number = 0; number < kScenes; ++number) {
    const SScene scene = Draw(number);
    const SEnd exact = Push(scene, 50, 0.0, false);
    const SEnd finer = Push(scene, 100, 0.0, false);
    if (std::max({Distance(exact.Object, finer.Object), Distance(exact.Robots[0], finer.Robots[0]),
                  Distance(exact.Robots[1], finer.Robots[1])}) > 0.005) {
      continue;
    }
    ++numSteady;
    std::ostringstream row;
    for (size_t i = 0; i < substeps.size(); ++i) {
      const Real off = Distance(Push(scene, substeps[i], 0.0, false).Object, exact.Object);
      numFar[i] += off > 0.02 ? 1 : 0;
      row << " " << std::lround(1e3 * off);
    }
    std::printf("%d:%s mm\n", number, row.str().c_str());
  }
  std::printf("of %d scenes, objects off by more than 2 cm with 1, 2, 5, 10 substeps:", numSteady);
  for (const int count : numFar) {
    std::printf(" %d", count);
  }
  std::printf("\n");
}

}  // namespace argos::corner_pushing_test
