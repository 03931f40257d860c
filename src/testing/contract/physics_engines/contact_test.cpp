// Forces between bodies and between bodies and ground, compared with closed forms in every engine.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace argos::contact_test {

using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr Real kTick = 0.1;  // s

/** A movable object, flat so that nothing topples it. */
struct SThing {
  std::string Id;
  bool IsBox = true;
  Real X = 0.0, Y = 0.0;  // m
  Real Mass = 1.0;  // kg
  Real Yaw = 0.0;  // degrees

  static constexpr Real kHalf = 0.1;  // m: half a box's side, or the radius

  std::string ToXml() const {
    std::ostringstream xml;
    xml << (IsBox ? "<box size='0.2,0.2,0.05'" : "<cylinder radius='0.1' height='0.05'") << " id='"
        << Id << "' movable='true' mass='" << Mass << "'><body position='" << X << "," << Y
        << ",0' orientation='" << Yaw << ",0,0'/></" << (IsBox ? "box" : "cylinder") << ">";
    return xml.str();
  }
  // about the vertical axis, kg m^2
  Real Inertia() const { return Mass * kHalf * kHalf * (IsBox ? 2.0 / 3.0 : 0.5); }
};

// kinetic energy, J
Real EnergyOf(CDriveWorld& world, const SThing& thing) {
  const SBodyMotion motion = world.Motion(thing.Id);
  const Real spin = motion.Rotation.GetZ();
  return 0.5 * thing.Mass * motion.Velocity.SquareLength() + 0.5 * thing.Inertia() * spin * spin;
}

}  // namespace

TEST_CASE("momentum: a body without friction keeps its velocity", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  if (IsSkipped(engine, engine.HasMomentum, "momentum")) {
    return;
  }
  const std::string solver = GENERATE_COPY(from_range(engine.Solvers));
  const bool isBox = GENERATE(true, false);
  const Real angle = GENERATE(0.0, 0.7, 2.5);
  CAPTURE(engine, solver, isBox, angle);
  CDriveWorld world(engine.ToBrakingXml(0.0, 1.0, "e", solver), SThing{"a", isBox}.ToXml());
  world.Step(2);
  const CVector3 start = world.Position("a");
  const CVector3 velocity(0.3 * std::cos(angle), 0.3 * std::sin(angle), 0.0);
  world.Launch("a", velocity);
  world.Step(50);
  const Real tolerance = 1e-6 + engine.Precision * 0.3;
  CHECK(Distance(world.Motion("a").Velocity, velocity) <= tolerance);
  CHECK(Distance(world.Position("a") - start, velocity * 5.0) <= 5.0 * tolerance);
  CHECK_THAT(world.Motion("a").Rotation.GetZ(), WithinAbs(0.0, tolerance));
}

TEST_CASE("friction: a sliding body decelerates constantly, stops, and rests",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  if (IsSkipped(engine, engine.HasMomentum, "momentum: what is let go stops at once")) {
    return;
  }
  const std::string solver = GENERATE_COPY(from_range(engine.Solvers));
  const Real mass = GENERATE(0.5, 10.0);
  // friction limited by a square or a pyramid decelerates up to 41 % more along the diagonals
  const Real degrees = GENERATE(0.0, 30.0, 45.0);
  CAPTURE(engine, solver, mass, degrees);
  const Real angle = degrees * std::numbers::pi / 180.0;
  const CVector3 ahead(std::cos(angle), std::sin(angle), 0.0);
  constexpr Real kDeceleration = 1.1;  // m/s^2
  CDriveWorld world(engine.ToBrakingXml(kDeceleration, mass, "e", solver),
                    SThing{.Id = "a", .Mass = mass}.ToXml());
  world.Step(2);
  const CVector3 start = world.Position("a");
  world.Launch("a", ahead);
  for (int tick = 1; tick <= 9; ++tick) {
    world.Step();
    const CVector3 exact = ahead * (1.0 - kDeceleration * kTick * tick);
    REQUIRE(Distance(world.Motion("a").Velocity, exact) <= 1e-5 + 5.0 * engine.Precision);
  }
  world.Step(3);
  const CVector3 stopped = world.Position("a");
  // v^2 / (2 a), less up to the path of half a substep, because speeds change before positions do
  const Real path = 1.0 / (2.0 * kDeceleration);
  CHECK(ahead.DotProduct(stopped - start) <= path * (1.0 + 5.0 * engine.Precision));
  CHECK(ahead.DotProduct(stopped - start) >= (path - 0.5 * kTick) * (1.0 - engine.Precision));
  world.Step(20);
  CHECK(Distance(world.Position("a"), stopped) <= 1e-6 + 0.1 * engine.Slack);
}

