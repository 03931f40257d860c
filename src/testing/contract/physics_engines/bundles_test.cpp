// Objects at the border of two engines are pushed, stop and stay apart as in one engine.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/regions.h>

#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace argos::bundles_test {

using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kFootBotRadius = 0.085036758;
// depth of robots and objects that press each other in any engine: 2 % of the radius
constexpr Real kDeepest = 0.02 * kFootBotRadius;
// m: what is known of contacts is lost when a body changes its engine
constexpr Real kDifference = 3e-4;

std::string ObjectXml(const std::string& id, Real x, Real y, Real sizeX, Real sizeY,
                      bool isMovable = true) {
  std::ostringstream xml;
  xml << std::setprecision(17) << "<box id='" << id << "' size='" << sizeX << "," << sizeY
      << ",0.1' " << (isMovable ? "movable='true' mass='0.2'" : "movable='false'")
      << "><body position='" << x << "," << y << ",0'/></box>";
  return xml.str();
}

std::string Halves(const SEngineType& engine) {
  return RegionXml(engine, "west", {{-20, -20}, {0, -20}, {0, 20}, {-20, 20}}) +
         RegionXml(engine, "east", {{0, -20}, {20, -20}, {20, 20}, {0, 20}});
}

/** Bodies in a row along x, with half of their lengths. */
using TRow = std::vector<std::pair<std::string, Real>>;

/** What happens to a row: its greatest overlap, and where its bodies end. */
struct SOutcome {
  Real Deepest = -HUGE_VAL;  // m
  std::vector<Real> Ends;  // m, x
};

SOutcome Run(const std::string& engines, const std::string& arena, const TRow& row, int ticks) {
  CDriveWorld world(engines, arena);
  SOutcome outcome;
  for (int tick = 0; tick < ticks; ++tick) {
    world.Step();
    for (size_t i = 1; i < row.size(); ++i) {
      const Real gap =
          world.Position(row[i].first).GetX() - world.Position(row[i - 1].first).GetX();
      outcome.Deepest = std::max(outcome.Deepest, row[i].second + row[i - 1].second - gap);
    }
  }
  for (const auto& [id, half] : row) {
    outcome.Ends.push_back(world.Position(id).GetX());
  }
  return outcome;
}

// the same in two engines as in one
void CheckAsInOne(const SSharingEngine& engine, const std::string& arena, const TRow& row,
                  int ticks) {
  const SOutcome one = Run(engine.ToPromptXml(), arena, row, ticks);
  const SOutcome two = Run(Halves(engine), arena, row, ticks);
  CHECK(two.Deepest <= one.Deepest + kDifference);
  for (size_t i = 0; i < row.size(); ++i) {
    CAPTURE(row[i].first, one.Ends[i], two.Ends[i]);
    CHECK(std::abs(one.Ends[i] - two.Ends[i]) <= kDifference);
  }
}

/** Engines of two types whose regions meet at x = 0. */
using TPair = std::pair<SSharingEngine, SSharingEngine>;

std::vector<TPair> ListPairs() {
  std::vector<TPair> pairs;
  for (const SSharingEngine& west : kSharingEngines) {
    for (const SSharingEngine& east : kSharingEngines) {
      if (west.HasGhosts && east.HasGhosts && west.Tag != east.Tag) {
        pairs.emplace_back(west, east);
      }
    }
  }
  return pairs;
}

std::string HalvesOf(const TPair& pair) {
  return RegionXml(pair.first, "west", {{-20, -20}, {0, -20}, {0, 20}, {-20, 20}}) +
         RegionXml(pair.second, "east", {{0, -20}, {20, -20}, {20, 20}, {0, 20}});
}

bool IsSkippedHere(const SSharingEngine& engine) {
  return IsSkipped(engine, engine.HasGhosts, "contacts across borders");
}

}  // namespace

TEST_CASE("bundles: two objects that robots push together at a border stop each other",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  const Real shift = GENERATE(0.0, 0.04, -0.13);  // of all from the border, m
  const bool isFirst = GENERATE(true, false);  // the robots have the lowest indices
  CAPTURE(engine, shift, isFirst);
  if (IsSkippedHere(engine)) {
    return;
  }
  const std::string robots = DriverXml("foot-bot", "a", shift - 0.6, 0, 0, 10, 10) +
                             DriverXml("foot-bot", "b", shift + 0.6, 0, 180, 10, 10);
  const std::string objects =
      ObjectXml("left", shift - 0.3, 0, 0.2, 0.3) + ObjectXml("right", shift + 0.3, 0, 0.2, 0.3);
  const TRow row{{"a", kFootBotRadius}, {"left", 0.1}, {"right", 0.1}, {"b", kFootBotRadius}};
  CheckAsInOne(engine, isFirst ? robots + objects : objects + robots, row, 50);
}

