// Drives of robots that grip: what they decide against each other, and the paths on which they tow,
// against closed forms, for any number of substeps, in scenes that are turned.

#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/contract/physics_engines/grip_world.h>
#include <argos3/testing/support/closed_form/differential_drive.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

namespace argos::grip_drives_test {

using Catch::Matchers::WithinAbs;
using testing::IntegrateDifferentialDrive;
using testing::SPose;

namespace {

constexpr Real kTick = 0.1;  // s
constexpr Real kGap = 0.003;  // m: in reach, but without contact
constexpr Real kPitch = 2.0 * kFootBotRadius + kGap;  // m, of robots in a chain
constexpr Real kAhead = kFootBotRadius + kGap + 0.1;  // m: position of a load that is gripped
constexpr Real kWheels = 0.14;  // m, distance of a foot-bot's wheels
constexpr Real kPull =
    5.0;  // N: in dynamics3d wheels slip at more, because robots lean when they pull

/** A robot in a chain: its drive's greatest force, N, and the speed that it wants, m/s. */
struct SLink {
  Real Force, Speed;
};

std::string MakeEngine(const SEngineType& engine, UInt32 iterations,
                       const std::string& children = "") {
  const std::string substeps =
      iterations > 0 ? " iterations='" + std::to_string(iterations) + "'" : "";
  return engine.ToXml("e", engine.GetPromptness() + substeps, children);
}

/** Robots along a line from the origin; each grips the next one. */
class CChain {
 public:
  CChain(const SEngineType& engine, UInt32 iterations, const std::vector<SLink>& links,
         Real degrees)
      : m_links(links),
        m_axis(std::cos(degrees * std::numbers::pi / 180.0),
               std::sin(degrees * std::numbers::pi / 180.0), 0.0),
        m_world(MakeArena(degrees), {MakeEngine(engine, iterations), 10, 0}) {
    m_world.Step(3);
    for (size_t i = 0; i + 1 < links.size(); ++i) {
      REQUIRE(m_world.HeldBy(Id(i)) == Id(i + 1));
    }
    for (size_t i = 0; i < links.size(); ++i) {
      m_world.Drive(Id(i), 100.0 * links[i].Speed, 100.0 * links[i].Speed);
    }
  }
  /** The speed of each robot along the line after a time, in the mean of a second, m/s. */
  std::vector<Real> ComputeSpeeds(UInt32 ticks) {
    m_world.Step(ticks);
    std::vector<Real> places;
    for (size_t i = 0; i < m_links.size(); ++i) {
      places.push_back(m_axis.DotProduct(m_world.Position(Id(i))));
    }
    m_world.Step(10);
    for (size_t i = 0; i < m_links.size(); ++i) {
      places[i] = m_axis.DotProduct(m_world.Position(Id(i))) - places[i];
    }
    return places;
  }

 private:
  static std::string Id(size_t i) { return "r" + std::to_string(i); }
  std::string MakeArena(Real degrees) const {
    std::string arena;
    for (size_t i = 0; i < m_links.size(); ++i) {
      const CVector3 place = m_axis * (kPitch * static_cast<Real>(i));
      arena += GripperXml(Id(i), place.GetX(), place.GetY(), degrees,
                          i + 1 < m_links.size() ? "lock='true'" : "", m_links[i].Force);
    }
    return arena;
  }