TEST_CASE("friction: on a slope a box slides beyond the angle of friction and rests below it",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  if (IsSkipped(engine, engine.HasSlopes, "slopes")) {
    return;
  }
  const std::string solver = GENERATE_COPY(from_range(engine.Solvers));
  // the friction coefficient of objects is 1 by default
  const Real degrees = GENERATE(43.0, 50.0);
  CAPTURE(engine, solver, degrees);
  const Real angle = degrees * std::numbers::pi / 180.0;
  const CVector3 up(std::sin(angle), 0.0, std::cos(angle));
  const CVector3 down(std::cos(angle), 0.0, -std::sin(angle));
  const CVector3 start = up * 0.2 + CVector3(0, 0, 10);
  std::ostringstream arena;
  arena << "<box id='slope' size='8,2,0.2' movable='false'><body position='0,0,10' orientation='0,"
        << degrees << ",0'/></box><box id='a' size='0.3,0.2,0.1' movable='true' mass='1'><body "
        << "position='" << start << "' orientation='0," << degrees << ",0'/></box>";
  CDriveWorld world(engine.ToXml("e", "", solver), arena.str());
  world.Step(10);
  const CVector3 slid = world.Position("a") - start;
  if (degrees < 45.0) {
    CHECK(slid.Length() <= engine.Slack);
    return;
  }
  // g (sin - mu cos) t^2 / 2, plus up to a tenth of the change of speed in a tick
  const Real path = 0.5 * kEngineGravity * (std::sin(angle) - std::cos(angle));
  CHECK_THAT(slid.DotProduct(down), WithinRel(path, 0.03));
  CHECK(std::abs(slid.DotProduct(up)) <= engine.Slack);
}

TEST_CASE("impact: two objects move on together with the momentum of the first",
          "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  if (IsSkipped(engine, engine.HasMomentum, "momentum")) {
    return;
  }
  const std::string solver = GENERATE_COPY(from_range(engine.Solvers));
  const bool isBox = GENERATE(true, false);
  const Real mass = GENERATE(1.0, 3.0);  // kg, of the second object
  CAPTURE(engine, solver, isBox, mass);
  CDriveWorld world(engine.ToBrakingXml(0.0, 1.0, "e", solver),
                    SThing{"a", isBox}.ToXml() +
                        SThing{.Id = "b", .IsBox = isBox, .X = 0.4, .Mass = mass}.ToXml());
  world.Step(2);
  world.Launch("a", CVector3(0.5, 0.0, 0.0));
  world.Step(20);
  // restitution is 0
  const Real together = 0.5 / (1.0 + mass);
  const Real tolerance = 1e-5 + engine.Precision;
  const Real speedA = world.Motion("a").Velocity.GetX();
  const Real speedB = world.Motion("b").Velocity.GetX();
  CHECK_THAT(speedA, WithinAbs(together, tolerance));
  CHECK_THAT(speedB, WithinAbs(together, tolerance));
  CHECK_THAT(speedA + mass * speedB, WithinAbs(0.5, tolerance));
  // the objects touch
  CHECK_THAT(world.Position("b").GetX() - world.Position("a").GetX(),
             WithinAbs(0.2, 0.02 * SThing::kHalf));
}

