// Grips while robots and loads are moved, removed, reset and transferred to other engines; chains,
// rings and random orders.

#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/contract/physics_engines/grip_world.h>
#include <argos3/testing/support/digests.h>
#include <argos3/testing/support/robot_sizes.h>
#include <argos3/testing/support/sanitizers.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_entity.h>
#include <argos3/plugins/robots/foot-bot/simulator/footbot_turret_entity.h>
#include <argos3/plugins/simulator/entities/box_entity.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>
#include <memory>

namespace argos::grip_lifecycle_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kRadius = kFootBotRadius;
constexpr Real kGap = 0.005;  // m
constexpr Real kAhead = kRadius + kGap + 0.1;
constexpr Real kPitch = 2.0 * kRadius + kGap;

CGripWorld::SOptions In(const std::string& engine, UInt32 threads = 0) {
  CGripWorld::SOptions options;
  options.Engine = engine;
  options.Threads = threads;
  return options;
}

bool IsFinite(const CVector3& v) {
  return std::isfinite(v.GetX()) && std::isfinite(v.GetY()) && std::isfinite(v.GetZ());
}

std::string EngineOf(CGripWorld& world, const std::string& id) {
  return world.Body(id).GetPhysicsModel(0).GetEngine().GetId();
}

// robot r holds b, which holds box
std::string ChainXml() {
  return GripperXml("r", 0, 0, 0, "lock='true'") + GripperXml("b", kPitch, 0, 0, "lock='true'") +
         LoadXml("box", kPitch + kAhead, 0, 0.3);
}

// a ring of robots, each facing the next
std::string RingXml(int robots, Real x, Real y, const std::string& params, Real torque = 150.0) {
  const Real radius = 0.5 * kPitch / std::sin(ARGOS_PI / robots);
  const Real chord = 0.5 * ARGOS_PI + ARGOS_PI / robots;
  std::string arena;
  for (int i = 0; i < robots; ++i) {
    const Real angle = 2.0 * ARGOS_PI * i / robots;
    arena += GripperXml("ring" + std::to_string(i), x + radius * std::cos(angle),
                        y + radius * std::sin(angle), (angle + chord) * 180.0 / ARGOS_PI, params,
                        15.0, torque);
  }
  return arena;
}

}  // namespace

TEST_CASE("grip lifecycle: moving a body by a command releases its grips",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  CGripWorld world(ChainXml(), In(engine.ToXml()));
  world.Step(2);
  REQUIRE(world.HeldBy("r") == "b");
  REQUIRE(world.HeldBy("b") == "box");
  REQUIRE(world.Body("b").MoveTo(CVector3(5, 0, 0), CQuaternion()));
  CHECK(world.HeldBy("r").empty());
  CHECK(world.HeldBy("b").empty());
  // the grippers are still locked and grip the next bodies in reach
  CHECK(world.Body("b").MoveTo(CVector3(kPitch, 0, 0), CQuaternion()));
  world.Step();
  CHECK(world.HeldBy("r") == "b");
  CHECK(world.HeldBy("b") == "box");
  // moving a load
  CHECK(world.Body("box").MoveTo(CVector3(3, 3, 0), CQuaternion()));
  CHECK(world.HeldBy("b").empty());
  CHECK(world.HeldBy("r") == "b");
}

TEST_CASE("grip lifecycle: testing a place for collisions changes nothing",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  CGripWorld world(ChainXml() +
                       "<box id='wall' size='1,1,1' movable='false'><body "
                       "position='5,5,0'/></box>",
                   In(engine.ToXml()));
  CGripWorld undisturbed(ChainXml() +
                             "<box id='wall' size='1,1,1' movable='false'><body "
                             "position='5,5,0'/></box>",
                         In(engine.ToXml()));
  for (CGripWorld* each : {&world, &undisturbed}) {
    each->Step(2);
    each->Drive("r", -5, -5);
    each->Drive("b", -5, -5);
    each->Step(20);
  }
  for (const std::string id : {"r", "b", "box"}) {
    CHECK(world.Body(id).MoveTo(CVector3(8, 8, 0), CQuaternion(), true));
    CHECK_FALSE(world.Body(id).MoveTo(CVector3(5, 5, 0), CQuaternion()));
  }
  CHECK(world.HeldBy("r") == "b");
  CHECK(world.HeldBy("b") == "box");
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    undisturbed.Step();
    REQUIRE(world.ComputeDigest() == undisturbed.ComputeDigest());
  }
}