TEST_CASE("bundles: a robot pushes a row of objects over a border, and a wall behind it stops them",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  const bool hasWall = GENERATE(false, true);
  CAPTURE(engine, hasWall);
  if (IsSkippedHere(engine)) {
    return;
  }
  std::string arena = DriverXml("foot-bot", "robot", -0.4, 0, 0, 10, 10);
  TRow row{{"robot", kFootBotRadius}};
  // three boxes whose friction the robot overcomes; the border is below the first
  for (int i = 0; i < 3; ++i) {
    const std::string id = "box" + std::to_string(i);
    arena += ObjectXml(id, -0.15 + 0.21 * i, 0, 0.2, 0.3);
    row.emplace_back(id, 0.1);
  }
  if (hasWall) {
    arena += ObjectXml("wall", 1.0, 0, 0.2, 2.0, false);
    row.emplace_back("wall", 0.1);
  }
  CheckAsInOne(engine, arena, row, 100);
}

TEST_CASE("bundles: an object at rest on a border is pushed from either side",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  const Real side = GENERATE(1.0, -1.0);
  CAPTURE(engine, side);
  if (IsSkippedHere(engine)) {
    return;
  }
  const std::string arena =
      ObjectXml("box", 0, 0, 0.2, 0.3) +
      DriverXml("foot-bot", "robot", side * 0.4, 0, side > 0 ? 180 : 0, 10, 10);
  TRow row{{"robot", kFootBotRadius}, {"box", 0.1}};
  if (side > 0.0) {
    std::reverse(row.begin(), row.end());
  }
  CheckAsInOne(engine, arena, row, 80);
}

TEST_CASE("bundles: a robot far from the border pushes the end of a long object of another engine",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(engine);
  if (IsSkippedHere(engine)) {
    return;
  }
  // its middle is in the west; it reaches 1.5 m into the east
  const std::string arena = ObjectXml("bar", -0.25, 0, 3.5, 0.1) +
                            DriverXml("foot-bot", "robot", 1.9, 0, 180, 10, 10) +
                            DriverXml("foot-bot", "other", 1.2, -0.4, 90, 5, 5) +
                            ObjectXml("fixed", -0.3, 0.2, 0.2, 0.1, false);
  CheckAsInOne(engine, arena, {{"bar", 1.75}, {"robot", kFootBotRadius}}, 40);
}

TEST_CASE("bundles: bodies at borders are the same with any number of threads",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(engine);
  std::string arena;
  for (int i = 0; i < 3; ++i) {
    const Real y = 0.45 * i;
    arena += DriverXml("foot-bot", "a" + std::to_string(i), -0.45, y, 10.0 * i, 10, 10) +
             DriverXml("foot-bot", "b" + std::to_string(i), 0.5, y, 180, 10, 9) +
             ObjectXml("l" + std::to_string(i), -0.15, y + 0.02 * i, 0.2, 0.2) +
             ObjectXml("r" + std::to_string(i), 0.15, y, 0.2, 0.2);
  }
  const auto run = [&](UInt32 threads) {
    CDriveWorld world(Halves(engine), arena, threads);
    std::vector<UInt64> digests;
    for (int second = 0; second < 5; ++second) {
      world.Step(10);
      digests.push_back(world.ComputeDigest());
    }
    world.GetSimulator().Reset();
    world.Step(50);
    digests.push_back(world.ComputeDigest());
    return digests;
  };
  const std::vector<UInt64> alone = run(0);
  CHECK(alone[5] == alone[4]);
  CHECK(run(2) == alone);
}

