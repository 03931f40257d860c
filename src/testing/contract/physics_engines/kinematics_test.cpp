// Properties of kinematics2d beyond those of all engines: no overlaps, and pushing.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/closed_form/differential_drive.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/overlap.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/sanitizers.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/random_stream.h>
#include <argos3/plugins/simulator/entities/gripper_equipped_entity.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <utility>
#include <iomanip>
#include <numbers>
#include <sstream>

namespace argos::kinematics_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using testing::IntegrateDifferentialDrive;
using testing::MeasureOverlaps;
using testing::SOverlaps;
using testing::SPose;

namespace {

// m; tolerance for a few roundings of coordinates below 10 m in each of some hundred ticks
constexpr Real kRoundings = 1e-12;

const std::string kEngine = kKinematics2D.ToPromptXml();

std::string WithFriction(const std::string& friction) {
  return kKinematics2D.ToPromptXml("e", "<friction " + friction + "/>");
}

std::string Id(int number) {
  return "r" + std::to_string(number);
}

}  // namespace

TEST_CASE("kinematics: a crowd that covers 60 % of its pen does not overlap",
          "[contract][engine][kinematics]") {
  // 18 x 18 robots in squares with pi r^2 / side^2 = 0.6, each up to 4 % of the side off the centre
  constexpr int kSide = 18;
  const Real spacing = kEPuckRadius * std::sqrt(std::numbers::pi / 0.6);
  const Real half = 0.5 * kSide * spacing;
  std::ostringstream size;
  size << 2.0 * half + 0.2;
  std::string arena = WallXml("n", size.str() + ",0.1,0.2", 0, half + 0.05) +
                      WallXml("s", size.str() + ",0.1,0.2", 0, -half - 0.05) +
                      WallXml("e", "0.1," + size.str() + ",0.2", half + 0.05, 0) +
                      WallXml("w", "0.1," + size.str() + ",0.2", -half - 0.05, 0);
  CRandomStream random(1, "test", "crowd", "places");
  for (int i = 0; i < kSide * kSide; ++i) {
    const Real x = (i % kSide + 0.5) * spacing - half + 0.04 * spacing * random.Uniform(-1, 1);
    const Real y = (i / kSide + 0.5) * spacing - half + 0.04 * spacing * random.Uniform(-1, 1);
    arena += DriverXml("e-puck", Id(i), x, y, random.Uniform(-180, 180), random.Uniform(-5, 13),
                       random.Uniform(-5, 13));
  }
  CDriveWorld world(kEngine, arena);
  SOverlaps overlaps;
  Real farthest = 0.0;
  for (int tick = 0; tick < 300; ++tick) {
    std::vector<CVector3> before;
    for (int i = 0; i < kSide * kSide; ++i) {
      before.push_back(world.Position(Id(i)));
    }
    world.Step();
    for (int i = 0; i < kSide * kSide; ++i) {
      farthest = std::max(farthest, Distance(before[i], world.Position(Id(i))));
    }
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  // the limit is 2 % of the radius; the actual overlap is due to rounding
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 1.0) <= kRoundings / kEPuckRadius);
  CHECK(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= kRoundings / kEPuckRadius);
  // no robot is thrown about: 13 cm/s for 0.1 s
  CHECK(farthest <= 0.013 + kRoundings);
}

TEST_CASE("kinematics: in columns of 40 robots at a wall robots never overlap",
          "[contract][engine][kinematics]") {
  const Real jitter = GENERATE(0.0, 0.002);
  CAPTURE(jitter);
  std::string arena = WallXml("front", "0.1,2,0.5", 1.05, 0) + WallXml("l", "8,0.1,0.5", -2, 0.39) +
                      WallXml("r", "8,0.1,0.5", -2, -0.39);
  CRandomStream random(1, "test", "columns", "places");
  for (int i = 0; i < 320; ++i) {
    arena += DriverXml("e-puck", Id(i), 0.8 - 0.1 * (i / 8) + random.Uniform(-jitter, jitter),
                       0.08 * (i % 8) - 0.28 + random.Uniform(-jitter, jitter), 0, 10, 10);
  }
  CDriveWorld world(kEngine, arena);
  SOverlaps overlaps;
  for (int tick = 0; tick < 300; ++tick) {
    world.Step();
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 1.0) <= kRoundings / kEPuckRadius);
  CHECK(SOverlaps::Quantile(overlaps.WithWalls, 1.0) <= kRoundings / kEPuckRadius);
  if (jitter == 0.0) {
    // columns in line are 40 diameters long
    CHECK_THAT(world.Position(Id(319)).GetX(), WithinAbs(1.0 - kEPuckRadius * 79.0, 1e-6));
  }
}

