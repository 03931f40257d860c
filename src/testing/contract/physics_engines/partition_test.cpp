// Engines that share space: walls, gates, bodies that cross borders or overlap them.

#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/regions.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/simulator/physics_engine/physics_engine.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace argos::physics_engines_partition_test {

using Catch::Matchers::WithinAbs;

namespace {

const std::string kWall = "wall='true'";

std::vector<std::string> EnginesOf(CDriveWorld& world, const std::string& id) {
  std::set<std::string> ids;
  for (UInt32 i = 0; i < world.Body(id).GetPhysicsModelsNum(); ++i) {
    ids.insert(world.Body(id).GetPhysicsModel(size_t(i)).GetEngine().GetId());
  }
  return {ids.begin(), ids.end()};
}

const std::vector<SCorner> kWest = {{-20, -20}, {0, -20}, {0, 20}, {-20, 20}};
const std::vector<SCorner> kEast = {{0, -20}, {20, -20}, {20, 20}, {0, 20}};

std::string BoxXml(const std::string& id, const std::string& size, Real x, Real y) {
  std::ostringstream xml;
  xml << "<box id='" << id << "' size='" << size << "' movable='false'><body position='" << x << ","
      << y << ",0'/></box>";
  return xml.str();
}

// regions of engines of one type may not overlap
std::vector<std::pair<SSharingEngine, SSharingEngine>> PairsThatMayOverlap() {
  std::vector<std::pair<SSharingEngine, SSharingEngine>> pairs;
  for (const SSharingEngine& engine : kSharingEngines) {
    for (const SSharingEngine& other : kSharingEngines) {
      if (engine.Tag != other.Tag) {
        pairs.emplace_back(engine, other);
      }
    }
  }
  return pairs;
}

std::vector<SSharingEngine> EnginesWithMomentum() {
  std::vector<SSharingEngine> engines;
  for (const SSharingEngine& engine : kSharingEngines) {
    if (!IsSkipped(engine, engine.HasMomentum, "momentum")) {
      engines.push_back(engine);
    }
  }
  return engines;
}

// engines on both sides of the border at x = 0, without friction of objects
std::string SlipperyXml(const SSharingEngine& west, const SSharingEngine& east) {
  return west.ToBrakingXml(0.0, 1.0, "west", Boundaries(kWest)) +
         east.ToBrakingXml(0.0, 1.0, "east", Boundaries(kEast));
}

}  // namespace

TEST_CASE("walls: a region with walls keeps robots inside", "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  if (IsSkipped(engine, engine.HasWalls, "walls of regions")) {
    return;
  }
  // a square region in three orientations; eight robots drive towards its walls
  const Real turn = GENERATE(0.0, 0.25, 0.1);  // of pi
  CAPTURE(engine, turn);
  std::vector<SCorner> corners;
  for (int i = 0; i < 4; ++i) {
    const Real angle = ARGOS_PI * (turn + 0.5 * i);
    corners.push_back({std::cos(angle), std::sin(angle), kWall});
  }
  std::string robots;
  for (int i = 0; i < 8; ++i) {
    const Real angle = ARGOS_PI * (turn + 0.05 + 0.25 * i);
    robots += DriverXml("e-puck", "r" + std::to_string(i), 0.3 * std::cos(angle),
                        0.3 * std::sin(angle), 180.0 * (turn + 0.05 + 0.25 * i), 12, 12);
  }
  CDriveWorld world(RegionXml(engine, "pen", corners), robots);
  for (int tick = 0; tick < 200; ++tick) {
    world.Step();
    for (int i = 0; i < 8; ++i) {
      const CVector3 position = world.Position("r" + std::to_string(i));
      for (size_t k = 0; k < 4; ++k) {
        // the sides of a square of circumradius 1 are 1 / sqrt(2) from its centre
        const Real angle = ARGOS_PI * (turn + 0.5 * k + 0.25);
        const Real out = position.GetX() * std::cos(angle) + position.GetY() * std::sin(angle);
        // The limit of engines is 2 % of the radius, also where walls meet in a corner; a tilted
        // robot has its base ahead of its origin.
        REQUIRE(out <= std::sqrt(0.5) - 0.98 * kEPuckRadius + engine.Slack);
      }
    }
  }
  // robots are not just kept from moving: at least one reaches a side
  Real farthest = 0.0;
  for (int i = 0; i < 8; ++i) {
    farthest = std::max(farthest, world.Position("r" + std::to_string(i)).Length());
  }
  CHECK(farthest > std::sqrt(0.5) - 1.05 * kEPuckRadius);
}

