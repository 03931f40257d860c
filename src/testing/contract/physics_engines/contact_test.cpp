// What bodies do to each other and to the ground, against closed forms.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/overlap.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace argos {

using Catch::Matchers::WithinAbs;
using testing::MeasureOverlaps;
using testing::SOverlaps;

namespace {

constexpr Real kFootBotRadius = 0.085036758;  // m
constexpr Real kEPuckRadius = 0.035;  // m
constexpr Real kTick = 0.1;  // s

// a movable box of 0.2 m ahead of a foot-bot that pushes it along x at 10 cm/s
std::string PushedBox(Real mass) {
  std::ostringstream xml;
  xml << DriverXml("foot-bot", "pusher", 0, 0, 0, 10, 10) << "<box id='box' size='0.2,0.2,0.1' "
      << "movable='true' mass='" << mass << "'><body position='" << kFootBotRadius + 0.12
      << ",0,0'/></box>";
  return xml.str();
}

}  // namespace

TEST_CASE("friction: a pushed box that is let go slides as friction says", "[contract][engine]") {
  constexpr Real kMass = 10.0;  // kg
  constexpr Real kFriction = 1.49;  // N, the engine's default
  CDriveWorld world("<dynamics2d id='e'/>", PushedBox(kMass));
  world.Step(40);
  // the pusher backs off
  world.Driver("pusher").Left = world.Driver("pusher").Right = -10.0;
  world.Step(2);

  std::vector<Real> speeds;  // m/s, mean of each tick
  Real last = world.Position("box").GetX();
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    const Real x = world.Position("box").GetX();
    speeds.push_back((x - last) / kTick);
    last = x;
  }
  const Real perTick = kFriction / kMass * kTick;  // m/s
  // while it slides, every tick takes the same from its speed; float arithmetic leaves 1e-5
  for (size_t tick = 0; tick + 1 < speeds.size() && speeds[tick + 1] > 2.0 * perTick; ++tick) {
    CAPTURE(tick, speeds[tick]);
    CHECK_THAT(speeds[tick] - speeds[tick + 1], WithinAbs(perTick, 2e-5));
  }
  REQUIRE(speeds.front() > 3.0 * perTick);
  // and then it rests
  CHECK_THAT(speeds.back(), WithinAbs(0.0, 1e-6));
  CHECK_THAT(world.Position("box").GetY(), WithinAbs(0.0, 1e-4));
}

TEST_CASE("drive: its force is bounded", "[contract][engine]") {
  // the foot-bot pushes with at most 15 N
  const auto [friction, moves] =
      GENERATE(std::pair<Real, bool>(12.0, true), std::pair<Real, bool>(18.0, false));
  CAPTURE(friction);
  std::ostringstream engine;
  engine << "<dynamics2d id='e'><friction box_linear_friction='" << friction << "'/></dynamics2d>";
  CDriveWorld world(engine.str(), PushedBox(1.0));
  const Real start = world.Position("box").GetX();
  world.Step(60);
  const Real moved = world.Position("box").GetX() - start;
  if (moves) {
    CHECK(moved > 0.1);
  } else {
    // the blow of its arrival, 1.6 kg at 0.1 m/s, moves the box a little: with 3 N left to brake
    // 2.6 kg at 0.0615 m/s, 1.6 mm; what follows is creep, far below 1 % of the speed ordered
    CHECK(moved <= 0.02);
    const Real settled = world.Position("box").GetX();
    world.Step(100);
    INFO("creep in 10 s, m: " << world.Position("box").GetX() - settled);
    CHECK(world.Position("box").GetX() - settled <= 0.01 * 1.0);
  }
}

TEST_CASE("drive: a robot stalls at a wall and does not sink into it", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  const Real angle = GENERATE(0.0, 30.0, 60.0);
  CAPTURE(engine, angle);
  const std::string wall =
      "<box id='wall' size='0.2,4,0.5' movable='false'><body position='0.5,0,0'/></box>";
  CDriveWorld world(engine.ToXml(), wall + DriverXml("e-puck", "r", 0.3, -1, angle, 10, 10));
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    const Real depth = world.Position("r").GetX() + kEPuckRadius - 0.4;
    REQUIRE(depth <= 0.02 * kEPuckRadius);
  }
  // it has reached the wall, and touches it to a tenth of its radius
  CHECK_THAT(world.Position("r").GetX() + kEPuckRadius, WithinAbs(0.4, 0.1 * kEPuckRadius));
}

TEST_CASE("impact: two equal cylinders without friction share the momentum", "[contract][engine]") {
  const std::string engine =
      "<dynamics2d id='e'><friction cylinder_linear_friction='0' cylinder_angular_friction='0'/>"
      "</dynamics2d>";
  std::ostringstream arena;
  arena << DriverXml("foot-bot", "pusher", 0, 0, 0, 10, 10)
        << "<cylinder id='a' radius='0.1' height='0.1' movable='true' mass='1'><body "
           "position='0.25,0,0'/>"
        << "</cylinder><cylinder id='b' radius='0.1' height='0.1' movable='true' mass='1'>"
        << "<body position='1.2,0,0'/></cylinder>";
  CDriveWorld world(engine, arena.str());
  world.Step(20);
  world.Driver("pusher").Left = world.Driver("pusher").Right = -10.0;
  world.Step(2);
  const auto speed = [&world](const std::string& id) {
    const Real before = world.Position(id).GetX();
    world.Step();
    return (world.Position(id).GetX() - before) / kTick;
  };
  const Real free = speed("a");
  // nothing brakes it
  world.Step(5);
  CHECK_THAT(speed("a"), WithinAbs(free, 1e-5));
  REQUIRE(free > 0.05);
  world.Step(100);
  // restitution 0: they go on together, at half the speed
  CHECK_THAT(speed("a"), WithinAbs(0.5 * free, 1e-4));
  CHECK_THAT(speed("b"), WithinAbs(0.5 * free, 1e-4));
}

TEST_CASE("crowd: discs that drive to one place overlap by at most 2 % of the radius",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  std::ostringstream arena;
  UInt32 count = 0;
  for (int ring = 1; ring <= 8; ++ring) {
    const int robots = 6 * ring;
    for (int k = 0; k < robots; ++k) {
      const Real angle = 2.0 * std::numbers::pi * k / robots;
      const Real distance = 0.12 * ring;
      // every robot looks at the centre and keeps driving
      arena << DriverXml("e-puck", "r" + std::to_string(count++), distance * std::cos(angle),
                         distance * std::sin(angle), angle * 180.0 / std::numbers::pi + 180.0, 10,
                         10);
    }
  }
  REQUIRE(count == 216);
  CDriveWorld world(engine.ToXml(), arena.str());
  world.Step(50);
  SOverlaps overlaps;
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    MeasureOverlaps(world.GetSpace(), overlaps);
  }
  // the crowd is dense: its discs cover 70 % of the circle around their centres; as a square
  // lattice they would cover 79 %
  Real farthest = 0.0;
  for (UInt32 i = 0; i < count; ++i) {
    farthest = std::max(farthest, world.Position("r" + std::to_string(i)).Length());
  }
  CHECK(count * kEPuckRadius * kEPuckRadius >= 0.7 * farthest * farthest);
  CHECK(SOverlaps::Quantile(overlaps.WithRobots, 0.99) <= 0.02);
}

}  // namespace argos