  std::vector<SLink> m_links;
  CVector3 m_axis;
  CGripWorld m_world;
};

// dynamics3d has 4 substeps at least; many are slow there, and with sanitizers
bool IsLeftOut(const SEngineType& engine, UInt32 iterations) {
  return (!engine.IsPlane && iterations == 1) ||
         iterations > (engine.IsPlane && !kHasAddressSanitizer ? 50 : 10);
}

/** Speeds (m/s) of a chain are all equal to one. */
void CheckSpeeds(const std::vector<Real>& speeds, Real expected, Real margin) {
  for (const Real speed : speeds) {
    CHECK_THAT(speed, WithinAbs(expected, margin));
  }
}

/** How far from its closed form a robot is, m and rad. */
struct SOff {
  Real Place, Turn;
};

/** A robot grips a load and drives on the arc of its wheels' speeds, m/s. */
SOff Tow(const SEngineType& engine, UInt32 iterations, Real mass, Real left, Real right,
         UInt32 ticks) {
  CGripWorld world(GripperXml("r", 0, 0, 0, "lock='true'") + LoadXml("load", kAhead, 0, mass),
                   {MakeEngine(engine, iterations), 10, 0});
  world.Step(3);
  REQUIRE(world.HeldBy("r") == "load");
  const CVector3 start = world.Position("r");
  const SPose from{start.GetX(), start.GetY(), world.Yaw("r")};
  world.Drive("r", 100.0 * left, 100.0 * right);
  world.Step(1 + ticks);  // an order is executed in the next tick
  const SPose exact = IntegrateDifferentialDrive(from, left, right, kWheels, ticks * kTick);
  const CVector3 place = world.Position("r");
  return {std::hypot(place.GetX() - exact.X, place.GetY() - exact.Y),
          std::remainder(world.Yaw("r") - exact.Yaw, 2.0 * std::numbers::pi)};
}

constexpr Real kCircle = 0.6;  // m
constexpr Real kCircleRate = 0.15;  // rad/s

/**
 * Robots that grip the next one all turn about (0, kCircle) at one rate: as a rigid body, so that
 * grips need no force. @return how far one is from its closed form, m.
 */
Real Circle(const SEngineType& engine, UInt32 iterations, int count, bool isMutual, Real sense,
            UInt32 ticks) {
  const Real step = 2.0 * std::asin(0.5 * kPitch / kCircle);
  std::string arena;
  const auto idOf = [](int i) { return "r" + std::to_string(i); };
  for (int i = 0; i < count; ++i) {
    const Real yaw = step * i;
    arena +=
        GripperXml(idOf(i), kCircle * std::sin(yaw), kCircle * (1.0 - std::cos(yaw)),
                   yaw * 180.0 / std::numbers::pi, i + 1 < count || isMutual ? "lock='true'" : "");
  }
  CGripWorld world(arena, {MakeEngine(engine, iterations), 10, 0});
  world.Step(3);
  REQUIRE(world.HeldBy("r0") == "r1");
  const CGripWorld::TPoses before = world.GetPoses();
  const Real speed = sense * kCircleRate * kCircle;
  const Real difference = 0.5 * sense * kCircleRate * kWheels;
  for (int i = 0; i < count; ++i) {
    world.Drive(idOf(i), 100.0 * (speed - difference), 100.0 * (speed + difference));
  }
  world.Step(1 + ticks);
  Real off = 0.0;
  for (int i = 0; i < count; ++i) {
    const CVector3 start = before.at(idOf(i)).Position;
    const SPose exact =
        IntegrateDifferentialDrive({start.GetX(), start.GetY(), step * i}, speed - difference,
                                   speed + difference, kWheels, ticks * kTick);
    const CVector3 place = world.Position(idOf(i));
    off = std::max(off, std::hypot(place.GetX() - exact.X, place.GetY() - exact.Y));
  }
  return off;
}

}  // namespace

TEST_CASE("gripping: two equal drives share a pull, at the mean of the speeds that they want",
          "[contract][engine][grip]") {
  // in dynamics3d lean and friction of wheels decide, so no two drives are equal
  const UInt32 iterations = GENERATE(0, 1, 2, 5, 10, 50);
  const Real degrees = GENERATE(0.0, 37.0, 180.0);
  const auto [first, second] = GENERATE(table<Real, Real>(
      {{-0.1, 0.0}, {0.1, 0.0}, {0.0, -0.1}, {-0.1, 0.05}, {0.05, 0.1}, {-0.1, 0.1}}));
  CAPTURE(iterations, degrees, first, second);
  CChain chain(kDynamics2D, iterations, {{15.0, first}, {15.0, second}}, degrees);
  CheckSpeeds(chain.ComputeSpeeds(10), 0.5 * (first + second), 2e-4);
}

TEST_CASE("gripping: a balance ends when commands change", "[contract][engine][grip]") {
  CGripWorld world(GripperXml("a", 0, 0, 0, "lock='true'") + GripperXml("b", kPitch, 0, 0, ""));
  world.Step(3);
  REQUIRE(world.HeldBy("a") == "b");
  // both are at the mean of -10 and 0 cm/s, then want the same, then the mean of -10 and 10 cm/s
  Real before = 0.0;
  for (const auto& [first, second, mean] :
       {std::tuple(-10.0, 0.0, -5.0), std::tuple(-10.0, -10.0, -10.0), std::tuple(0.0, 0.0, 0.0),
        std::tuple(-10.0, 10.0, 0.0), std::tuple(10.0, 0.0, 5.0)}) {
    CAPTURE(first, second);
    world.Drive("a", first, first);
    world.Drive("b", second, second);
    world.Step(10);
    before = world.Position("b").GetX();
    world.Step(10);
    CHECK_THAT(world.Position("b").GetX() - before, WithinAbs(0.01 * mean, 2e-4));
  }
}

TEST_CASE("gripping: the greater sum of forces decides the speed of a chain",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  const UInt32 iterations = GENERATE(0, 1, 5, 50);
  if (IsLeftOut(engine, iterations)) {
    return;
  }
  struct SCase {
    std::vector<SLink> Links;
    Real Speed;
  };
  const SCase each = GENERATE(values<SCase>({
      {{{kPull, -0.1}, {0.9 * kPull, 0.0}}, -0.1},
      {{{kPull, 0.1}, {0.9 * kPull, 0.0}}, 0.1},
      {{{0.9 * kPull, -0.1}, {kPull, 0.0}}, 0.0},
      {{{0.9 * kPull, 0.05}, {kPull, -0.1}}, -0.1},
      // one against two, two against one, one against three
      {{{kPull, -0.1}, {kPull, 0.0}, {kPull, 0.0}}, 0.0},
      {{{kPull, -0.1}, {0.4 * kPull, 0.0}, {0.4 * kPull, 0.0}}, -0.1},
      {{{kPull, -0.1}, {kPull, -0.1}, {kPull, 0.0}}, -0.1},
      {{{kPull, 0.0}, {kPull, 0.1}, {kPull, 0.1}}, 0.1},
      {{{kPull, -0.1}, {kPull, 0.0}, {kPull, 0.0}, {kPull, 0.0}}, 0.0},
      {{{kPull, -0.1}, {0.3 * kPull, 0.0}, {0.3 * kPull, 0.0}, {0.3 * kPull, 0.0}}, -0.1},
  }));
  CAPTURE(engine, iterations, each.Links.size(), each.Links[0].Force, each.Links[0].Speed);
  CChain chain(engine, iterations, each.Links, 25.0);
  // from rest, the least difference of forces, 10 % of 5 N, moves 3.2 kg at 0.1 m/s in 0.7 s
  CheckSpeeds(chain.ComputeSpeeds(20), each.Speed, 1e-3);
}

TEST_CASE("gripping: four equal drives, of which two pull, share the pull",
          "[contract][engine][grip]") {
  const UInt32 iterations = GENERATE(0, 1, 2, 5, 10, 50);
  CAPTURE(iterations);
  CChain chain(kDynamics2D, iterations, {{15.0, -0.1}, {15.0, -0.1}, {15.0, 0.0}, {15.0, 0.0}},
               300.0);
  CheckSpeeds(chain.ComputeSpeeds(20), -0.05, 2e-4);
}

TEST_CASE("gripping: a robot that tows a load stays on the arc of its wheels",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  const UInt32 iterations = GENERATE(0, 1, 2, 5, 50);
  // in dynamics3d the load is held by its weight
  const Real mass = GENERATE(0.01, 0.1, 0.3, 5.0);
  const auto [left, right] =
      GENERATE(table<Real, Real>({{-0.08, -0.10}, {0.08, 0.10}, {-0.10, -0.04}}));
  if ((mass > 1.0 && engine.Ground == EGround::Weight) || IsLeftOut(engine, iterations)) {
    return;
  }
  CAPTURE(engine, iterations, mass, left, right);
  constexpr UInt32 kTicks = 100;
  const SOff off = Tow(engine, iterations, mass, left, right, kTicks);
  const Real way = 0.5 * std::abs(left + right) * kTicks * kTick;
  // share of the way, besides what is lost while the drive is at its limit; with one substep of
  // 0.1 s the solver errs most
  const Real slip = engine.IsPlane ? (iterations == 1 ? 0.008 : 0.004) : 0.01;
  CHECK(off.Place < slip * way + 1e-3);
  CHECK_THAT(off.Turn, WithinAbs(0.0, engine.IsPlane ? 2.0 * slip : 2e-2));
}

TEST_CASE("gripping: robots on one circle that grip each other stay on it",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  const UInt32 iterations = GENERATE(0, 1, 5, 50);
  const int count = GENERATE(2, 3, 4);
  const bool isMutual = GENERATE(false, true);
  const Real sense = GENERATE(-1.0, 1.0);
  if (IsLeftOut(engine, iterations) || (count != 4 && isMutual)) {
    return;
  }
  CAPTURE(engine, iterations, count, isMutual, sense);
  constexpr UInt32 kTicks = 100;
  CHECK(Circle(engine, iterations, count, isMutual, sense, kTicks) <
        (engine.IsPlane ? 1e-3 : 0.01) * kCircleRate * kCircle * kTicks * kTick);
}

TEST_CASE("gripping: a load on a soft grip swings as a damped oscillator",
          "[contract][engine][grip]") {
  const UInt32 iterations = GENERATE(0, 1, 5, 50);
  const Real mass = GENERATE(0.2, 1.6, 5.0);
  CAPTURE(iterations, mass);
  constexpr Real kStiffness = 10.0;  // N/m
  constexpr Real kRobot = 1.6;  // kg
  constexpr Real kSpeed = 0.05;  // m/s
  constexpr UInt32 kTicksPerSecond = 100;
  CGripWorld world(
      GripperXml("r", 0, 0, 0, "lock='true'") + RollXml("load", kAhead + 0.002, 0, mass),
      {"<dynamics2d id='e' velocity_lag='0' gripping_rigidity='10'" +
           (iterations > 0 ? " iterations='" + std::to_string(iterations) + "'" : std::string()) +
           "><friction cylinder_linear_friction='0' cylinder_angular_friction='0'/></dynamics2d>",
       kTicksPerSecond, 0});
  world.Step(3);
  REQUIRE(world.HeldBy("r") == "load");
  const auto distance = [&] { return (world.Position("load") - world.Position("r")).GetX(); };
  const Real start = distance();
  world.Drive("r", -100.0 * kSpeed, -100.0 * kSpeed);
  world.Step();
  // the damping is critical for both masses on the spring; the drive holds one of them
  const Real rate = std::sqrt(kStiffness / mass);
  const Real share = std::sqrt(kRobot / (kRobot + mass));  // of the critical damping of the load
  const Real beat = rate * std::sqrt(1.0 - share * share);
  const Real peak = kSpeed / rate;  // without damping
  for (UInt32 tick = 1; tick <= 4 * kTicksPerSecond; ++tick) {
    world.Step();
    const Real time = static_cast<Real>(tick) / kTicksPerSecond;
    const Real exact = kSpeed / beat * std::exp(-share * rate * time) * std::sin(beat * time);
    // Euler's method: half a substep of 10 ms late, and damped by it
    CHECK_THAT(distance() - start, WithinAbs(exact, 0.05 * peak));
  }
}

TEST_CASE("gripping: friction holds or yields to what robots push together, some of which grip",
          "[contract][engine][grip]") {
  // of the force of three drives
  const auto [share, mass] = GENERATE(table<Real, Real>(
      {{0.5, 1.0}, {0.9, 1.0}, {0.9, 10.0}, {1.1, 1.0}, {2.0, 0.05}, {1e5, 0.05}, {1e5, 1.0}}));
  const UInt32 iterations = GENERATE(0, 1, 2, 5, 10);
  const int gripping = GENERATE(1, 2, 3);
  CAPTURE(share, mass, iterations, gripping);
  constexpr Real kForce = 15.0;  // N
  constexpr Real kSpeed = 0.1;  // m/s
  const std::string friction = std::to_string(3.0 * share * kForce);
  std::string arena = "<box id='load' size='0.2,0.7,0.1' movable='true' mass='" +
                      std::to_string(mass) + "'><body position='" + std::to_string(kAhead) +
                      ",0,0'/></box>";
  for (int i = 0; i < 3; ++i) {
    arena += GripperXml("r" + std::to_string(i), 0.0, 0.2 * (i - 1), 0.0,
                        i < gripping ? "lock='true'" : "", kForce);
  }
  CGripWorld world(arena, {MakeEngine(kDynamics2D, iterations,
                                      "<friction box_linear_friction='" + friction +
                                          "' box_angular_friction='" + friction + "'/>"),
                           10, 0});
  world.Step(3);
  REQUIRE(world.HeldBy("r0") == "load");
  for (int i = 0; i < 3; ++i) {
    world.Drive("r" + std::to_string(i), 100.0 * kSpeed, 100.0 * kSpeed);
  }
  world.Step(20);
  const Real before = world.Position("load").GetX();
  world.Step(20);
  const Real way = world.Position("load").GetX() - before;
  CHECK_THAT(way, WithinAbs(share < 1.0 ? 2.0 * kSpeed : 0.0, 1e-3));
  CHECK_THAT(world.Position("load").GetY(), WithinAbs(0.0, 1e-3));
  CHECK_THAT(world.Yaw("load"), WithinAbs(0.0, 5e-3));
}

TEST_CASE("gripping: a robot tows a chain of as many grips as Newton's method takes, and of more",
          "[contract][engine][grip]") {
  const int count = GENERATE(49, 50);  // robots, of 48 and 49 grips
  CAPTURE(count);
  std::vector<SLink> links{{15.0, -0.05}};
  // the others brake with 10 N in all
  links.resize(count, {10.0 / (count - 1), 0.0});
  CChain chain(kDynamics2D, 0, links, 0.0);
  CheckSpeeds(chain.ComputeSpeeds(240), -0.05, 5e-4);
}

// figures of dynamics2d's README
TEST_CASE("gripping: table of long chains", "[.][table]") {
  for (const int count : {25, 49, 50, 61, 101, 201}) {
    for (const UInt32 iterations : {0U, 10U}) {
      std::vector<SLink> links{{15.0, -0.05}};
      links.resize(count, {10.0 / (count - 1), 0.0});
      const std::vector<Real> speeds =
          CChain(kDynamics2D, iterations, links, 0.0).ComputeSpeeds(240);
      std::printf("%d robots, iterations %u: first %.4f last %.4f m/s\n", count, iterations,
                  speeds.front(), speeds.back());
    }
  }
}

// rows of doc/internals/accuracy.md
TEST_CASE("gripping: table", "[.][table]") {
  constexpr UInt32 kTicks = 300;
  for (const UInt32 iterations : {1U, 2U, 5U, 10U, 50U}) {
    const auto speedOf = [&](const std::vector<SLink>& links) {
      return CChain(kDynamics2D, iterations, links, 25.0).ComputeSpeeds(20).front();
    };
    const auto tow = [&](Real mass, Real left, Real right) {
      return 1e3 * Tow(kDynamics2D, iterations, mass, left, right, kTicks).Place;
    };
    Real circle = 0.0;
    for (const int count : {2, 3, 4}) {
      circle = std::max(circle, Circle(kDynamics2D, iterations, count, false, 1.0, kTicks));
    }
    std::printf("%2u | %.4f %.4f %.4f %.4f %.4f %.4f m/s | %.1f %.1f %.1f mm | %.1f mm\n",
                iterations, speedOf({{15.0, -0.1}, {15.0, 0.0}}),
                speedOf({{15.0, -0.1}, {15.0, 0.05}}),
                speedOf({{15.0, -0.1}, {15.0, -0.1}, {15.0, 0.0}, {15.0, 0.0}}),
                speedOf({{15.0, -0.1}, {13.5, 0.0}}), speedOf({{13.5, -0.1}, {15.0, 0.0}}),
                speedOf({{15.0, -0.1}, {15.0, 0.0}, {15.0, 0.0}}), tow(0.1, -0.08, -0.1),
                tow(5.0, -0.08, -0.1), tow(0.3, 0.08, 0.1), 1e3 * circle);
  }
}

}  // namespace argos::grip_drives_test
