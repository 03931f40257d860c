// Robots that roll on their wheels: arcs, slopes, pushing, crowds.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>
#include <argos3/testing/support/closed_form/differential_drive.h>

#include <argos3/core/utility/math/angles.h>
#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace argos {

using Catch::Matchers::WithinAbs;
using testing::IntegrateDifferentialDrive;
using testing::SPose;

namespace {

constexpr Real kFootBotRadius = 0.085036758;  // m

struct SRobotType {
  std::string Tag;
  Real InterwheelDistance;  // m
};

const SRobotType kFootBot{"foot-bot", 0.14};
const SRobotType kEPuck{"e-puck", 0.053};

// a slope about the y axis, rising towards x; its upper face goes through the origin
std::string Slope(Real degrees) {
  const Real angle = degrees * ARGOS_PI / 180.0;
  return SBoxXml{"slope", CVector3(8, 4, 0.2),
                 CVector3(0.2 * std::sin(angle), 0.0, -0.2 * std::cos(angle)),
                 CVector3(0, -degrees, 0), 0.0}
      .ToXml();
}

std::string OnSlope(const std::string& tag, Real degrees, Real left, Real right) {
  std::ostringstream xml;
  xml << "<" << tag << " id='r'><body position='0,0,0' orientation='0," << -degrees
      << ",0'/><controller config='driver'><params left='" << left << "' right='" << right
      << "'/></controller></" << tag << ">";
  return xml.str();
}

// robots that lean a little overlap as discs do
void MeasureOverlaps(CRigidScene& world, int count, std::vector<Real>& overlaps) {
  std::vector<CVector3> places;
  for (int i = 0; i < count; ++i) {
    places.push_back(world.Position("r" + std::to_string(i)));
  }
  for (const CVector3& place : places) {
    Real deepest = 0.0;
    for (const CVector3& other : places) {
      if (&other != &place) {
        deepest = std::max(deepest, 2.0 * kFootBotRadius - Distance(place, other));
      }
    }
    overlaps.push_back(deepest / kFootBotRadius);
  }
}

}  // namespace

TEST_CASE("rigid drive: a free robot is within 2 % of its path's length of the arc for 60 s",
          "[contract][engine][rigid]") {
  const std::string solver = GENERATE("", "<solver stepper='direct'/>");
  const std::string iterations = GENERATE("", "iterations='5'");
  const SRobotType robot = GENERATE(kFootBot, kEPuck);
  using TSpeeds = std::pair<Real, Real>;  // cm/s
  const auto [left, right] = GENERATE(TSpeeds(10, 10), TSpeeds(10, 9), TSpeeds(3, 12),
                                      TSpeeds(-5, 7.5), TSpeeds(-8, -8), TSpeeds(20, 18));
  CAPTURE(solver, iterations, robot.Tag, left, right);
  const SPose start{1.3, -2.1, 2.0};
  CRigidScene world(
      GroundedEngine(iterations, solver),
      DriverXml(robot.Tag, "r", start.X, start.Y, start.Yaw * 180.0 / ARGOS_PI, left, right));
  world.Step();
  Real worst = 0.0;
  for (int tick = 1; tick <= 600; ++tick) {
    world.Step();
    const SPose exact = IntegrateDifferentialDrive(start, 0.01 * left, 0.01 * right,
                                                   robot.InterwheelDistance, 0.1 * tick);
    const CVector3 position = world.Position("r");
    worst = std::max(worst, std::hypot(position.GetX() - exact.X, position.GetY() - exact.Y));
    REQUIRE_THAT(position.GetZ(), WithinAbs(0.0, 1e-3));
  }
  const Real length = 0.01 * std::abs(left + right) / 2.0 * 60.0;
  CHECK(worst <= 0.02 * length);
  CHECK(world.Tilt("r") < 5e-3);
}