TEST_CASE("grip lifecycle: removing a body releases its grips", "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  CGripWorld world(ChainXml(), In(engine.ToXml()));
  world.Step(2);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("box");
  CHECK(world.HeldBy("b").empty());
  CHECK(world.HeldBy("r") == "b");
  world.Step(5);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("b");
  CHECK(world.HeldBy("r").empty());
  CHECK_THROWS_WITH(world.Gripper("r").GetGrippedEntity(), Contains("holds nothing"));
  world.Step(5);
  // a load that comes into reach later is gripped, also one that replaces another
  world.GetSimulator().GetLoopFunctions().AddEntity(
      *std::make_unique<CBoxEntity>("new", CVector3(kAhead, 0, 0), CQuaternion(), true,
                                    CVector3(0.2, 0.2, 0.1), 0.3)
           .release());
  world.Step();
  CHECK(world.HeldBy("r") == "new");
  world.GetSimulator().GetLoopFunctions().RemoveEntity("r");
  world.Step(5);
  CHECK_THAT(world.Position("new").GetX(), WithinAbs(kAhead, engine.Slack));
}

TEST_CASE("grip lifecycle: components created during a run work at once",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  CGripWorld world(LoadXml("box", kAhead, 0, 0.3) + GripperXml("other", 5, 5, 0, ""),
                   In(engine.ToXml()));
  auto& robot = *new CFootBotEntity("r", "");
  world.GetSimulator().GetLoopFunctions().AddEntity(robot);
  world.Step(3);
  robot.GetGripperEquippedEntity().SetLockState(1.0);
  world.Step();
  CHECK(world.HeldBy("r") == "box");
  robot.GetTurretEntity().SetMode(CTurretEntity::MODE_SPEED_CONTROL);
  robot.GetTurretEntity().SetDesiredRotationSpeed(0.1);
  world.Step(10);
  CHECK_THAT(robot.GetTurretEntity().GetRotation().GetValue(), WithinAbs(0.1, 1e-3 + engine.Slack));
  // clearing the gripped entity releases the grip
  robot.GetGripperEquippedEntity().ClearGrippedEntity();
  robot.GetGripperEquippedEntity().SetLockState(0.0);
  world.Step(2);
  CHECK(world.HeldBy("r").empty());
}

TEST_CASE("grip lifecycle: a reset releases all grips, and the run repeats bit by bit",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  CGripWorld world(ChainXml() + RingXml(6, 2, 2, "lock='true' random='true'"), In(engine.ToXml()));
  const std::vector<UInt64> first = RecordDigests(world, 200);
  REQUIRE(world.HeldBy("r") == "b");
  world.GetSimulator().Reset();
  CHECK(world.HeldBy("r").empty());
  CHECK(world.ComputeDigest() == first[0]);
  for (int tick = 0; tick < 200; ++tick) {
    world.Step();
    REQUIRE(world.ComputeDigest() == first[tick + 1]);
  }
}

TEST_CASE("grip lifecycle: Reset() of one robot releases its grip and turns its turret back",
          "[contract][engine][grip][turret]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  const bool hasLoad = GENERATE(false, true);
  CAPTURE(engine, hasLoad);
  CGripWorld world(
      GripperXml("r", 0, 0, 0, "lock='true'") + (hasLoad ? LoadXml("load", kAhead, 0, 0.3) : ""),
      In(engine.ToXml()));
  world.Body("r").EnableAnchor("turret");
  world.Step(3);
  REQUIRE(world.HeldBy("r") == (hasLoad ? "load" : ""));
  world.Driver("r").Mode = CCI_FootBotTurretActuator::MODE_SPEED_CONTROL;
  world.Driver("r").TurretSpeed = 3;
  world.Step(11);
  // 3 turns a minute for 1 s; with a load the motor has to accelerate it first
  REQUIRE_THAT(world.Turret("r").GetRotation().GetValue(), WithinAbs(0.1 * ARGOS_PI, 0.05));
  const auto isAtStart = [&world] {
    return world.Turret("r").GetRotation() == CRadians::ZERO &&
           world.Body("r").GetAnchor("turret").Orientation ==
               world.Body("r").GetOriginAnchor().Orientation;
  };
  world.Get<CFootBotEntity>("r").Reset();
  CHECK(world.HeldBy("r").empty());
  CHECK(isAtStart());
  // also with the load, if it is gripped again
  world.Step(5);
  CHECK_THAT(world.Turret("r").GetRotation().GetValue(), WithinAbs(0.0, engine.Slack + 2e-3));
}