TEST_CASE("kinematics: a robot slides along a wall with the tangential part of its speed",
          "[contract][engine][kinematics]") {
  const Real angle = GENERATE(10.0, 45.0, 80.0);  // to the wall, degrees
  CAPTURE(angle);
  const Real radians = angle * std::numbers::pi / 180.0;
  CDriveWorld world(kEngine, WallXml("wall", "20,0.2,0.5", 0, 0.1) +
                                 DriverXml("e-puck", "r", -3, -0.1, angle, 10, 10));
  world.Step(61);
  // it touches the wall, whose face is the line y = 0, at its full tangential speed
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(-kEPuckRadius, kRoundings));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(-3.0 + 0.6 * std::cos(radians), 1e-9));
  CHECK_THAT(world.Yaw("r"), WithinAbs(radians, 1e-12));
}

TEST_CASE("kinematics: robots that pass or follow each other closely keep to their arcs",
          "[contract][engine][kinematics]") {
  // they pass with a gap of 1 mm; another robot follows "a" with a gap of 1 mm
  const Real lane = 0.5 * (2.0 * kEPuckRadius + 0.001);
  const Real gap = 2.0 * kEPuckRadius + 0.001;
  CDriveWorld world(kEngine, DriverXml("e-puck", "a", -0.2, lane, 0, 11, 11) +
                                 DriverXml("e-puck", "follower", -0.2 - gap, lane, 0, 11, 11) +
                                 DriverXml("e-puck", "b", 0.2, -lane, 180, 12, 12) +
                                 WallXml("wall", "4,0.1,0.5", 0, lane + kEPuckRadius + 0.051));
  world.Step();
  for (int tick = 1; tick <= 60; ++tick) {
    world.Step();
    REQUIRE_THAT(world.Position("a").GetX(), WithinAbs(-0.2 + 0.011 * tick, kRoundings));
    REQUIRE_THAT(world.Position("follower").GetX(),
                 WithinAbs(-0.2 - gap + 0.011 * tick, kRoundings));
    REQUIRE_THAT(world.Position("b").GetX(), WithinAbs(0.2 - 0.012 * tick, kRoundings));
    REQUIRE_THAT(world.Position("a").GetY(), WithinAbs(lane, kRoundings));
    REQUIRE_THAT(world.Position("b").GetY(), WithinAbs(-lane, kRoundings));
  }
}

TEST_CASE("kinematics: a column of robots in contact starts and drives as one",
          "[contract][engine][kinematics]") {
  std::string arena;
  for (int i = 0; i < 6; ++i) {
    arena += DriverXml("e-puck", Id(i), -2.0 * kEPuckRadius * i, 0, 0, 10, 10);
  }
  CDriveWorld world(kEngine, arena);
  world.Step(21);
  for (int i = 0; i < 6; ++i) {
    CHECK_THAT(world.Position(Id(i)).GetX(), WithinAbs(0.2 - 2.0 * kEPuckRadius * i, kRoundings));
  }
}