TEST_CASE("bundles: robots that roam among objects where four regions meet stay out of them",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(engine);
  if (IsSkippedHere(engine)) {
    return;
  }
  constexpr int kSide = 5;
  constexpr Real kRadius = 0.08;
  std::string arena;
  std::vector<std::pair<std::string, Real>> discs;
  for (int i = 0; i < kSide * kSide; ++i) {
    const Real x = 0.32 * (i % kSide - 2.03);
    const Real y = 0.32 * (i / kSide - 1.97);
    const std::string id = "d" + std::to_string(i);
    if (i % 2 == 0) {
      arena += DriverXml("foot-bot", id, x, y, 77.0 * i, 10.0, i % 3 == 0 ? 8.0 : 10.5);
      discs.emplace_back(id, kFootBotRadius);
    } else {
      arena += "<cylinder id='" + id + "' radius='0.08' height='0.1' movable='true' mass='0.2'>" +
               "<body position='" + std::to_string(x) + "," + std::to_string(y) +
               ",0'/></cylinder>";
      discs.emplace_back(id, kRadius);
    }
  }
  CDriveWorld world(RegionXml(engine, "a", {{-20, -20}, {0, -20}, {0, 0}, {-20, 0}}) +
                        RegionXml(engine, "b", {{0, -20}, {20, -20}, {20, 0}, {0, 0}}) +
                        RegionXml(engine, "c", {{-20, 0}, {0, 0}, {0, 20}, {-20, 20}}) +
                        RegionXml(engine, "d", {{0, 0}, {20, 0}, {20, 20}, {0, 20}}),
                    arena);
  Real deepest = -HUGE_VAL;
  int crossings = 0;
  std::vector<std::string> engines(discs.size());
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    for (size_t i = 0; i < discs.size(); ++i) {
      const std::string now = world.EngineOf(discs[i].first);
      crossings += now != engines[i] ? 1 : 0;
      engines[i] = now;
      for (size_t k = 0; k < i; ++k) {
        const CVector3 offset = world.Foot(discs[i].first) - world.Foot(discs[k].first);
        deepest = std::max(
            deepest, discs[i].second + discs[k].second - std::hypot(offset.GetX(), offset.GetY()));
      }
    }
  }
  CHECK(deepest <= kDeepest + engine.Slack);
  CHECK(crossings > 40);
}

TEST_CASE("bundles: a wall between two regions keeps objects on its sides apart",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(engine);
  if (IsSkippedHere(engine)) {
    return;
  }
  const std::string wall = "wall='true'";
  const std::string engines =
      RegionXml(engine, "west", {{-20, -20}, {0, -20, wall}, {0, 20}, {-20, 20}}) +
      RegionXml(engine, "east", {{0, -20}, {20, -20}, {20, 20}, {0, 20, wall}});
  CDriveWorld world(engines, ObjectXml("left", -0.2, 0, 0.2, 0.3) +
                                 ObjectXml("right", 0.101, 0, 0.2, 0.3) +
                                 DriverXml("foot-bot", "robot", -0.5, 0, 0, 10, 10));
  world.Step(60);
  CHECK(world.EngineOf("left") == "west");
  CHECK(world.EngineOf("right") == "east");
  CHECK_THAT(world.Position("left").GetX(), WithinAbs(-0.1, kDeepest + engine.Slack));
  CHECK_THAT(world.Position("right").GetX(), WithinAbs(0.101, engine.Slack));
}

namespace {

std::string RobotAndBoxXml() {
  return DriverXml("foot-bot", "robot", -0.3, 0, 0, 10, 10) + ObjectXml("box", 0.05, 0, 0.2, 0.3);
}

// The robot pushes the box across the border, and drives back.
void CheckReturnToRegions(CDriveWorld& world) {
  world.Step(25);
  // the box is in the robot's engine as long as they touch
  CHECK(world.EngineOf("robot") == "west");
  CHECK(world.EngineOf("box") == "west");
  world.Driver("robot").Left = world.Driver("robot").Right = -10.0;
  world.Step(20);
  CHECK(world.EngineOf("robot") == "west");
  CHECK(world.EngineOf("box") == "east");
}

}  // namespace

TEST_CASE("bundles: bodies return to the engines of their regions",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(engine);
  if (IsSkippedHere(engine)) {
    return;
  }
  CDriveWorld world(Halves(engine), RobotAndBoxXml());
  CheckReturnToRegions(world);
}