TEST_CASE("grip lifecycle: results do not depend on the number of threads",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  // a ring in the western half and a chain at the border
  const std::string arena = RingXml(5, -2, 0, "random='true'") + ChainXml();
  const auto digests = [&](UInt32 threads) {
    CGripWorld world(arena, In(engine.ToTwoXml(0.0), threads));
    std::vector<UInt64> result;
    for (int tick = 0; tick < 300; ++tick) {
      world.Step();
      result.push_back(world.ComputeDigest());
    }
    return result;
  };
  const std::vector<UInt64> alone = digests(0);
  CHECK(digests(1) == alone);
  CHECK(digests(3) == alone);
}

TEST_CASE("grip lifecycle: connected bodies cross a border of engines together",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  const Real speed = GENERATE(-0.05, 0.05);  // m/s: load first or robot first
  CAPTURE(speed);
  const CGripWorld::SOptions options = In(engine.ToTwoXml(0.0));
  // starts 10 cm before the border
  const Real start = speed > 0.0 ? -0.4 : 0.1;
  CGripWorld world(
      GripperXml("r", start, 0, 0, "lock='true'") + LoadXml("box", start + kAhead, 0, 0.3),
      options);
  const CGripWorld::TPoses before = world.GetPoses();
  world.Step(2);
  REQUIRE(world.HeldBy("r") == "box");
  const CGripGauge gauge(world, "r", before);
  world.Drive("r", 100.0 * speed, 100.0 * speed);
  world.Step(20);
  CVector3 last = world.Position("box");
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    REQUIRE(world.HeldBy("r") == "box");
    REQUIRE(EngineOf(world, "r") == EngineOf(world, "box"));
    if (engine.GripRigidity > 0.0) {
      const Real stretch = engine.GetHold(0.3) / engine.GripRigidity;
      REQUIRE_THAT(gauge.Stretch(), WithinAbs((speed < 0 ? 1.0 : -1.0) * stretch, 2e-5));
      REQUIRE_THAT(world.Position("box").GetX() - last.GetX(), WithinAbs(0.1 * speed, 2e-5));
    }
    last = world.Position("box");
  }
  CHECK(EngineOf(world, "r") == (speed > 0.0 ? "east" : "west"));
  // except for the tick of the order and the stretch; a load that can tilt swings
  CHECK_THAT(world.Position("box").GetX() - start - kAhead - 12.0 * speed,
             WithinAbs(0.0, 0.006 + 5.0 * engine.Slack));
  // a load across the border and the robot near it are moved by one engine, so it can be gripped
  CGripWorld other(
      GripperXml("r", 0.05, 0, 180, "lock='true'") + LoadXml("box", 0.05 - kAhead, 0, 0.3),
      options);
  other.Step(2);
  CHECK(other.HeldBy("r") == "box");
}

TEST_CASE("grip lifecycle: a load released beyond the border is transferred to its own engine",
          "[contract][engine][grip]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithGrips));
  CAPTURE(engine);
  // The robot decides about the engine, because it is older. It backs across the border; the load
  // behind it does not reach the border.
  CGripWorld world(
      GripperXml("r", 0.05, 0, 0, "lock='true'") + LoadXml("box", 0.05 + kAhead, 0, 0.3),
      In(engine.ToTwoXml(0.0)));
  world.Drive("r", -5, -5);
  world.Step(32);
  REQUIRE(world.Position("r").GetX() < 0.0);
  REQUIRE(world.Position("box").GetX() > 0.0);
  REQUIRE(world.HeldBy("r") == "box");
  CHECK(EngineOf(world, "box") == "west");
  world.Driver("r").Lock = false;
  // until the robot, which drives away, can no longer touch it
  world.Step(15);
  CHECK(EngineOf(world, "box") == "east");
  CHECK(EngineOf(world, "r") == "west");
}

namespace {

/** Measures all grips of a world, tick by tick. */
class CGripWatch {
 public:
  explicit CGripWatch(CGripWorld& world) : m_world(world), m_before(world.GetPoses()) {
    for (const auto& [id, pose] : m_before) {
      if (world.GetSpace().GetEntity(id).GetTypeDescription() == "foot-bot") {
        m_robots.push_back(id);
      }
    }
  }

