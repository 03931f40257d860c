// Rays hit the bodies of every engine at their current poses.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <catch2/catch.hpp>

namespace argos::physics_engines_rays_test {

using Catch::Matchers::WithinAbs;

namespace {

// tolerance of a few roundings of numbers below 10
constexpr Real kRounding = 1e-14;
constexpr Real kFootBotHeight = 0.146899733;  // m

// the first body hit by a ray of 8 m along x at this height, and its distance, m
struct SHit {
  std::string Id;  // empty: nothing
  Real Distance = -1.0;
};

SHit Look(Real y, Real z) {
  SEmbodiedEntityIntersectionItem item;
  if (!GetClosestEmbodiedEntityIntersectedByRay(item,
                                                CRay3(CVector3(0, y, z), CVector3(8, y, z)))) {
    return {};
  }
  return {item.IntersectedEntity->GetRootEntity().GetId(), 8.0 * item.TOnRay};
}

}  // namespace

TEST_CASE("rays: hit fixed and movable objects, and robots", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(
      engine.ToXml(),
      "<box id='wall' size='0.2,4,0.5' movable='false'><body position='5,0,0'/></box>"
      "<box id='box' size='0.4,0.4,0.3' movable='true' mass='1'><body position='3,1,0'/></box>"
      "<cylinder id='disc' radius='0.5' height='0.3' movable='true' mass='1'><body "
      "position='3,-1,0'/></cylinder>" +
          DriverXml("foot-bot", "robot", 2, 0, 0, 0, 0));
  for (int tick = 0; tick < 2; ++tick) {
    CHECK(Look(0.0, 0.1).Id == "robot");
    CHECK_THAT(Look(0.0, 0.1).Distance, WithinAbs(2 - kFootBotRadius, kRounding + engine.Slack));
    CHECK(Look(0.0, kFootBotHeight + 0.001).Id == "wall");
    CHECK_THAT(Look(0.0, 0.2).Distance, WithinAbs(4.9, kRounding + engine.Slack));
    CHECK(Look(1.1, 0.1).Id == "box");
    CHECK_THAT(Look(1.1, 0.1).Distance, WithinAbs(2.8, kRounding + engine.Slack));
    CHECK(Look(-0.6, 0.1).Id == "disc");
    // 0.4 off the centre of a circle of radius 0.5: a 3-4-5 triangle
    CHECK_THAT(Look(-0.6, 0.1).Distance, WithinAbs(2.7, kRounding + engine.Slack));
    CHECK(Look(0.0, 0.6).Id.empty());
    world.Step();
  }
}

TEST_CASE("rays: follow a robot that drives", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToPromptXml(), DriverXml("foot-bot", "robot", 2, 0, 180, 10, 10));
  world.Step();
  for (int tick = 1; tick <= 20; ++tick) {
    world.Step();
    // one rounding per tick
    CHECK_THAT(Look(0.0, 0.1).Distance,
               WithinAbs(2 - 0.01 * tick - kFootBotRadius, 20 * kRounding + engine.Slack));
  }
  world.GetSimulator().Reset();
  CHECK_THAT(Look(0.0, 0.1).Distance, WithinAbs(2 - kFootBotRadius, kRounding + engine.Slack));
}

TEST_CASE("rays: hit moved bodies at once, and removed bodies no longer", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  const bool movable = GENERATE(true, false);
  CAPTURE(engine, movable);
  CDriveWorld world(engine.ToXml(), std::string("<box id='box' size='0.4,0.2,0.3' movable='") +
                                        (movable ? "true" : "false") +
                                        "' mass='1'><body position='3,0,0'/></box>");
  world.Step();
  REQUIRE_THAT(Look(0.0, 0.1).Distance, WithinAbs(2.8, kRounding + engine.Slack));
  REQUIRE(
      world.Body("box").MoveTo(CVector3(4, 0, 0), CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z)));
  CHECK_THAT(Look(0.0, 0.1).Distance, WithinAbs(3.9, kRounding + engine.Slack));
  world.Step();
  CHECK_THAT(Look(0.0, 0.1).Distance, WithinAbs(3.9, kRounding + engine.Slack));
  world.GetSimulator().GetLoopFunctions().RemoveEntity("box");
  CHECK(Look(0.0, 0.1).Id.empty());
  world.Step();
  CHECK(Look(0.0, 0.1).Id.empty());
}

TEST_CASE("rays: a body in several engines is hit once", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(
      engine.ToTwoXml(1.0) + engine.ToXml("all"),
      "<box id='wall' size='4,0.2,0.5' movable='false'><body position='1,0,0'/></box>");
  // its origin is on the border of two engines, and the third has no borders
  REQUIRE(world.Body("wall").GetPhysicsModelsNum() == 3);
  TEmbodiedEntityIntersectionData hits;
  CHECK(
      GetEmbodiedEntitiesIntersectedByRay(hits, CRay3(CVector3(-5, 0, 0.1), CVector3(5, 0, 0.1))));
  REQUIRE(hits.size() == 1);
  CHECK_THAT(hits[0].TOnRay, WithinAbs(0.4, kRounding + engine.Slack));
}

}  // namespace argos::physics_engines_rays_test
