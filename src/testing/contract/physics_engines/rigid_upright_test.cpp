// Upright bodies of dynamics3d that touch others only sideways move in the plane; what tips, climbs
// or is not upright is handed over, without a jump.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/crowd.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_measures.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/dynamics3d_model.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_settings.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>
#include <vector>

namespace argos::rigid_upright_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;
using testing::MeasureOverlaps;
using testing::PressingCrowdText;
using testing::SOverlaps;

namespace {

constexpr Real kRadius = kFootBotRadius;
// N: wheels bear 80 % of 1.6 kg, and push with at most that
constexpr Real kLimit = 0.8 * 1.6 * kSceneGravity;

bool IsUpright(CRigidScene& world, const std::string& id) {
  return dynamic_cast<CDynamics3DModel&>(world.Body(id).GetPhysicsModel(size_t(0))).IsUpright();
}

// a scene, turned about the origin, and mirrored at the x axis before
struct SView {
  Real Degrees = 0.0;
  Real Side = 1.0;  // -1: mirrored

  CVector3 Map(Real x, Real y) const {
    CVector3 place(x, Side * y, 0.0);
    return place.RotateZ(CRadians(Degrees * ARGOS_PI / 180.0));
  }
  CVector3 Unmap(CVector3 place) const {
    place.RotateZ(CRadians(-Degrees * ARGOS_PI / 180.0));
    return CVector3(place.GetX(), Side * place.GetY(), place.GetZ());
  }
  std::string Robot(const std::string& id, Real x, Real y, Real yaw) const {
    const CVector3 place = Map(x, y);
    return DriverXml("foot-bot", id, place.GetX(), place.GetY(), Degrees + Side * yaw, 10, 10);
  }
  std::string Box(const std::string& id, const CVector3& size, Real x, Real y, Real mass) const {
    return SBoxXml{id, size, Map(x, y), CVector3(Degrees, 0, 0), mass}.ToXml();
  }
  Real TurnOf(CRigidScene& world, const std::string& id) const {
    return Side * std::remainder(world.Yaw(id) - Degrees * ARGOS_PI / 180.0, 2.0 * ARGOS_PI);
  }
};

const std::vector<SView> kViews{{0.0, 1.0}, {37.0, 1.0}, {122.0, -1.0}};

std::string PusherName(int i) {
  return "r" + std::to_string(i);
}

// robots side by side that push one box with a share of their limit
std::string PushersXml(const SView& view, int count, Real share) {
  const Real mass = share * count * kLimit / kSceneGravity;
  std::string arena = view.Box("box", CVector3(0.2, 0.2 * count, 0.1), 0.0, 0.0, mass);
  for (int i = 0; i < count; ++i) {
    arena += view.Robot(PusherName(i), -0.1 - kRadius - 0.005, 0.2 * i - 0.1 * (count - 1), 0.0);
  }
  return arena;
}

// robots that press each other and objects in a pen
std::string PenXml() {
  std::string arena;
  for (int i = 0; i < 4; ++i) {
    const SView side{90.0 * i};
    arena += side.Box("wall" + std::to_string(i), CVector3(0.1, 2.0, 0.3), 0.75, 0.0, 0.0);
  }
  for (int i = 0; i < 16; ++i) {
    const Real angle = 2.0 * ARGOS_PI * i / 16;
    arena += DriverXml(i % 2 == 0 ? "foot-bot" : "e-puck", PusherName(i), 0.55 * std::cos(angle),
                       0.55 * std::sin(angle), 180.0 + 360.0 * i / 16, 10, 9 + i % 3);
  }
  arena += SBoxXml{"b", CVector3(0.2, 0.1, 0.1), CVector3(0.1, 0.05, 0), {}, 0.3}.ToXml();
  return arena +
         "<cylinder id='c' radius='0.06' height='0.1' movable='true' mass='0.2'><body "
         "position='-0.15,0,0'/></cylinder>";
}

std::vector<UInt64> RunPen(UInt32 threads) {
  CRigidScene world(GroundedEngine(), PenXml(), threads);
  return RecordDigests(world, 60);
}

}  // namespace

TEST_CASE("rigid upright: robots move a box below their limit at their speed, in all directions",
          "[contract][engine][rigid]") {
  const SView view = GENERATE(from_range(kViews));
  const int count = GENERATE(1, 5, 10);
  CAPTURE(view.Degrees, count);
  CRigidScene world(GroundedEngine(), PushersXml(view, count, 0.6));
  world.Step(30);
  CHECK(IsUpright(world, "box"));
  const Real before = view.Unmap(world.Position("box")).GetX();
  world.Step(20);
  const CVector3 place = view.Unmap(world.Position("box"));
  CHECK_THAT(place.GetX() - before, WithinRel(0.2, 0.03));
  CHECK_THAT(place.GetY(), WithinAbs(0.0, 2e-3));
  CHECK_THAT(view.TurnOf(world, "box"), WithinAbs(0.0, 5e-3));
}

