// Robots that push prisms, boxes and rows beside their middles, along walls, into corners and in
// couples: the same places and turns for any number of substeps, in turned and mirrored copies.

#include <argos3/testing/contract/physics_engines/push_scene.h>
#include <argos3/testing/support/polygons.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace argos::askew_pushing_test {

namespace {

/** Where objects are, and by how much the first one has turned. */
struct SEnd {
  std::vector<CVector3> Places;
  Real Turn = 0.0;  // rad
};

using TBuild = void (*)(CPushScene& scene, int variant, bool isWeight);

constexpr int kTicks = 35;

/** A kind of scene with several variants. */
struct SKind {
  std::string Name;
  int NumVariants;
  SFriction Friction;
  UInt32 NumObjects;
  TBuild Build;
};

Real ComputeInradius(int corners, Real radius) {
  return radius * std::cos(std::numbers::pi / corners);
}

// Two foot-bots at arms of 15 and 7 cm on a prism of three to six corners.
void BuildUnequalArms(CPushScene& scene, int variant, bool isWeight) {
  const int corners = 4 + variant;
  constexpr Real kRadius = 0.4;
  scene.AddPrism("o0", 0.0, 0.0, RegularPolygon(corners, kRadius), isWeight ? 1.2 : 3.0,
                 180.0 / corners);
  const Real x = -ComputeInradius(corners, kRadius) - kFootBot.Radius - 0.01;
  scene.AddRobot(kFootBot, "r", x, 0.15, 0.0);
  scene.AddRobot(kFootBot, "s", x, -0.07, 0.0);
}

// A foot-bot pushes a box along a wall and against it, at angles of 10 to 40 degrees.
void BuildBoxAtWall(CPushScene& scene, int variant, bool isWeight) {
  scene.AddBox("wall", 0.3, -0.25, 3.0, 0.2, 0.0);
  scene.AddBox("o0", 0.0, 0.0, 0.2, 0.29, isWeight ? 0.2 : 0.6);
  scene.AddRobot(kFootBot, "r", -0.1 - kFootBot.Radius - 0.02, 0.03, -10.0 - 15.0 * variant);
}

// The same with prisms of three to five corners.
void BuildPrismAtWall(CPushScene& scene, int variant, bool isWeight) {
  scene.AddBox("wall", 0.3, -0.22, 3.0, 0.2, 0.0);
  scene.AddPrism("o0", 0.0, 0.02, RegularPolygon(3 + variant, 0.12), isWeight ? 0.2 : 0.3,
                 20.0 * variant);
  scene.AddRobot(kFootBot, "r", -0.13 - kFootBot.Radius - 0.01, 0.01, -8.0);
}

// A foot-bot pushes a box of 0.5 kg into a corner.
void BuildCorner(CPushScene& scene, int, bool isWeight) {
  scene.AddBox("wall0", 0.45, 0.0, 0.2, 3.0, 0.0);
  scene.AddBox("wall1", 0.0, -0.3, 3.0, 0.2, 0.0);
  scene.AddBox("o0", 0.0, -0.08, 0.15, 0.15, isWeight ? 0.1 : 0.5, 12.0);
  scene.AddRobot(kFootBot, "r", -0.13 - kFootBot.Radius, -0.03, -12.0);
}

// A couple of unequal arms on a bar with pointed ends, of 0.1 to 10 kg.
void BuildCouple(CPushScene& scene, int variant, bool isWeight) {
  scene.AddPrism("o0", 0.0, 0.0,
                 {CVector2(-0.5, -0.06), CVector2(0.5, -0.06), CVector2(0.56, 0.0),
                  CVector2(0.5, 0.06), CVector2(-0.5, 0.06), CVector2(-0.56, 0.0)},
                 isWeight ? 0.4 : 0.1 * std::pow(10.0, variant));
  const SPusher& robot = variant == 1 ? kFootBot : kEPuck;
  const Real beside = 0.06 + robot.Radius + 0.01;
  scene.AddRobot(robot, "r", 0.4, -beside, 90.0);
  scene.AddRobot(robot, "s", -0.35, beside, -90.0);
}

// One to three foot-bots push a row of a prism, a box and a cylinder of 0.01 to 100 kg.
void BuildRow(CPushScene& scene, int variant, bool isWeight) {
  const auto massOf = [&](int i) {
    return isWeight ? 0.05 + 0.05 * i : std::pow(10.0, (3 * i + variant) % 5 - 2.0);
  };
  scene.AddPrism("o0", 0.0, 0.01, RegularPolygon(6, 0.07), massOf(0), 30.0);
  scene.AddBox("o1", 0.15, 0.0, 0.12, 0.2, massOf(1), 3.0 * variant);
  scene.AddCylinder("o2", 0.3, -0.01, 0.06, massOf(2));
  for (int i = 0; i <= variant; ++i) {
    scene.AddRobot(kFootBot, "r" + std::to_string(i), -0.1 - kFootBot.Radius,
                   0.19 * (i - 0.5 * variant), 0.0);
  }
}

const std::vector<SKind> kKinds{{"two robots on a prism", 3, {12.0, 1.0}, 1, BuildUnequalArms},
                                {"a box at a wall", 3, {2.0, 0.2}, 1, BuildBoxAtWall},
                                {"a prism at a wall", 3, {2.0, 0.2}, 1, BuildPrismAtWall},
                                {"a box in a corner", 1, {1.0, 0.1}, 1, BuildCorner},
                                {"a couple", 3, {1.0, 0.4}, 1, BuildCouple},
                                {"a row", 3, {1.0, 0.1}, 3, BuildRow}};

SEnd Push(const SEngineType& engine, const SKind& kind, int variant, UInt32 iterations,
          Real degrees, bool isMirrored) {
  CPushScene scene(degrees, isMirrored);
  const bool isWeight = engine.Ground == EGround::Weight;
  kind.Build(scene, variant, isWeight);
  CDriveWorld world(isWeight ? MakePushGround(engine, iterations, 1.0)
                             : MakePushEngine(engine, iterations, kind.Friction),
                    scene.GetArena());
  scene.Shape(world);
  const Real start = scene.TurnOf(world, "o0");
  world.Step(kTicks);
  SEnd end;
  for (UInt32 i = 0; i < kind.NumObjects; ++i) {
    end.Places.push_back(scene.PlaceOf(world, "o" + std::to_string(i)));
  }
  const Real turn = std::remainder(scene.TurnOf(world, "o0") - start, 2.0 * std::numbers::pi);
  end.Turn = isMirrored ? -turn : turn;
  return end;
}

}  // namespace

