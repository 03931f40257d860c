// Bodies of kinematics2d that begin inside others: how they leave them.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/robot_sizes.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::kinematics_depth_test {

using Catch::Matchers::WithinAbs;

namespace {

// m; tolerance for a few roundings of coordinates below 10 m in each of some hundred ticks
constexpr Real kRoundings = 1e-12;

const std::string kEngine = kKinematics2D.ToPromptXml();

}  // namespace

TEST_CASE("kinematics: a robot deep inside a wall leaves it by at most its radius in a tick",
          "[contract][engine][kinematics]") {
  // its edge is 0.3 m inside
  CDriveWorld world(kEngine, WallXml("wall", "2,4,0.5", 0, 0) +
                                 DriverXml("e-puck", "r", 0.7 + kEPuckRadius, 0, 0, 0, 0));
  const Real start = world.Position("r").GetX();
  for (int tick = 1; tick <= 12; ++tick) {
    world.Step();
    CAPTURE(tick);
    // steps below 1e-6 radii are not followed up
    CHECK_THAT(world.Position("r").GetX() - start,
               WithinAbs(std::min(0.3, tick * kEPuckRadius), 1e-6));
    CHECK_THAT(world.Position("r").GetY(), WithinAbs(0.0, kRoundings));
  }
}

TEST_CASE("kinematics: a robot deep inside a wall leaves it as fast while it drives",
          "[contract][engine][kinematics]") {
  const Real yaw = GENERATE(0.0, 45.0, 90.0, -90.0);
  CAPTURE(yaw);
  // its edge is 0.3 m inside, and it drives 1 mm in a tick
  CDriveWorld world(kEngine, WallXml("wall", "2,4,0.5", 0, 0) +
                                 DriverXml("e-puck", "r", 0.7 + kEPuckRadius, 0, yaw, 1, 1));
  const Real start = world.Position("r").GetX();
  for (int tick = 1; tick <= 8; ++tick) {
    world.Step();
    CAPTURE(tick);
    CHECK_THAT(world.Position("r").GetX() - start, WithinAbs(tick * kEPuckRadius, tick * 1.1e-3));
  }
  world.Step(2);
  CHECK(world.Position("r").GetX() - start >= 0.3 - 1e-6);
}

TEST_CASE("kinematics: a robot deep inside a wall leaves it, whichever way it drives",
          "[contract][engine][kinematics]") {
  // 0.1 m/s into the wall, along it and out of it; its edge is 0.1 m inside
  const Real angle = GENERATE(0.0, 30.0, 90.0, 135.0, 180.0);
  CAPTURE(angle);
  CDriveWorld world(kEngine, WallXml("wall", "2,40,0.5", 1, 0) +
                                 DriverXml("e-puck", "r", 0.1 - kEPuckRadius, 0, angle, 10, 10));
  for (int tick = 1; tick <= 40; ++tick) {
    world.Step();
  }
  const Real speed = std::cos(ToRadians(CDegrees(angle)).GetValue());
  if (speed >= 0.0) {
    CHECK_THAT(world.Position("r").GetX(), WithinAbs(-kEPuckRadius, 1e-5));
  } else {
    CHECK(world.Position("r").GetX() < -kEPuckRadius - 0.2 * std::abs(speed));
  }
}

TEST_CASE("kinematics: robots in each other separate although they drive into each other",
          "[contract][engine][kinematics]") {
  CDriveWorld world(kEngine, DriverXml("e-puck", "a", 0, 0, 0, 10, 10) +
                                 DriverXml("e-puck", "b", 0.04, 0, 180, 10, 10));
  for (int tick = 1; tick <= 10; ++tick) {
    world.Step();
  }
  CHECK_THAT(world.Position("b").GetX() - world.Position("a").GetX(),
             WithinAbs(2.0 * kEPuckRadius, 1e-5));
}

TEST_CASE("kinematics: a robot inside two walls may move by its depth in the deeper one",
          "[contract][engine][kinematics]") {
  // 0.06 m inside of one, 0.002 m of the other: a radius in the first tick, the rest in the second
  const bool deeperFirst = GENERATE(true, false);
  CAPTURE(deeperFirst);
  const std::string deeper = WallXml("deeper", "2,6,0.5", -1, 0);
  const std::string other = WallXml("other", "6,2,0.5", 0, -1);
  CDriveWorld world(
      kEngine, (deeperFirst ? deeper + other : other + deeper) +
                   DriverXml("e-puck", "r", kEPuckRadius - 0.06, kEPuckRadius - 0.002, 0, 0, 0));
  const CVector3 start = world.Position("r");
  world.Step();
  CHECK_THAT(Distance(world.Position("r"), start), WithinAbs(kEPuckRadius, 1e-4));
  world.Step();
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(kEPuckRadius, 1e-4));
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(kEPuckRadius, 1e-4));
}

TEST_CASE("kinematics: an object deep inside another leaves it by a share of its size in a tick",
          "[contract][engine][kinematics]") {
  // a quarter of half of the narrowest side
  constexpr Real kMax = 0.25 * 0.1;  // m
  const bool isWall = GENERATE(true, false);
  CAPTURE(isWall);
  CDriveWorld world(kEngine, (isWall ? WallXml("wall", "0.4,0.4,0.5", 0, 0)
                                     : BoxXml("wall", 0, 0, 0, "0.4,0.4,0.5")) +
                                 BoxXml("box", 0.2, 0, 0, "0.2,0.2,0.5"));
  Real last = 0.2;
  for (int tick = 1; tick <= 6; ++tick) {
    world.Step();
    CAPTURE(tick);
    const Real now = world.Position("box").GetX() - world.Position("wall").GetX();
    // 0.1 m deep at the start; friction gives way by 1e-3
    CHECK_THAT(now - last, WithinAbs(tick <= 4 ? kMax : 0.0, tick < 4 ? 1e-3 : 2e-3));
    last = now;
  }
  CHECK(last >= 0.3 - 1e-5);
  CHECK((world.Position("wall").GetX() == 0.0) == isWall);
}

}  // namespace argos::kinematics_depth_test
