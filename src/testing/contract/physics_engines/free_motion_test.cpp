// A robot without contacts follows the arc of its wheel speeds in every engine.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/closed_form/differential_drive.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

namespace argos::free_motion_test {

using testing::IntegrateDifferentialDrive;
using testing::SPose;

namespace {

struct SRobotType {
  std::string Tag;
  Real InterwheelDistance;  // m
};

// m; the axes of foot-bot and e-puck
const SRobotType kFootBot{"foot-bot", 0.14};
const SRobotType kEPuck{"e-puck", 0.053};

/**
 * Distance of "r" from the exact end of its arc, m.
 * @param left, right  cm/s.
 * @param tick         number of ticks of 0.1 s since it left @p start.
 */
Real ComputeDistanceFromArc(CDriveWorld& world, const SRobotType& robot, const SPose& start,
                            Real left, Real right, Real tick) {
  const SPose exact = IntegrateDifferentialDrive(start, 0.01 * left, 0.01 * right,
                                                 robot.InterwheelDistance, 0.1 * tick);
  const CVector3 position = world.Position("r");
  return std::hypot(position.GetX() - exact.X, position.GetY() - exact.Y);
}

}  // namespace

TEST_CASE("free motion: a robot follows the closed-form arc for 60 s", "[contract][engine]") {
  const SEngineType type = GENERATE(from_range(kEnginesWithWheels));
  // engines with rolling wheels need more than one step per tick
  const UInt32 fewest = type.Slip > 0.0 ? 5 : 1;
  const UInt32 iterations = GENERATE_COPY(UInt32(0), fewest, UInt32(10));
  const std::string engine = type.ToXml(
      "e", iterations > 0 ? "iterations='" + std::to_string(iterations) + "'" : std::string());
  const Real lag = type.GetLag(iterations);
  const SRobotType robot = GENERATE(kFootBot, kEPuck);
  using TSpeeds = std::pair<Real, Real>;  // cm/s
  const auto [left, right] = GENERATE(TSpeeds(10, 10), TSpeeds(10, 9), TSpeeds(3, 12),
                                      TSpeeds(-5, 7.5), TSpeeds(-8, -8), TSpeeds(4, -4));
  const SPose start = GENERATE(SPose{0, 0, 0}, SPose{19.3, -17.1, 2.0});
  CAPTURE(engine, robot.Tag, left, right, start.X);

  CDriveWorld world(engine, DriverXml(robot.Tag, "r", start.X, start.Y,
                                      start.Yaw * 180.0 / std::numbers::pi, left, right));
  // orders of the first tick act from the second on
  world.Step();
  Real worst = 0.0;
  for (int tick = 1; tick <= 600; ++tick) {
    world.Step();
    worst = std::max(worst, ComputeDistanceFromArc(world, robot, start, left, right, tick - lag));
  }
  // Arcs are integrated exactly, so the error is 600 roundings of numbers around 20,
  // 4e-15 each, plus those of the yaw.
  const Real length = 0.01 * std::max(std::abs(left + right) / 2.0, std::abs(right - left)) * 60.0;
  CHECK(worst <= 1e-9 + type.Slip * length);
}

TEST_CASE("free motion: a robot follows its arc with every solver of an engine",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  const std::string solver = GENERATE_COPY(from_range(engine.Solvers));
  const SRobotType robot = GENERATE(kFootBot, kEPuck);
  using TSpeeds = std::pair<Real, Real>;  // cm/s
  const auto [left, right] = GENERATE(TSpeeds(3, 12), TSpeeds(-8, -8), TSpeeds(20, 18));
  CAPTURE(engine, solver, robot.Tag, left, right);
  const SPose start{1.3, -2.1, 2.0};
  CDriveWorld world(engine.ToXml("e", "", solver),
                    DriverXml(robot.Tag, "r", start.X, start.Y,
                              start.Yaw * 180.0 / std::numbers::pi, left, right));
  world.Step();
  Real worst = 0.0;
  for (int tick = 1; tick <= 200; ++tick) {
    world.Step();
    worst = std::max(
        worst, ComputeDistanceFromArc(world, robot, start, left, right, tick - engine.GetLag()));
    REQUIRE(std::abs(world.Position("r").GetZ()) <= engine.Slack);
    // the arc cosine of a number near 1 loses half of the digits
    REQUIRE(world.Tilt("r") <= 1e-6 + 10.0 * engine.Slack);
  }
  CHECK(worst <= 1e-9 + engine.Slip * 0.01 * std::abs(left + right) / 2.0 * 20.0);
}

TEST_CASE("free motion: a robot with resting wheels does not move", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "r", 1.25, -2.5, 30, 0, 0));
  world.Step(100);
  CHECK(Distance(world.Position("r"), CVector3(1.25, -2.5, 0.0)) <= engine.Slack);
}

TEST_CASE("free motion: a robot turning in place keeps its position and an exact heading",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "r", 2, 1, 10, -20, 20));
  world.Step(601);
  // 0.4 m/s over 0.053 m for 60 s: 72 turns; each of 600 ticks rounds twice
  const Real yaw = 10.0 / 180.0 * std::numbers::pi + 0.4 / 0.053 * 0.1 * (600.0 - engine.GetLag());
  CHECK(std::abs(std::remainder(world.Yaw("r") - yaw, 2.0 * std::numbers::pi)) <=
        1e-11 + engine.Slip * 0.4 / 0.053 * 60.0);
  CHECK(Distance(world.Position("r"), CVector3(2, 1, 0)) <= engine.Slack);
}

TEST_CASE("free motion: an object without contacts does not move", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), BoxXml("b", 1, 2, 30, "0.2,0.3,0.1"));
  const CQuaternion orientation = world.Body("b").GetOriginAnchor().Orientation;
  world.Step(20);
  CHECK(Distance(world.Position("b"), CVector3(1, 2, 0)) <= engine.Slack);
  const CQuaternion turn = world.Body("b").GetOriginAnchor().Orientation * orientation.Inverse();
  CHECK(CVector3(turn.GetX(), turn.GetY(), turn.GetZ()).Length() <= 1e-15 + engine.Slack);
}

TEST_CASE("free motion: the acceleration of wheels is limited by the force of the drive",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  if (IsSkipped(engine, engine.HasMomentum, "momentum")) {
    return;
  }
  // 1.5 N on 0.4 kg are 3.75 m/s^2: 0.375 m/s per tick of 0.1 s
  CDriveWorld world(engine.ToXml(), DriverXml("e-puck", "r", 0, 0, 0, 100, 100));
  world.Step();
  Real last = 0.0;
  for (const Real speed : {0.375, 0.75, 1.0, 1.0}) {
    world.Step();
    const Real x = world.Position("r").GetX();
    // the mean speed of a tick is between those at its ends
    CHECK(x - last <= 0.1 * speed + 1e-6 + engine.Slack);
    CHECK(x - last >= 0.1 * (speed - 0.376) - engine.Slack);
    last = x;
  }
}

}  // namespace argos::free_motion_test