TEST_CASE("kinematics: a symmetric world stays symmetric", "[contract][engine][kinematics]") {
  // four crowds meet in the middle; each is the previous one turned by 90 degrees
  std::string arena;
  for (int quarter = 0; quarter < 4; ++quarter) {
    const Real angle = 0.5 * std::numbers::pi * quarter;
    for (int i = 0; i < 12; ++i) {
      const Real x = -0.35 - 0.08 * (i / 4);
      const Real y = 0.085 * (i % 4) - 0.12;
      arena += DriverXml("e-puck", Id(12 * quarter + i), std::cos(angle) * x - std::sin(angle) * y,
                         std::sin(angle) * x + std::cos(angle) * y, 90.0 * quarter, 10, 9.5);
    }
  }
  CDriveWorld world(kEngine, arena);
  // Frictionless discs amplify rounding errors of the quarter turns:
  // they about double in each tick.
  Real worst = 0.0;
  int ticksOfContact = 0;
  while (ticksOfContact < 10) {
    const CVector3 before = world.Position(Id(0));
    world.Step();
    for (int i = 0; i < 12; ++i) {
      const CVector3 first = world.Position(Id(i));
      for (int quarter = 1; quarter < 4; ++quarter) {
        const Real angle = -0.5 * std::numbers::pi * quarter;
        const CVector3 turned = world.Position(Id(12 * quarter + i));
        const Real x = std::cos(angle) * turned.GetX() - std::sin(angle) * turned.GetY();
        const Real y = std::sin(angle) * turned.GetX() + std::cos(angle) * turned.GetY();
        worst = std::max(worst, std::hypot(x - first.GetX(), y - first.GetY()));
      }
    }
    // an unobstructed robot drives 9.75 mm
    const bool isBlocked = Distance(before, world.Position(Id(0))) < 0.009;
    ticksOfContact += isBlocked && before.GetX() > -0.34 ? 1 : 0;
  }
  CHECK(worst <= 1e-9);
}

TEST_CASE("kinematics: a pushed object moves with the robot and stops with it",
          "[contract][engine][kinematics]") {
  const bool isBox = GENERATE(true, false);
  CAPTURE(isBox);
  const std::string object =
      isBox ? BoxXml("o", kFootBotRadius + 0.12, 0)
            : "<cylinder id='o' radius='0.1' height='0.1' movable='true' mass='20'><body "
              "position='0.205036758,0,0'/></cylinder>";
  CDriveWorld world(kEngine, DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) + object);
  world.Step(41);
  // it met the object after 2 cm and pushed it for the other 38 cm
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.4, 1e-6));
  CHECK_THAT(world.Position("o").GetX(), WithinAbs(kFootBotRadius + 0.5, 1e-6));
  CHECK_THAT(world.Position("o").GetY(), WithinAbs(0.0, 1e-9));
  CHECK_THAT(world.Yaw("o"), WithinAbs(0.0, 1e-9));
  const CVector3 before = world.Position("o");
  world.Driver("r").Left = world.Driver("r").Right = 0.0;
  world.Step();
  world.Step(20);
  // the order to stop reaches the wheels in the tick after the next
  CHECK(Distance(world.Position("o"), before) <= 0.01 + 1e-9);
  const CVector3 stopped = world.Position("o");
  world.Step(20);
  CHECK(world.Position("o") == stopped);
}

TEST_CASE("kinematics: an object that resists the drive's force stays",
          "[contract][engine][kinematics]") {
  // a foot-bot pushes with 15 N
  const auto [friction, robots, moves] =
      GENERATE(std::make_tuple(14.0, 1, true), std::make_tuple(15.5, 1, false),
               std::make_tuple(28.0, 2, true), std::make_tuple(31.0, 2, false));
  CAPTURE(friction, robots);
  std::ostringstream attribute;
  attribute << "box_linear_friction='" << friction << "'";
  std::string arena = BoxXml("o", 0.3, 0, 0, "0.2,0.6,0.1");
  for (int i = 0; i < robots; ++i) {
    const Real y = robots == 1 ? 0.0 : 0.2 * i - 0.1;
    arena += DriverXml("foot-bot", Id(i), 0.1, y, 0, 10, 10);
  }
  CDriveWorld world(WithFriction(attribute.str()), arena);
  world.Step(41);
  if (moves) {
    CHECK_THAT(world.Position("o").GetX(), WithinAbs(0.5 + kFootBotRadius + 0.1, 1e-6));
  } else {
    CHECK(world.Position("o") == CVector3(0.3, 0, 0));
    CHECK_THAT(world.Position(Id(0)).GetX(), WithinAbs(0.2 - kFootBotRadius, kRoundings));
  }
}