TEST_CASE("rigid upright: robots do not move a box above their limit",
          "[contract][engine][rigid]") {
  const SView view = GENERATE(from_range(kViews));
  const int count = GENERATE(1, 3);
  CAPTURE(view.Degrees, count);
  CRigidScene world(GroundedEngine(), PushersXml(view, count, 1.1));
  world.Step(20);
  const CVector3 before = world.Position("box");
  world.Step(20);
  CHECK(Distance(world.Position("box"), before) < 1e-3);
  // an impact without rebound, then friction less the force of the drives; and the way of a substep
  const Real mass = 1.1 * count * kLimit / kSceneGravity;
  const Real both = 1.6 * count + mass;
  const Real start = 0.1 * 1.6 * count / both;
  const Real way = 0.5 * start * start * both / (0.1 * count * kLimit);
  CHECK_THAT(before.Length(), WithinAbs(way, 5e-4));
}

TEST_CASE("rigid upright: two pairs of equal robots balance over a box",
          "[contract][engine][rigid]") {
  const SView view = GENERATE(from_range(kViews));
  const Real mass = GENERATE(0.05, 0.3, 5.0);
  CAPTURE(view.Degrees, mass);
  const Real beside = 0.1 + 0.005 + kRadius;
  std::string arena = view.Box("box", CVector3(0.2, 0.8, 0.1), 0.0, 0.0, mass);
  for (int i = 0; i < 4; ++i) {
    const Real side = i < 2 ? -1.0 : 1.0;
    arena += view.Robot(PusherName(i), side * beside, 0.3 * (i % 2 - 0.5), i < 2 ? 0.0 : 180.0);
  }
  CRigidScene world(GroundedEngine(), arena);
  world.Step(30);
  const CVector3 before = world.Position("box");
  world.Step(20);
  CHECK(Distance(world.Position("box"), before) < 1e-3);
  CHECK_THAT(view.TurnOf(world, "box"), WithinAbs(0.0, 5e-3));
}

TEST_CASE("rigid upright: what robots squeeze against a wall stays between them",
          "[contract][engine][rigid]") {
  const SView view = GENERATE(from_range(kViews));
  const Real mass = GENERATE(0.05, 0.5, 5.0);
  CAPTURE(view.Degrees, mass);
  constexpr int kRobots = 10;
  std::string arena = view.Box("wall", CVector3(0.2, 3.0, 0.1), 0.2, 0.0, 0.0) +
                      view.Box("box", CVector3(0.2, 2.0, 0.1), 0.0, 0.0, mass);
  for (int i = 0; i < kRobots; ++i) {
    arena += view.Robot(PusherName(i), -0.1 - 0.01 - kRadius, 0.19 * (i - 4.5), 0.0);
  }
  CRigidScene world(GroundedEngine(), arena);
  Real deepest = 0.0;
  for (int tick = 0; tick < 40; ++tick) {
    world.Step();
    const Real box = view.Unmap(world.Position("box")).GetX();
    deepest = std::max(deepest, box);
    for (int i = 0; i < kRobots; ++i) {
      const Real front = view.Unmap(world.Position(PusherName(i))).GetX() + kRadius;
      deepest = std::max(deepest, front - (box - 0.1));
    }
  }
  CHECK(deepest < 0.01 * kRadius);
}

TEST_CASE("rigid upright: a box that is pushed above its middle tips",
          "[contract][engine][rigid]") {
  const SView view = GENERATE(from_range(kViews));
  const bool isPushedHigh = GENERATE(false, true);
  CAPTURE(view.Degrees, isPushedHigh);
  // half its width is less than what friction 1 needs at a height of 0.3 m, and more than at 0.015
  // m
  CRigidScene world(GroundedEngine(), view.Box("box", CVector3(0.15, 0.3, 0.5), 0.0, 0.0, 0.5) +
                                          view.Robot("r0", -0.075 - 0.1 - 0.01, 0.0, 0.0));
  if (isPushedHigh) {
    world.Reshape("r0", SShapeDescription::Box(CVector3(0.2, 0.2, 0.05), CVector3(0.0, 0.0, 0.3)));
  }
  bool wasUpright = false;
  Real height = 0.0;
  Real jump = 0.0;  // m, of its base, in a tick in which it hardly leans
  for (int tick = 0; tick < 60; ++tick) {
    world.Step();
    wasUpright = wasUpright || IsUpright(world, "box");
    const Real now = world.Position("box").GetZ();
    jump = world.Tilt("box") < 0.01 ? std::max(jump, std::abs(now - height)) : jump;
    height = now;
  }
  CHECK(wasUpright);
  CHECK(jump < 1e-3);
  CHECK(IsUpright(world, "box") != isPushedHigh);
  CHECK((world.Tilt("box") > 1.0) == isPushedHigh);
}