TEST_CASE("walls: a robot passes the gate in a wall, and is stopped beside it",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  if (IsSkipped(engine, engine.HasWalls, "walls of regions")) {
    return;
  }
  CAPTURE(engine);
  // the gate extends from y = -0.2 to 0.2
  const std::string west = RegionXml(
      engine, "west",
      {{-2, -2}, {0, -2, kWall}, {0, -0.2, "gate='east'"}, {0, 0.2, kWall}, {0, 2}, {-2, 2}});
  const std::string east = RegionXml(
      engine, "east",
      {{0, 2, kWall}, {0, 0.2, "gate='west'"}, {0, -0.2, kWall}, {0, -2}, {2, -2}, {2, 2}});
  CDriveWorld world(west + east, DriverXml("foot-bot", "through", -0.5, 0.02, 0, 10, 10) +
                                     DriverXml("foot-bot", "beside", -0.5, 1, 0, 10, 10) +
                                     DriverXml("foot-bot", "back", 0.5, -1, 180, 10, 10));
  world.Step(101);
  CHECK(world.EngineOf("through") == "east");
  CHECK_THAT(world.Position("through").GetX(), WithinAbs(0.5, 1e-6 + engine.Slack));
  CHECK(world.EngineOf("beside") == "west");
  CHECK_THAT(world.Position("beside").GetX(), WithinAbs(-kFootBotRadius, 0.02 * kFootBotRadius));
  CHECK(world.EngineOf("back") == "east");
  CHECK_THAT(world.Position("back").GetX(), WithinAbs(kFootBotRadius, 0.02 * kFootBotRadius));
}

TEST_CASE("walls: the walls of a region stop a flying robot", "[contract][flight][partition]") {
  const std::string region =
      Boundaries({{-1, -1, kWall}, {1, -1, kWall}, {1, 1, kWall}, {-1, 1, kWall}},
                 "<top height='2' wall='true'/><bottom height='0.5' wall='true'/>");
  // tests the volume directly, with a position beyond the walls and an outward velocity
  CDriveWorld world(
      "<pointmass3d id='air' gravity='0'>" + region + "</pointmass3d>",
      "<box id='b' size='0.1,0.1,0.1' movable='false'><body position='0,0,1'/></box>");
  SVolume& volume = world.GetSimulator().GetPhysicsEngine("air").GetVolume();
  CVector3 position(0.9, -2.0, 1.8);
  CVector3 velocity(1.0, -3.0, 2.0);
  REQUIRE(volume.HoldInside(position, velocity, 0.25, 0.5));
  // the position is inside by the robot's radius and height, and the
  // velocity into the walls is removed
  CHECK(Distance(position, CVector3(0.75, -0.75, 1.5)) <= 1e-12);
  CHECK(velocity == CVector3());
  CHECK_FALSE(volume.HoldInside(position, velocity, 0.25, 0.5));
}

TEST_CASE("gates: the named engine adopts the robot, even if another one comes first",
          "[contract][engine][partition]") {
  const auto pair = GENERATE(from_range(PairsThatMayOverlap()));
  const SSharingEngine& engine = pair.first;
  const SSharingEngine& other = pair.second;
  const bool hasGate = GENERATE(true, false);
  CAPTURE(engine, other, hasGate);
  const std::vector<SCorner> east = {{0, -2}, {2, -2}, {2, 2}, {0, 2}};
  const std::string engines =
      RegionXml(other, "first", east) +
      RegionXml(engine, "west",
                {{-2, -2}, {0, -2, hasGate ? "gate='second'" : ""}, {0, 2}, {-2, 2}}) +
      RegionXml(engine, "second", east);
  CDriveWorld world(engines, DriverXml("foot-bot", "r", -0.5, 0, 0, 10, 10));
  world.Step(101);
  CHECK(world.EngineOf("r") == (hasGate ? "second" : "first"));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.5, 1e-6 + engine.Slack + other.Slack));
}