TEST_CASE("kinematics: robots push others back through an object, but no robot that stands",
          "[contract][engine][kinematics]") {
  // three against two robots that drive or stand; a wall behind these is reached in 4 s
  const bool stand = GENERATE(true, false);
  const bool areBoxes = GENERATE(true, false);
  CAPTURE(stand, areBoxes);
  constexpr Real kHalf = 0.1 + kFootBotRadius;  // m
  std::string arena = BoxXml("o", 0, 0, 0, "0.2,0.8,0.1") +
                      WallXml("wall", "0.2,2,0.5", 0.1 + 2.0 * kFootBotRadius + 0.5, 0);
  for (int i = 0; i < 5; ++i) {
    const Real speed = i >= 3 && stand ? 0.0 : 10.0;
    arena += i < 3
                 ? DriverXml("foot-bot", Id(i), -kHalf - 0.005, 0.25 * (i - 1), 0, speed, speed)
                 : DriverXml("foot-bot", Id(i), kHalf + 0.005, 0.25 * (i - 3.5), 180, speed, speed);
  }
  CDriveWorld world(kEngine, arena);
  for (int i = 0; i < 5 && areBoxes; ++i) {
    world.Reshape(Id(i), SShapeDescription::Box(CVector3(2.0 * kFootBotRadius, 0.15, 0.1)));
  }
  Real last = 0.0;
  for (int tick = 0; tick < 70; ++tick) {
    world.Step();
    const Real x = world.Position("o").GetX();
    for (int i = 0; i < 5; ++i) {
      REQUIRE((i < 3 ? -1.0 : 1.0) * (world.Position(Id(i)).GetX() - x) >= kHalf - 1e-5);
      REQUIRE(world.Position(Id(i)).GetX() <= 0.5 + kFootBotRadius + 1e-5);
    }
    if (!stand && tick >= 10 && tick < 40) {
      REQUIRE_THAT(x - last, WithinAbs(0.01, 3e-4));
    }
    last = x;
  }
  CHECK_THAT(last, WithinAbs(stand ? 0.005 : 0.4, 1e-4));
}

TEST_CASE("kinematics: a box pushed off its centre rotates unless friction holds it",
          "[contract][engine][kinematics]") {
  const bool turns = GENERATE(true, false);
  CDriveWorld world(
      WithFriction(turns ? "box_angular_friction='0.01'" : ""),
      DriverXml("foot-bot", "r", 0, 0.08, 0, 10, 10) + BoxXml("o", kFootBotRadius + 0.1, 0));
  world.Step(21);
  if (turns) {
    // the push is ahead, on its left side: it turns clockwise
    CHECK(world.Yaw("o") < -0.1);
  } else {
    // 1.49 N at 8 cm are less than 1.49 N m
    CHECK_THAT(world.Yaw("o"), WithinAbs(0.0, 2e-6));
    CHECK_THAT(world.Position("o").GetX(), WithinAbs(kFootBotRadius + 0.3, 1e-6));
  }
}

TEST_CASE("kinematics: an object pushes the next one until a wall stops all",
          "[contract][engine][kinematics]") {
  CDriveWorld world(kEngine, DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) + BoxXml("a", 0.3, 0) +
                                 "<cylinder id='b' radius='0.1' height='0.1' movable='true' "
                                 "mass='1'><body position='0.55,0,0'/></cylinder>" +
                                 WallXml("wall", "0.2,2,0.5", 1.1, 0));
  world.Step(31);
  CHECK_THAT(world.Position("b").GetX() - world.Position("a").GetX(), WithinAbs(0.2, 1e-4));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.3, 1e-6));
  world.Step(100);
  // 1e-5 of half the narrowest side per contact
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.9, 1e-5));
  CHECK_THAT(world.Position("a").GetX(), WithinAbs(0.7, 1e-5));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.6 - kFootBotRadius, 1e-5));
  CHECK(world.Position("wall") == CVector3(1.1, 0, 0));
}

TEST_CASE("kinematics: an object that is pushed fast stops at a wall",
          "[contract][engine][kinematics]") {
  // 0.15 m in a tick: more than the radius of the object, to the middle of a gap of 0.25 m
  CDriveWorld world(kEngine, DriverXml("e-puck", "r", -0.3, 0, 0, 150, 150) + BoxXml("box", 0, 0) +
                                 WallXml("wall", "0.2,2,0.5", 0.45, 0));
  for (int tick = 0; tick < 10; ++tick) {
    world.Step();
    CHECK(world.Position("box").GetX() <= 0.25 + 1e-6);
    CHECK(world.Position("r").GetX() <= world.Position("box").GetX() - 0.1 - kEPuckRadius + 1e-5);
  }
  CHECK_THAT(world.Position("box").GetX(), WithinAbs(0.25, 1e-5));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.15 - kEPuckRadius, 1e-5));
}