  void Step() {
    m_world.Step();
    CGripWorld::TPoses now = m_world.GetPoses();
    const Real tick = m_world.GetSimulator().GetTickLength();
    for (const auto& [id, pose] : now) {
      REQUIRE(IsFinite(pose.Position));
      REQUIRE(std::isfinite(pose.Turret.GetZ()));
      Fastest = std::max(Fastest, Distance(pose.Position, m_before.at(id).Position) / tick);
    }
    for (const std::string& robot : m_robots) {
      const std::string held = m_world.HeldBy(robot);
      const auto gauge = m_gauges.find(robot);
      if (gauge != m_gauges.end() && gauge->second.GetHeld().GetRootEntity().GetId() != held) {
        m_gauges.erase(gauge);
      }
      if (!held.empty()) {
        m_gauges.try_emplace(robot, m_world, robot, m_before);
      }
    }
    for (const auto& [robot, gauge] : m_gauges) {
      Stretch = std::max(Stretch, std::abs(gauge.Stretch()));
      Sideways = std::max(Sideways, std::abs(gauge.Sideways()));
      ++TicksHeld;
    }
    m_before = std::move(now);
  }

  // Checks that robots hold something for some of the time: they let go at random, and drive away.
  void StepForMinutes(UInt32 ticksPerSecond) {
    const UInt32 ticks = FewerIfSanitized(ticksPerSecond == 10 ? 6000 : 10000);
    for (UInt32 tick = 0; tick < ticks; ++tick) {
      Step();
    }
    CHECK(TicksHeld > m_robots.size() * ticks / 20);
  }

  // maxima so far
  Real Stretch = 0.0;  // m
  Real Sideways = 0.0;  // m
  Real Fastest = 0.0;  // m/s
  size_t TicksHeld = 0;  // summed over robots

 private:
  CGripWorld& m_world;
  std::vector<std::string> m_robots;
  std::map<std::string, CGripGauge> m_gauges;  // of robots that hold something
  CGripWorld::TPoses m_before;
};

// pairs of robots with a load between them, and a ring of robots
std::string CrowdXml(const std::string& params, Real torque) {
  std::string arena = RingXml(6, -2, -2, params, torque);
  Real y = 0.0;
  for (const Real mass : {0.1, 1.0, 10.0}) {
    const std::string number = std::to_string(static_cast<int>(y));
    arena += GripperXml("a" + number, 0, y, 0, params, 15.0, torque) +
             LoadXml("box" + number, kAhead, y, mass) +
             GripperXml("b" + number, 2.0 * kAhead, y, 180, params, 15.0, torque);
    y += 2.0;
  }
  return arena;
}

}  // namespace

TEST_CASE("grip lifecycle: minutes of random orders leave every grip intact",
          "[contract][engine][grip]") {
  const UInt32 ticksPerSecond = GENERATE(10U, 100U);
  CAPTURE(ticksPerSecond);
  constexpr Real kTorque = 1.0;  // N m
  CGripWorld world(CrowdXml("lock='true' random='true' turret='false'", kTorque),
                   {.TicksPerSecond = ticksPerSecond});
  CGripWatch watch(world);
  watch.StepForMinutes(ticksPerSecond);
  CAPTURE(watch.Stretch, watch.Sideways, watch.Fastest);
  // the joint force of the drives of the ring's six robots, at the rims of the robots they hold
  const Real longest = 6.0 * (15.0 + kTorque / kRadius) / 1e4;
  CHECK(watch.Stretch <= longest);
  // rigid across the arm, except for the solver's error
  CHECK(watch.Sideways <= 5e-3);
  // wheels turn at 15 cm/s, and a spring stretched that far accelerates a robot of 1.6 kg
  CHECK(watch.Fastest <= 0.15 + longest * std::sqrt(1e4 / 1.6));
}

TEST_CASE("grip lifecycle: opposed motors of 150 N m break grips only",
          "[contract][engine][grip]") {
  const UInt32 ticksPerSecond = GENERATE(10U, 100U);
  CAPTURE(ticksPerSecond);
  // turrets are random too; at a lever of 9 cm their motors exert 1,700 N
  CGripWorld world(CrowdXml("lock='true' random='true'", 150.0),
                   {.TicksPerSecond = ticksPerSecond});
  CGripWatch watch(world);
  watch.StepForMinutes(ticksPerSecond);
  CAPTURE(watch.Stretch, watch.Sideways, watch.Fastest);
  // a grip bears 10 kN, which stretch it by 1 m
  CHECK(watch.Stretch <= 1.0);
  CHECK(watch.Sideways <= 0.05);
}

}  // namespace argos::grip_lifecycle_test