TEST_CASE("gates: a reset returns bodies to their first engine, not through gates",
          "[contract][engine][partition]") {
  const auto pair = GENERATE(from_range(PairsThatMayOverlap()));
  const SSharingEngine& engine = pair.first;
  const SSharingEngine& other = pair.second;
  CAPTURE(engine, other);
  const std::vector<SCorner> east = {{0, -2}, {2, -2}, {2, 2}, {0, 2}};
  const auto engines = [&](const std::string& gate) {
    return RegionXml(other, "first", {{0, -2, gate}, {2, -2}, {2, 2}, {0, 2}}) +
           RegionXml(engine, "west", {{-2, -2}, {0, -2, "gate='second'"}, {0, 2}, {-2, 2}}) +
           RegionXml(engine, "second", east);
  };
  CHECK_THROWS_WITH(CDriveWorld(engines("gate='west'"), ""),
                    Catch::Contains("does not lead into the region"));
  CDriveWorld world(engines(""), DriverXml("foot-bot", "r", 0.3, 0, 180, 10, 10));
  REQUIRE(world.EngineOf("r") == "first");
  std::vector<UInt64> digests;
  for (int run = 0; run < 2; ++run) {
    world.Step(61);
    CHECK(world.EngineOf("r") == "west");
    digests.push_back(world.ComputeDigest());
    world.GetSimulator().Reset();
    CHECK(world.EngineOf("r") == "first");
  }
  CHECK(digests[0] == digests[1]);
}

TEST_CASE(
    "gates: a robot that crosses a corner between gates is transferred to the region it is in",
    "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(engine);
  const std::string engines =
      RegionXml(engine, "a", {{-2, -2}, {0, -2, "gate='b'"}, {0, 0, "gate='c'"}, {-2, 0}}) +
      RegionXml(engine, "b", {{0, -2}, {2, -2}, {2, 0}, {0, 0}}) +
      RegionXml(engine, "c", {{-2, 0}, {0, 0}, {0, 2}, {-2, 2}}) +
      RegionXml(engine, "d", {{0, 0}, {2, 0}, {2, 2}, {0, 2}});
  // across the corner at 45 degrees, with an offset so that no tick ends on the corner
  CDriveWorld world(engines, DriverXml("foot-bot", "r", -0.503, -0.503, 45, 10, 10));
  world.Step(101);
  CHECK(world.EngineOf("r") == "d");
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(-0.503 + std::sqrt(0.5), 1e-6 + engine.Slack));
}

TEST_CASE("borders: a robot that crosses borders keeps the path of one without borders",
          "[contract][engine][partition]") {
  const SSharingEngine west = GENERATE(from_range(kSharingEngines));
  const SSharingEngine east = GENERATE(from_range(kSharingEngines));
  CAPTURE(west, east);
  const std::string engines = RegionXml(west, "west", kWest) + RegionXml(east, "east", kEast);
  // An e-puck at 60 cm/s needs two ticks to accelerate from rest: if a border reset its speed, the
  // robot would fall behind. The circle has a radius of 0.6 m / (20 cm/s / 5.3 cm), and the border
  // crosses it twice per turn.
  const std::string robot = DriverXml("e-puck", "r", -0.005, 0.1, 200, 60, 80);
  CDriveWorld split(engines, robot);
  CDriveWorld whole(west.ToPromptXml(), robot);
  int crossings = 0;
  std::string last = split.EngineOf("r");
  for (int tick = 0; tick < 200; ++tick) {
    split.Step();
    whole.Step();
    const std::string now = split.EngineOf("r");
    crossings += now != last ? 1 : 0;
    last = now;
    REQUIRE((now == "east") == (split.Position("r").GetX() > 0.0));
    if (west.KeepsSpeed == east.KeepsSpeed && west.Slip == 0.0 && east.Slip == 0.0) {
      // one rounding per tick
      REQUIRE(Distance(split.Position("r"), whole.Position("r")) <= 1e-9);
    }
  }
  CHECK(crossings >= 4);
  CHECK(split.GetSimulator().GetPhysicsEngine("west").GetNumPhysicsModels() +
            split.GetSimulator().GetPhysicsEngine("east").GetNumPhysicsModels() ==
        1);
}