TEST_CASE("kinematics: robots do not push robots, but pass around them where they can",
          "[contract][engine][kinematics]") {
  const Real offset = GENERATE(0.0, 0.01);
  CDriveWorld world(kEngine, DriverXml("foot-bot", "mover", 0, 0, 0, 10, 10) +
                                 DriverXml("e-puck", "stays", 0.3, offset, 0, 0, 0));
  world.Step(100);
  CHECK(world.Position("stays") == CVector3(0.3, offset, 0));
  if (offset == 0.0) {
    CHECK_THAT(world.Position("mover").GetX(),
               WithinAbs(0.3 - kFootBotRadius - kEPuckRadius, kRoundings));
  } else {
    CHECK(world.Position("mover").GetX() > 0.3);
  }
}

TEST_CASE("kinematics: robots pass neither through each other nor through objects at any speed",
          "[contract][engine][kinematics]") {
  const Real speed = GENERATE(100.0, 2000.0, 1e6);  // cm/s
  const std::string iterations = GENERATE(as<std::string>(), "", "iterations='7'");
  CAPTURE(speed, iterations);
  // in a corridor too narrow for two side by side
  CDriveWorld world(
      kKinematics2D.ToXml("e", iterations),
      DriverXml("e-puck", "a", -1, 0.005, 0, speed, speed) +
          DriverXml("e-puck", "b", 1, -0.005, 180, speed, speed) +
          WallXml("left", "10,0.1,0.2", 0, 0.1) + WallXml("right", "10,0.1,0.2", 0, -0.1) +
          DriverXml("e-puck", "c", -1, 1, 0, speed, speed) +
          BoxXml("box", 0.5, 1, 0, "0.02,0.09,0.1") + WallXml("left_1", "10,0.1,0.2", 0, 1.1) +
          WallXml("right_1", "10,0.1,0.2", 0, 0.9) + WallXml("thin", "0.001,0.1,0.2", 1.5, 1));
  for (int tick = 0; tick < 40; ++tick) {
    world.Step();
    const CVector3 a = world.Position("a");
    const CVector3 b = world.Position("b");
    REQUIRE(Distance(a, b) >= 2.0 * kEPuckRadius - kRoundings);
    REQUIRE(a.GetX() < b.GetX());
    REQUIRE(std::max(std::abs(a.GetY()), std::abs(b.GetY())) <= 0.05 - kEPuckRadius + kRoundings);
    REQUIRE(world.Position("c").GetX() <= 1.5 - 0.0005 - kEPuckRadius + kRoundings);
    REQUIRE(world.Position("box").GetX() <= 1.5 - 0.0005 - 0.01 + 1e-6);
    REQUIRE(world.Position("box").GetX() - world.Position("c").GetX() >=
            kEPuckRadius + 0.01 - 1e-6);
  }
  CHECK(std::abs(world.Position("a").GetX() + world.Position("b").GetX()) <= 1e-9);
  CHECK_THAT(world.Position("box").GetX(), WithinAbs(1.5 - 0.0005 - 0.01, 1e-6));
}