TEST_CASE("bundles: objects at the border of two types of engines are pushed as in one",
          "[contract][engine][partition]") {
  const TPair pair = GENERATE(from_range(ListPairs()));
  const Real side = GENERATE(1.0, -1.0);  // from which the robot pushes
  CAPTURE(pair.first, pair.second, side);
  const auto driver = [](const std::string& id, Real x, Real yaw) {
    return DriverXml("foot-bot", id, x, 0, yaw, 10, 10);
  };
  // three boxes whose friction the robot overcomes, and a wall beyond the border
  std::string row = driver("robot", -0.4 * side, side > 0.0 ? 0 : 180) +
                    ObjectXml("wall", 1.0 * side, 0, 0.2, 2.0, false);
  TRow bodies{{"robot", kFootBotRadius}};
  for (int i = 0; i < 3; ++i) {
    const std::string id = "box" + std::to_string(i);
    row += ObjectXml(id, side * (-0.15 + 0.21 * i), 0, 0.2, 0.3);
    bodies.emplace_back(id, 0.1);
  }
  bodies.emplace_back("wall", 0.1);
  if (side < 0.0) {
    std::reverse(bodies.begin(), bodies.end());
  }
  const std::string engines = HalvesOf(pair);
  const SOutcome one = Run(pair.first.ToPromptXml(), row, bodies, 100);
  const SOutcome two = Run(engines, row, bodies, 100);
  CHECK(two.Deepest <= kDifference);
  for (size_t i = 0; i < bodies.size(); ++i) {
    CAPTURE(bodies[i].first, one.Ends[i], two.Ends[i]);
    CHECK(std::abs(one.Ends[i] - two.Ends[i]) <= kDifference);
  }
}

TEST_CASE("bundles: two objects pushed together at the border of two types of engines stop",
          "[contract][engine][partition]") {
  const TPair pair = GENERATE(from_range(ListPairs()));
  CAPTURE(pair.first, pair.second);
  const std::string arena = DriverXml("foot-bot", "a", -0.57, 0, 0, 10, 10) +
                            DriverXml("foot-bot", "b", 0.63, 0, 180, 10, 10) +
                            ObjectXml("left", -0.27, 0, 0.2, 0.3) +
                            ObjectXml("right", 0.33, 0, 0.2, 0.3);
  const TRow row{{"a", kFootBotRadius}, {"left", 0.1}, {"right", 0.1}, {"b", kFootBotRadius}};
  const SOutcome outcome = Run(HalvesOf(pair), arena, row, 60);
  CHECK(outcome.Deepest <= kDifference);
  CHECK_THAT(outcome.Ends[1], WithinAbs(0.03 - 0.1, kDifference));
  CHECK_THAT(outcome.Ends[2], WithinAbs(0.03 + 0.1, kDifference));
}

TEST_CASE("bundles: bodies return to the type of engine of their region",
          "[contract][engine][partition]") {
  const TPair pair = GENERATE(from_range(ListPairs()));
  CAPTURE(pair.first, pair.second);
  CDriveWorld world(HalvesOf(pair), RobotAndBoxXml());
  const UInt64 start = world.ComputeDigest();
  CheckReturnToRegions(world);
  world.GetSimulator().Reset();
  CHECK(world.EngineOf("box") == "east");
  CHECK(world.ComputeDigest() == start);
}

TEST_CASE("bundles: bodies of two types of engines that share space do not meet",
          "[contract][engine][partition]") {
  const TPair pair = GENERATE(from_range(ListPairs()));
  CAPTURE(pair.first, pair.second);
  // both types in the west; the first one in the east, so that there is a border
  const std::string engines =
      HalvesOf({pair.first, pair.first}) +
      RegionXml(pair.second, "shared", {{-20, -20}, {0, -20}, {0, 20}, {-20, 20}});
  // the robot is too far from the border to be a ghost
  CDriveWorld world(engines, DriverXml("foot-bot", "robot", -2.0, 0, 0, 0, 0) +
                                 ObjectXml("box", -0.9, 0, 1.6, 0.3));
  auto& robot = world.Body("robot");
  CHECK(world.EngineOf("box") == "west");
  CHECK(world.EngineOf("robot") == "west");
  CPhysicsEngine& shared = world.GetSimulator().GetPhysicsEngine("shared");
  world.GetSimulator().GetPhysicsEngine("west").RemoveEntity(robot.GetRootEntity());
  shared.AddEntity(robot.GetRootEntity());
  world.Driver("robot").Left = world.Driver("robot").Right = 10.0;
  world.Step(30);
  CHECK(world.EngineOf("robot") == "shared");
  CHECK_THAT(world.Position("box").GetX(), WithinAbs(-0.9, 1e-6));
}

}  // namespace argos::bundles_test