TEST_CASE("borders: a robot that crosses them keeps its heading and its speed in every tick",
          "[contract][engine][partition]") {
  const SSharingEngine west = GENERATE(from_range(kSharingEngines));
  const SSharingEngine east = GENERATE(from_range(kSharingEngines));
  const std::string robot = GENERATE(as<std::string>(), "e-puck", "foot-bot");
  CAPTURE(west, east, robot);
  const std::string engines = RegionXml(west, "west", kWest) + RegionXml(east, "east", kEast);
  // across the border and later back
  CDriveWorld world(engines, DriverXml(robot, "r", -0.503, 0.2, 20, 10, 10));
  Real last = 0.0;
  CVector3 place = world.Position("r");
  std::string visited;
  for (int tick = 0; tick < 250; ++tick) {
    if (tick == 120) {
      world.Driver("r").Left = world.Driver("r").Right = -10.0;
    }
    world.Step();
    if (const std::string now = world.EngineOf("r");
        visited.find(now, visited.size() < 4 ? 0 : visited.size() - 4) == std::string::npos) {
      visited += now;
    }
    const Real way = Distance(world.Position("r"), place);
    place = world.Position("r");
    // the speed of its wheels, with a slip of 5 %, except after the start and the reversal
    if (tick > 3 && (tick < 120 || tick > 125)) {
      REQUIRE_THAT(way, WithinAbs(0.01, 1e-6 + (west.Slip + east.Slip > 0.0 ? 0.05 * 0.01 : 0.0)));
    }
    last = way;
  }
  CHECK(last > 0.009);
  CHECK(visited == "westeastwest");
  CHECK_THAT(world.Yaw("r"),
             WithinAbs(20.0 / 180.0 * ARGOS_PI, 1e-6 + 2.0 * (west.Slack + east.Slack)));
}

TEST_CASE("borders: a robot at full speed keeps it in an engine where robots accelerate slowly",
          "[contract][engine][partition]") {
  const SSharingEngine west = GENERATE(from_range(kSharingEngines));
  const SSharingEngine east = GENERATE(from_range(kSharingEngines));
  if (IsSkipped(east, east.HasMomentum, "momentum")) {
    return;
  }
  CAPTURE(west, east);
  const std::string engines = RegionXml(west, "west", kWest) + RegionXml(east, "east", kEast);
  CDriveWorld world(engines, DriverXml("e-puck", "r", -0.603, 0, 0, 60, 60));
  CVector3 before;
  int ticks = 0;
  while (world.EngineOf("r") == "west") {
    REQUIRE(++ticks < 25);
    before = world.Position("r");
    world.Step();
  }
  const CVector3 there = world.Position("r");
  SBodyMotion motion = world.Motion("r");
  const Real tolerance = 1e-5 + 0.06 * (west.Slip + east.Slip);
  CHECK_THAT(motion.Velocity.GetX(), WithinAbs(0.6, 10.0 * tolerance));
  world.Step();
  // from rest it would gain 37.5 cm/s in its first tick there, and be 2.25 cm behind
  CHECK_THAT(world.Position("r").GetX() - there.GetX(), WithinAbs(0.06, tolerance));
}