TEST_CASE("kinematics: a box-shaped robot follows its arc, slides, and pushes with its front",
          "[contract][engine][kinematics]") {
  constexpr Real kHalfLength = 0.1;  // m
  CDriveWorld world(kEngine, DriverXml("foot-bot", "free", 3, 3, 30, 9, 10) +
                                 DriverXml("foot-bot", "pusher", 0, 0, 0, 10, 10) +
                                 DriverXml("foot-bot", "slider", -3, -0.2, 5, 10, 10) +
                                 WallXml("wall", "20,0.2,0.5", 0, 0.4, 0) +
                                 "<cylinder id='c' radius='0.05' height='0.1' movable='true' "
                                 "mass='1'><body position='0.3,0,0'/></cylinder>");
  const SShapeDescription box = SShapeDescription::Box(CVector3(2.0 * kHalfLength, 0.15, 0.1));
  for (const char* id : {"free", "pusher", "slider"}) {
    world.Reshape(id, box);
  }
  world.Step();
  const SPose start{3, 3, 30.0 / 180.0 * ARGOS_PI};
  for (int tick = 1; tick <= 100; ++tick) {
    world.Step();
    const SPose exact = IntegrateDifferentialDrive(start, 0.09, 0.10, 0.14, 0.1 * tick);
    REQUIRE_THAT(world.Position("free").GetX(), WithinAbs(exact.X, 1e-9));
    REQUIRE_THAT(world.Position("free").GetY(), WithinAbs(exact.Y, 1e-9));
  }
  CHECK_THAT(world.Position("c").GetX() - world.Position("pusher").GetX(),
             WithinAbs(kHalfLength + 0.05, 1e-5));
  CHECK_THAT(world.Position("pusher").GetX(), WithinAbs(1.0, 1e-3));
  world.Step(400);
  // along the wall, whose face is at 0.3, for at least 30 of the 50 s at 10 cm/s
  CHECK(world.Position("slider").GetY() < 0.3 - 0.075 + 1e-4);
  CHECK(world.Position("slider").GetX() > 0.0);
}

TEST_CASE("kinematics: piled robots separate equally with any number of threads",
          "[contract][engine][kinematics][determinism]") {
  // Piles of four, so that sums of pushes on a robot depend on their order. Threads process runs
  // of 512 robots; the alternating order of piles puts robots of one pile at the start of one
  // run and at the end of another.
  constexpr int kPiles = FewerIfSanitized(2048);
  const Real offsets[4][2] = {{0.012, 0.0}, {0.0013, 0.011}, {-0.01, -0.0071}, {0.003, -0.013}};
  std::string arena;
  for (int i = 0; i < 4 * kPiles; ++i) {
    const int pile = i / kPiles % 2 == 0 ? i % kPiles : kPiles - 1 - i % kPiles;
    const Real x = 0.3 * (pile % 46) - 7.0 + offsets[i / kPiles][0];
    const Real y = 0.3 * (pile / 46) - 7.0 + offsets[i / kPiles][1];
    arena += DriverXml("e-puck", Id(i), x, y, 0, 1, 1);
  }
  const auto run = [&arena](UInt32 threads) {
    CDriveWorld world(kEngine, arena, threads);
    std::vector<UInt64> digests = RecordDigests(world, 5);
    SOverlaps overlaps;
    MeasureOverlaps(world.GetSpace(), overlaps);
    // since the second tick there was room for all
    CHECK(SOverlaps::Quantile(overlaps.WithRobots, 1.0) <= kRoundings / kEPuckRadius);
    return digests;
  };
  const std::vector<UInt64> alone = run(0);
  for (const UInt32 threads : {2U, 4U, 4U}) {
    CAPTURE(threads);
    CHECK(run(threads) == alone);
  }
}

TEST_CASE("kinematics: walls of a region stop robots and objects without overlap",
          "[contract][engine][kinematics]") {
  // a square standing on a corner, 1 m from its centre to each side; robots drive at all of its
  // walls, and a foot-bot pushes a box to one
  const Real speed = GENERATE(10.0, 2000.0);  // cm/s
  CAPTURE(speed);
  const Real corner = std::sqrt(2.0);
  std::ostringstream region;
  region << std::setprecision(17) << "<boundaries><sides>";
  for (int i = 0; i < 4; ++i) {
    region << "<vertex wall='true' point='" << (i % 2 == 0 ? corner * (1 - i) : 0.0) << ','
           << (i % 2 == 1 ? corner * (2 - i) : 0.0) << "'/>";
  }
  std::string arena = DriverXml("foot-bot", "pusher", 0, 0, 45, speed, speed) +
                      BoxXml("box", 0.2, 0.2, 45, "0.1,0.2,0.1");
  for (int i = 0; i < 7; ++i) {
    const Real yaw = 100.0 + 33.0 * i;
    const Real radians = yaw * std::numbers::pi / 180.0;
    arena += DriverXml("e-puck", Id(i), 0.4 * std::cos(radians), 0.4 * std::sin(radians), yaw,
                       speed, speed);
  }
  CDriveWorld world(kKinematics2D.ToXml("e", "", region.str() + "</sides></boundaries>"), arena);
  const auto depth = [](const CVector3& position, Real radius) {
    return (std::abs(position.GetX()) + std::abs(position.GetY())) / std::sqrt(2.0) + radius - 1.0;
  };
  for (int tick = 0; tick < 200; ++tick) {
    world.Step();
    for (int i = 0; i < 7; ++i) {
      REQUIRE(depth(world.Position(Id(i)), kEPuckRadius) <= kRoundings);
    }
    REQUIRE(depth(world.Position("pusher"), kFootBotRadius) <= kRoundings);
  }
  for (int i = 0; i < 7; ++i) {
    CHECK(depth(world.Position(Id(i)), kEPuckRadius) >= -1e-6);
  }
  // 1e-5 of half the narrowest side, plus a rest of the path below the shortest step
  CHECK_THAT(depth(world.Position("box"), 0.05), WithinAbs(0.0, 1e-5));
  if (speed == 10.0) {
    // faster pushers finally slide past the box
    CHECK_THAT(depth(world.Position("pusher"), kFootBotRadius), WithinAbs(-0.1, 2e-5));
  }
}