TEST_CASE("askew pushing: prisms, walls, corners, couples and rows over substeps and copies",
          "[contract][engine]") {
  const SEngineType engine =
      GENERATE(from_range(std::vector<SEngineType>{kDynamics2D, kKinematics2D, kDynamics3D}));
  const SKind kind = GENERATE(from_range(kKinds));
  CAPTURE(engine, kind.Name);
  for (int variant = 0; variant < kind.NumVariants; ++variant) {
    const SEnd exact = Push(engine, kind, variant, 50, 0.0, false);
    for (const UInt32 iterations : {0U, 1U, 2U, 5U, 10U}) {
      if (kHasAddressSanitizer && iterations > 1) {
        continue;  // more of the same code, slowly
      }
      const bool isCopy = iterations % 2 == 0;
      CAPTURE(variant, iterations);
      const SEnd found = Push(engine, kind, variant, iterations, isCopy ? 63.0 : 201.0, isCopy);
      Real farthest = 0.0;
      for (size_t i = 0; i < found.Places.size(); ++i) {
        farthest = std::max(farthest, Distance(found.Places[i], exact.Places[i]));
      }
      // 3 % of the way of the robots, and the path of a substep, in which the impact may be
      // anywhere
      const Real substep = iterations == 1 && engine.HasMomentum ? kPushSpeed * kPushTick : 0.0;
      CHECK(farthest < 0.03 * kPushSpeed * kPushTick * kTicks + substep);
      if (kind.NumObjects == 1) {
        CHECK(std::abs(found.Turn - exact.Turn) < 0.05);
      }
    }
  }
}

}  // namespace argos::askew_pushing_test