TEST_CASE("borders: objects that collide at a border share the momentum",
          "[contract][engine][partition]") {
  const SSharingEngine west = GENERATE(from_range(EnginesWithMomentum()));
  const SSharingEngine east = GENERATE(from_range(EnginesWithMomentum()));
  CAPTURE(west, east);
  const auto cylinder = [](const std::string& id, const std::string& x) {
    return "<cylinder id='" + id + "' radius='0.1' height='0.1' movable='true' mass='1'><body " +
           "position='" + x + ",0,0'/></cylinder>";
  };
  // b is in the east, so close to the border that a would overlap it by 1 mm when a's centre
  // crosses
  CDriveWorld world(SlipperyXml(west, east), cylinder("a", "-0.7") + cylinder("b", "0.199"));
  world.Step();
  world.Launch("a", CVector3(0.1, 0.0, 0.0));
  while (world.EngineOf("a") == "west") {
    REQUIRE(world.GetSpace().GetSimulationClock() < 100);
    world.Step();
  }
  world.Step(50);
  const Real speedA = world.Motion("a").Velocity.GetX();
  const Real speedB = world.Motion("b").Velocity.GetX();
  const Real tolerance = 1e-4 + (west.Precision + east.Precision) * 0.1;
  CHECK_THAT(speedA + speedB, WithinAbs(0.1, tolerance));
  if (east.Lateness > 0.0) {
    // an engine that detects contacts late separates the objects, with a speed that they keep
    CHECK(speedB >= speedA - tolerance);
  } else {
    // restitution is 0: they move on together at half the speed
    CHECK_THAT(speedA, WithinAbs(0.05, tolerance));
    CHECK_THAT(speedB, WithinAbs(0.05, tolerance));
  }
  CHECK(world.Position("b").GetX() - world.Position("a").GetX() >= 0.2 - 0.02 * 0.1);
}

TEST_CASE("borders: an object that slides across them and back keeps its velocity and rotation",
          "[contract][engine][partition]") {
  const SSharingEngine west = GENERATE(from_range(EnginesWithMomentum()));
  const SSharingEngine east = GENERATE(from_range(EnginesWithMomentum()));
  CAPTURE(west, east);
  const bool isBack = GENERATE(false, true);
  CDriveWorld world(SlipperyXml(west, east),
                    isBack ? "<box id='b' size='0.2,0.3,0.1' movable='true' mass='1'><body "
                             "position='0.503,0,0' orientation='20,0,0'/></box>"
                           : "<box id='b' size='0.2,0.3,0.1' movable='true' mass='1'><body "
                             "position='-0.503,0,0' orientation='20,0,0'/></box>");
  world.Step();
  const CVector3 velocity(isBack ? -0.2 : 0.2, 0.1, 0.0);
  CEmbodiedEntity& body = world.Body("b");
  SBodyMotion motion;
  motion.Velocity = velocity;
  motion.Rotation = CVector3(0.0, 0.0, 0.3);
  body.GetPhysicsModel(0).GetEngine().SetMotion(body, motion);
  const CVector3 start = world.Position("b");
  world.Step(50);
  CHECK(world.EngineOf("b") == (isBack ? "west" : "east"));
  const Real tolerance = 1e-5 + (west.Precision + east.Precision) * 0.3;
  CHECK(Distance(world.Motion("b").Velocity, velocity) <= tolerance);
  CHECK_THAT(world.Motion("b").Rotation.GetZ(), WithinAbs(0.3, tolerance));
  CHECK(Distance(world.Position("b"), start + velocity * 5.0) <= 10.0 * tolerance);
  CHECK_THAT(world.Yaw("b"), WithinAbs(20.0 / 180.0 * ARGOS_PI + 1.5, 10.0 * tolerance));
}