TEST_CASE("impact: colliding objects conserve momentum and gain no energy", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  if (IsSkipped(engine, engine.HasMomentum, "momentum")) {
    return;
  }
  const std::string solver = GENERATE_COPY(from_range(engine.Solvers));
  CAPTURE(engine, solver);
  std::vector<SThing> things;
  std::string arena;
  CRandomStream random(1, "test", "impact", "things");
  for (int i = 0; i < 16; ++i) {
    things.push_back({"t" + std::to_string(i), i % 2 == 0, 0.5 * (i % 4) - 0.75,
                      0.5 * (i / 4) - 0.75, random.Uniform(0.5, 3.0), random.Uniform(0.0, 90.0)});
    arena += things.back().ToXml();
  }
  CDriveWorld world(engine.ToBrakingXml(0.0, 1.0, "e", solver), arena);
  world.Step(2);
  CVector3 momentum;
  Real total = 0.0;  // kg m/s
  for (const SThing& thing : things) {
    // the velocity points to a place near the middle
    // one after the other: the order in which arguments are evaluated is the compiler's choice
    const Real y = random.Uniform(-0.2, 0.2);
    const Real x = random.Uniform(-0.2, 0.2);
    const CVector3 velocity(0.1 - thing.X + x, -0.2 - thing.Y + y, 0.0);
    world.Launch(thing.Id, velocity * 0.5);
    momentum += velocity * 0.5 * thing.Mass;
    total += velocity.Length() * 0.5 * thing.Mass;
  }
  Real energy = HUGE_VAL;
  Real first = 0.0;
  for (int tick = 0; tick < 40; ++tick) {
    world.Step();
    CVector3 sum;
    Real now = 0.0;
    for (const SThing& thing : things) {
      sum += world.Motion(thing.Id).Velocity * thing.Mass;
      now += EnergyOf(world, thing);
    }
    CAPTURE(tick);
    first = tick == 0 ? now : first;
    sum.SetZ(0.0);
    REQUIRE(Distance(sum, momentum) <= (1e-5 + engine.Precision) * total);
    REQUIRE(now <= energy + (1e-5 + engine.Precision) * first);
    energy = now;
  }
  // the objects have collided
  CHECK(energy <= 0.7 * first);
}

TEST_CASE("drive: the force is bounded", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  // share of the force that a foot-bot can exert
  const Real share = GENERATE(0.8, 1.2);
  CAPTURE(engine, share);
  const Real hold = share * engine.Push;  // N
  const Real mass = engine.Ground == EGround::Weight ? hold / kEngineGravity : 1.0;
  std::ostringstream arena;
  arena << DriverXml("foot-bot", "pusher", 0, 0, 0, 10, 10) << "<box id='box' size='0.2,0.2,0.1' "
        << "movable='true' mass='" << mass << "'><body position='" << kFootBotRadius + 0.12
        << ",0,0'/></box>";
  CDriveWorld world(engine.ToBrakingXml(hold / mass, mass), arena.str());
  const Real start = world.Position("box").GetX();
  world.Step(60);
  const Real moved = world.Position("box").GetX() - start;
  if (share < 1.0) {
    CHECK(moved > 0.1);
  } else {
    // The impact of the arriving robot, 1.6 kg at 0.1 m/s, moves the box slightly:
    // with 3 N left to decelerate 2.6 kg at 0.0615 m/s, 1.6 mm. The rest is creep, far
    // below 1 % of the ordered speed.
    CHECK(moved <= 0.02);
    const Real settled = world.Position("box").GetX();
    world.Step(100);
    INFO("creep in 10 s, m: " << world.Position("box").GetX() - settled);
    CHECK(world.Position("box").GetX() - settled <= 0.01 * 1.0);
  }
}

TEST_CASE("drive: a robot stalls at a wall and does not penetrate it", "[contract][engine]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  const Real angle = GENERATE(0.0, 30.0, 60.0);
  CAPTURE(engine, angle);
  const std::string wall =
      "<box id='wall' size='0.2,8,0.5' movable='false'><body position='0.5,0,0'/></box>";
  CDriveWorld world(engine.ToXml(), wall + DriverXml("e-puck", "r", 0.3, -1, angle, 10, 10));
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    // includes a robot that tilts: it stands on its wheels, below which the shapes of its base end
    const Real depth = world.Body("r").GetBoundingBox().MaxCorner.GetX() - 0.4;
    REQUIRE(depth <= 0.02 * kEPuckRadius + engine.Slack);
  }
  // it has reached the wall, to a tenth of its radius
  CHECK_THAT(world.Position("r").GetX() + kEPuckRadius, WithinAbs(0.4, 0.1 * kEPuckRadius));
}

}  // namespace argos::contact_test