TEST_CASE("rigid drive: a robot that spins keeps its place", "[contract][engine][rigid]") {
  const SRobotType robot = GENERATE(kFootBot, kEPuck);
  CAPTURE(robot.Tag);
  CRigidScene world(GroundedEngine(), DriverXml(robot.Tag, "r", 2, 1, 0, -4, 4));
  world.Step(601);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(2.0, 1e-3));
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(1.0, 1e-3));
  // 0.08 m/s over the distance between the wheels
  const Real turned = std::remainder(0.08 / robot.InterwheelDistance * 60.0, 2.0 * ARGOS_PI);
  // 0.1 % of the angle; it is slow to start, too
  CHECK_THAT(std::remainder(world.Yaw("r") - turned, 2.0 * ARGOS_PI),
             WithinAbs(0.0, 0.05 + 0.001 * 0.08 / robot.InterwheelDistance * 60.0));
}

TEST_CASE("rigid drive: without gravity wheels find no hold", "[contract][engine][rigid]") {
  CRigidScene world(RigidEngine("", "<floor/>"), DriverXml("foot-bot", "r", 0, 0, 0, 10, 10));
  CHECK_THAT(TakeLogErr(), Catch::Matchers::Contains("\"e\" has no gravity, so the wheels"));
  world.Step(50);
  // the wheels' start turns the robot a little the other way
  CHECK(world.Position("r").Length() < 0.01);
}

TEST_CASE("rigid drive: a robot drives up a slope, at its wheels' speed",
          "[contract][engine][rigid]") {
  const SRobotType robot = GENERATE(kFootBot, kEPuck);
  const Real degrees = GENERATE(5.0, 15.0);
  const Real speed = GENERATE(10.0, -10.0);  // cm/s
  CAPTURE(robot.Tag, degrees, speed);
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>"),
                    Slope(degrees) + OnSlope(robot.Tag, degrees, speed, speed));
  world.Step(101);
  const Real angle = degrees * ARGOS_PI / 180.0;
  CHECK_THAT(world.Position("r").GetZ(), WithinAbs(0.1 * speed * std::sin(angle), 0.02));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.1 * speed * std::cos(angle), 0.02));
  CHECK_THAT(world.Tilt("r"), WithinAbs(angle, 0.03));
}

TEST_CASE("rigid drive: a robot that brakes stands on a slope, if friction holds it",
          "[contract][engine][rigid]") {
  const SRobotType robot = GENERATE(kFootBot, kEPuck);
  CAPTURE(robot.Tag);
  CRigidScene holds(RigidEngine("", "<gravity g='9.81'/>"),
                    Slope(15.0) + OnSlope(robot.Tag, 15.0, 0, 0));
  holds.Step(100);
  CHECK(holds.Position("r").Length() < 2e-3);
  // casters do not hold: the wheels, with part of the weight, would need tan(15 deg) and more
  CRigidScene slides(RigidEngine("default_friction='0.4'", "<gravity g='9.81'/>"),
                     Slope(15.0) + OnSlope(robot.Tag, 15.0, 0, 0));
  slides.Step(20);
  CHECK(slides.Position("r").GetX() < -0.05);
}