TEST_CASE("borders: a body moved by a command into another region is transferred to its engine",
          "[contract][engine][partition]") {
  const SSharingEngine west = GENERATE(from_range(kSharingEngines));
  const SSharingEngine east = GENERATE(from_range(kSharingEngines));
  CAPTURE(west, east);
  CDriveWorld world(RegionXml(west, "west", kWest) + RegionXml(east, "east", kEast),
                    DriverXml("foot-bot", "r", -1, 0, 0, 10, 10) +
                        "<box id='b' size='0.2,0.2,0.1' movable='true' mass='1'><body "
                        "position='-1,1,0'/></box>");
  const auto count = [&world](const std::string& id) {
    return world.GetSimulator().GetPhysicsEngine(id).GetNumPhysicsModels();
  };
  world.Step(10);
  for (int there = 0; there < 3; ++there) {
    const Real side = there == 1 ? -1.0 : 1.0;
    const CQuaternion turn(CRadians(0.5 * there), CVector3::Z);
    REQUIRE(world.Body("r").MoveTo(CVector3(side, -1, 0), turn));
    REQUIRE(world.Body("b").MoveTo(CVector3(2.0 * side, 1, 0), turn));
    CHECK(world.Position("r") == CVector3(side, -1, 0));
    CHECK(world.Body("r").GetOriginAnchor().Orientation == turn);
    // the transfer is complete after a tick at the latest
    world.Step();
    CHECK(world.EngineOf("r") == (side > 0.0 ? "east" : "west"));
    CHECK(world.EngineOf("b") == (side > 0.0 ? "east" : "west"));
    CHECK(count(side > 0.0 ? "east" : "west") == 2);
    CHECK(count(side > 0.0 ? "west" : "east") == 0);
    // the box rests, and the robot drives on in its new orientation
    world.Step(20);
    const Real slack = west.Slack + east.Slack;
    CHECK(Distance(world.Position("b"), CVector3(2.0 * side, 1, 0)) <= slack);
    const CVector3 way = world.Position("r") - CVector3(side, -1, 0);
    // it accelerates from rest within two ticks
    CHECK_THAT(way.Length(), WithinAbs(0.205, 0.006 + slack));
    CHECK_THAT(std::atan2(way.GetY(), way.GetX()), WithinAbs(0.5 * there, 0.01 + slack));
  }
}

TEST_CASE("borders: an immovable body is in every engine that it touches",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(engine);
  const std::string engines = RegionXml(engine, "a", {{-2, -2}, {0, -2}, {0, 2}, {-2, 2}}) +
                              RegionXml(engine, "b", {{0, -2}, {2, -2}, {2, 2}, {0, 2}}) +
                              RegionXml(engine, "c", {{2, -2}, {4, -2}, {4, 2}, {2, 2}});
  // all origins are in b
  CDriveWorld world(
      engines, BoxXml("long", "4.5,0.1,0.3", 0.5, 1) + BoxXml("near", "0.1,0.1,0.3", 0.2, -1) +
                   BoxXml("middle", "0.1,0.1,0.3", 1, -1) + BoxXml("thin", "0.01,3,0.3", 1, 0));
  using TIds = std::vector<std::string>;
  CHECK(EnginesOf(world, "long") == TIds{"a", "b", "c"});
  CHECK(EnginesOf(world, "near") == TIds{"a", "b"});
  CHECK(EnginesOf(world, "middle") == TIds{"b"});
  CHECK(EnginesOf(world, "thin") == TIds{"b"});
  // the same after a move: turned by 90 degrees it extends beyond b on both sides
  REQUIRE(world.Body("thin").MoveTo(CVector3(1, 0, 0),
                                    CQuaternion(CRadians::PI_OVER_TWO, CVector3::Z)));
  CHECK(EnginesOf(world, "thin") == TIds{"a", "b", "c"});
  REQUIRE(world.Body("middle").MoveTo(CVector3(3, -1, 0), CQuaternion()));
  CHECK(EnginesOf(world, "middle") == TIds{"c"});
  world.Step(3);
  world.GetSimulator().Reset();
  CHECK(EnginesOf(world, "thin") == TIds{"b"});
  CHECK(EnginesOf(world, "middle") == TIds{"b"});
  world.GetSimulator().GetLoopFunctions().RemoveEntity("long");
  CHECK(world.GetSimulator().GetPhysicsEngine("a").GetNumPhysicsModels() == 1);
  world.Step(3);
}