TEST_CASE("kinematics: bodies and orders that it does not support are refused with a reason",
          "[contract][engine][kinematics][errors]") {
  const std::string box =
      "<box id='b' size='1,1,1' movable='false'><body position='0,0,0.5'/></box>";
  CHECK_NOTHROW(CDriveWorld(kKinematics2D.ToXml("e", "elevation='0.5'"), box));
  CHECK_THROWS_WITH(CDriveWorld(kKinematics2D.ToXml("ground"), box),
                    Contains("\"ground\" has its plane at z = 0 m") &&
                        Contains("body is at z = 0.5 m") && Contains("elevation=\"0.5\""));
  for (const auto& [x, y] :
       {std::pair(1e8, 0.0), std::pair(0.0, 1e8), std::pair(-1e8, 3.0), std::pair(3.0, -1e8)}) {
    CHECK_THROWS_WITH(CDriveWorld(kEngine, DriverXml("e-puck", "r", x, y, 0, 0, 0)),
                      Contains("\"r\" is too large or too far away"));
  }
  CHECK_THROWS_WITH(CDriveWorld(WithFriction("box_linear_friction='-1'"), ""),
                    Contains("\"box_linear_friction\" must be a number >= 0, found -1"));
  CDriveWorld world(kEngine, DriverXml("foot-bot", "holder", 0, 0, 0, 0, 0));
  auto& gripper = dynamic_cast<CGripperEquippedEntity&>(
      world.Get<CComposableEntity>("holder").GetComponent("gripper"));
  world.Step();
  gripper.SetLockState(1.0);
  CHECK_THROWS_WITH(world.Step(), Contains("robot \"holder\" has locked its gripper") &&
                                      Contains("<kinematics2d id=\"e\">") &&
                                      Contains("<dynamics2d>"));
}

TEST_CASE("kinematics: robots of a formation do not slow each other down, however many are near",
          "[contract][engine][kinematics]") {
  // 8 cm apart, and each drives 10 cm in a tick; at most nine neighbours are remembered
  const int numNeighbours = GENERATE(8, 9, 10, 14);
  CAPTURE(numNeighbours);
  constexpr Real kSpeed = 100.0;  // cm/s
  constexpr Real kDistance = 0.2;  // m
  std::string robots = DriverXml("foot-bot", "r", 0.0, 0.0, 0.0, kSpeed, kSpeed);
  for (int i = 0; i < numNeighbours; ++i) {
    const Real angle = 2.0 * std::numbers::pi * i / numNeighbours;
    robots += DriverXml("e-puck", Id(i), kDistance * std::cos(angle), kDistance * std::sin(angle),
                        0.0, kSpeed, kSpeed);
  }
  CDriveWorld world(kEngine, robots);
  // robots of kinematics2d move one tick after the first command
  world.Step(21);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(2.0, kRoundings));
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(0.0, kRoundings));
  for (int i = 0; i < numNeighbours; ++i) {
    CHECK_THAT((world.Position(Id(i)) - world.Position("r")).Length(),
               WithinAbs(kDistance, kRoundings));
  }
}

}  // namespace argos::kinematics_test