TEST_CASE("rigid drive: a robot climbs from the floor onto a ramp and over its top",
          "[contract][engine][rigid]") {
  // a wedge's upper face from (0.5, 0) up to (1.5, 0.2), and a table behind it
  const Real angle = std::asin(0.2);
  const Real length = 1.0 / std::cos(angle);
  const CVector3 middle(0.5 + 0.5 * std::cos(angle) * length, 0.0, 0.5 * std::sin(angle) * length);
  const CVector3 base = middle - CVector3(-std::sin(angle), 0.0, std::cos(angle)) * 0.1;
  const std::string arena =
      SBoxXml{"ramp", CVector3(length, 1, 0.1), base, CVector3(0, -angle * 180.0 / ARGOS_PI, 0),
              0.0}
          .ToXml() +
      SBoxXml{"table", CVector3(1, 1, std::sin(angle) * length), CVector3(2.0, 0, 0), {}, 0.0}
          .ToXml();
  const SRobotType robot = GENERATE(kFootBot, kEPuck);
  CAPTURE(robot.Tag);
  CRigidScene world(GroundedEngine(), arena + DriverXml(robot.Tag, "r", 0.2, 0, 0, 10, 10));
  world.Step(190);
  CHECK_THAT(world.Position("r").GetZ(), WithinAbs(std::sin(angle) * length, 5e-3));
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(0.0, 0.02));
  CHECK(world.Position("r").GetX() > 1.75);
  CHECK(world.Tilt("r") < 0.02);
  // and at the end of the table it falls
  world.Step(120);
  CHECK(world.Position("r").GetZ() < 0.1);
}

TEST_CASE("rigid drive: a foot-bot pushes a box that it can move at its own speed",
          "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(),
                    DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) +
                        SBoxXml{"box", CVector3(0.2, 0.2, 0.1),
                                CVector3(kFootBotRadius + 0.11, 0, 0), CVector3(), 0.5}
                            .ToXml());
  world.Step(40);
  const Real robot = world.Position("r").GetX();
  const Real box = world.Position("box").GetX();
  world.Step(20);
  CHECK_THAT(world.Position("r").GetX() - robot, WithinAbs(0.2, 2e-3));
  CHECK_THAT(world.Position("box").GetX() - box, WithinAbs(0.2, 2e-3));
  CHECK_THAT(world.Position("box").GetX() - world.Position("r").GetX(),
             WithinAbs(kFootBotRadius + 0.1, 0.02 * kFootBotRadius));
}

TEST_CASE("rigid drive: what is too heavy stays, and the wheels slip or stall",
          "[contract][engine][rigid]") {
  // friction holds the box with 49 N; the robot has 16 N of weight
  CRigidScene world(GroundedEngine(),
                    DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) +
                        SBoxXml{"box", CVector3(0.2, 0.2, 0.1),
                                CVector3(kFootBotRadius + 0.11, 0, 0), CVector3(), 5.0}
                            .ToXml());
  world.Step(100);
  CHECK_THAT(world.Position("box").GetX(), WithinAbs(kFootBotRadius + 0.11, 2e-3));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.01, 0.02 * kFootBotRadius));
  CHECK(world.Tilt("r") < 0.05);
}

TEST_CASE("rigid drive: in a crowd robots overlap little", "[contract][engine][rigid]") {
  // 100 foot-bots that all drive to the middle
  std::string arena;
  CRandomStream random(1, "test", "rigid", "places");
  for (int i = 0; i < 100; ++i) {
    const Real x = 0.25 * (i % 10 - 4.5) + random.Uniform(-0.02, 0.02);
    const Real y = 0.25 * (i / 10 - 4.5) + random.Uniform(-0.02, 0.02);
    arena += DriverXml("foot-bot", "r" + std::to_string(i), x, y,
                       std::atan2(-y, -x) * 180.0 / ARGOS_PI, 10, 10);
  }
  CRigidScene world(GroundedEngine(), arena);
  world.Step(50);
  // for each robot and tick its deepest overlap, in shares of the radius
  std::vector<Real> overlaps;
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    MeasureOverlaps(world, 100, overlaps);
  }
  Real tilt = 0.0;
  for (int i = 0; i < 100; ++i) {
    tilt = std::max(tilt, world.Tilt("r" + std::to_string(i)));
  }
  std::sort(overlaps.begin(), overlaps.end());
  // the promise of the engine: 2 % of the radius
  CHECK(overlaps[overlaps.size() * 99 / 100] <= 0.02);
  // they do press
  CHECK(overlaps[overlaps.size() / 2] > 0.0);
  // nobody climbs on anybody
  CHECK(tilt < 0.1);
}

}  // namespace argos