TEST_CASE("rigid upright: a robot stands unless its push lifts its front, wherever its mass is",
          "[contract][engine][rigid]") {
  const SView view = GENERATE(from_range(kViews));
  // m, of its centre of mass
  const Real ahead = GENERATE(-0.04, 0.0, 0.04);
  const Real left = GENERATE(-0.02, 0.0, 0.02);
  const bool isHigh = GENERATE(false, true);
  CAPTURE(view.Degrees, ahead, left, isHigh);
  constexpr Real kHalf = 0.1;  // m, of its length
  constexpr Real kWeight = 1.6 * kSceneGravity;  // N
  // where the weight acts between the casters if the push is as high as possible
  const Real caster = kHalf - kCasterRadius * footbot::kWheelRadius;
  const Real behind = (caster - ahead) * (1.0 - std::abs(left) / (caster + std::abs(left)));
  const Real highest = kWeight * (ahead + behind) / kLimit;
  // it touches from the start: an impact would be harder than the push
  CRigidScene world(GroundedEngine(),
                    view.Box("box", CVector3(0.8, 0.4, 0.5), 0.4 + kHalf + ahead, 0.0, 20.0) +
                        view.Robot("r0", 0.0, 0.0, 0.0));
  const CVector3 offset(ahead, view.Side * left, (isHigh ? 1.1 : 0.9) * highest);
  world.Reshape("r0", SShapeDescription::Box(CVector3(2.0 * kHalf, 2.0 * kHalf, 0.05), offset));
  world.Step(20);
  CHECK(IsUpright(world, "r0") != isHigh);
}

TEST_CASE("rigid upright: a robot climbs a ramp, and is upright again behind it",
          "[contract][engine][rigid]") {
  std::string arena = DriverXml("foot-bot", "r0", -0.6, 0, 0, 10, 10) +
                      DriverXml("foot-bot", "near", -0.6, 0.19, 0, 10, 10);
  // a plate of 8 mm, thinner than the clearance of the robot
  arena += SBoxXml{"plate", CVector3(0.4, 1.0, 0.008), CVector3(0, 0, 0), {}, 0.0}.ToXml();
  CRigidScene world(GroundedEngine(), arena);
  bool wasOn = false;
  CVector3 last = world.Position("r0");
  for (int tick = 0; tick < 120; ++tick) {
    world.Step();
    const CVector3 place = world.Position("r0");
    CAPTURE(tick);
    // the speed of the wheels, and no step higher than the plate
    CHECK(std::abs(place.GetX() - last.GetX()) < 0.02);
    CHECK(place.GetZ() > -1e-3);
    CHECK(place.GetZ() < 0.02);
    if (std::abs(place.GetX()) < 0.1) {
      wasOn = true;
      CHECK_FALSE(IsUpright(world, "r0"));
      CHECK_THAT(place.GetZ(), WithinAbs(0.008, 2e-3));
    }
    last = place;
  }
  CHECK(wasOn);
  CHECK(last.GetX() > 0.4);
  CHECK_THAT(last.GetZ(), WithinAbs(0.0, 1e-4));
  CHECK(IsUpright(world, "r0"));
}

TEST_CASE("rigid upright: a box that falls on what robots push is seen",
          "[contract][engine][rigid]") {
  const SView view;
  CRigidScene world(
      GroundedEngine(),
      PushersXml(view, 1, 0.3) +
          SBoxXml{"top", CVector3(0.1, 0.1, 0.1), CVector3(0.05, 0, 0.6), {}, 0.2}.ToXml());
  world.Step(10);
  CHECK_FALSE(IsUpright(world, "top"));
  CHECK_THAT(world.Position("top").GetZ(), WithinAbs(0.1, 2e-3));
  CHECK_FALSE(IsUpright(world, "box"));
  world.Step(20);
  // it rides on the box
  CHECK_THAT(world.Position("top").GetX() - world.Position("box").GetX(), WithinAbs(0.05, 0.02));
  CHECK(world.Position("box").GetX() > 0.1);
}

TEST_CASE("rigid upright: robots that press in a crowd overlap neither walls nor each other",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(), PressingCrowdText(100));
  SOverlaps overlaps;
  for (int tick = 0; tick < 60; ++tick) {
    world.Step();
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  CHECK(SOverlaps::Quantile(overlaps.WithWalls, 1.0) < 0.01);
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) < 0.01);
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 1.0) < 0.02);
}

TEST_CASE("rigid upright: equal bit by bit for any number of threads",
          "[contract][engine][rigid]") {
  const std::vector<UInt64> expected = RunPen(0);
  CHECK(RunPen(1) == expected);
  CHECK(RunPen(4) == expected);
}

}  // namespace argos::rigid_upright_test