TEST_CASE("borders: an immovable body across a border stops robots on both sides",
          "[contract][engine][partition]") {
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  if (IsSkipped(engine, engine.HasContacts, "contacts")) {
    return;
  }
  CAPTURE(engine);
  const std::string engines = RegionXml(engine, "a", {{-2, -2}, {0, -2}, {0, 2}, {-2, 2}}) +
                              RegionXml(engine, "b", {{0, -2}, {2, -2}, {2, 2}, {0, 2}});
  // The origin of the wall is in b, a small part of it is in a. The post is in b, but a foot-bot
  // with its centre in a touches it.
  CDriveWorld world(engines, BoxXml("wall", "0.3,1,0.3", 0.1, 1) +
                                 BoxXml("post", "0.1,0.1,0.3", 0.1, -1) +
                                 DriverXml("foot-bot", "r", -0.5, 1, 0, 10, 10) +
                                 DriverXml("foot-bot", "s", -0.5, -1, 0, 10, 10));
  const Real tolerance = 0.02 * kFootBotRadius;
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    REQUIRE(world.Position("r").GetX() <= -0.05 - kFootBotRadius + tolerance);
    REQUIRE(world.Position("s").GetX() <= 0.05 - kFootBotRadius + tolerance);
  }
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(-0.05 - kFootBotRadius, tolerance));
  CHECK_THAT(world.Position("s").GetX(), WithinAbs(0.05 - kFootBotRadius, tolerance));
}

TEST_CASE("automatic partition: regions fill the arena and are as square as possible",
          "[contract][engine][partition]") {
  struct SCut {
    int Count;
    std::string Size;
    size_t Columns, Rows;
  };
  const SCut cut =
      GENERATE(SCut{16, "40,40,1", 4, 4}, SCut{6, "30,20,1", 3, 2}, SCut{6, "20,30,1", 2, 3},
               SCut{7, "10,10,1", 1, 7}, SCut{1, "10,10,1", 1, 1}, SCut{12, "10,10,1", 3, 4},
               SCut{8, "80,10,1", 8, 1});
  const SSharingEngine engine = GENERATE(from_range(kSharingEngines));
  CAPTURE(cut.Count, cut.Size, engine);
  SExperiment experiment;
  experiment.ArenaSize = cut.Size + "' center='1,2,0.5";
  experiment.Engines = "<auto_partition engine='" + engine.Tag + "' count='" +
                       std::to_string(cut.Count) + "' iterations='3' id='part'/>";
  CTestWorld world(experiment);
  const CPhysicsEngine::TVector& engines = world.GetSimulator().GetPhysicsEngines();
  REQUIRE(engines.size() == size_t(cut.Count));
  CHECK(engines.back()->GetId() ==
        "part_" + std::to_string(cut.Columns - 1) + "_" + std::to_string(cut.Rows - 1));
  CHECK(engines.front()->GetId() == "part_0_0");
  const CRange<CVector3>& arena = world.GetSpace().GetArenaLimits();
  const Real width = world.GetSpace().GetArenaSize().GetX() / cut.Columns;
  const Real height = world.GetSpace().GetArenaSize().GetY() / cut.Rows;
  for (size_t row = 0; row < cut.Rows; ++row) {
    for (size_t column = 0; column < cut.Columns; ++column) {
      CPhysicsEngine& one = *engines[row * cut.Columns + column];
      CHECK(one.GetIterations() == 3);
      // the middle of a cell is in its region and in no other
      const CVector3 middle(arena.GetMin().GetX() + (column + 0.5) * width,
                            arena.GetMin().GetY() + (row + 0.5) * height, 0.0);
      for (CPhysicsEngine* other : engines) {
        CHECK(other->IsPointContained(middle) == (other == &one));
      }
      // the border is half a cell to the right, unless that is beyond the arena
      const CVector3 right = middle + CVector3(0.5 * width + 1e-9, 0.0, 0.0);
      CHECK(one.IsPointContained(right) == (column + 1 == cut.Columns));
      const CVector3 above = middle + CVector3(0.0, 0.5 * height + 1e-9, 0.0);
      CHECK(one.IsPointContained(above) == (row + 1 == cut.Rows));
    }
  }
}

}  // namespace argos::physics_engines_partition_test
