// Bodies that are prisms: robots, objects and walls, in every engine.

#include <argos3/testing/contract/physics_engines/arc_and_push.h>
#include <argos3/testing/contract/physics_engines/drive_world.h>
#include <argos3/testing/contract/physics_engines/engines.h>
#include <argos3/testing/support/polygons.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/geometry/convex_polygon.h>
#include <argos3/core/simulator/geometry/solid_overlap.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

namespace argos::prisms_test {

using Catch::Matchers::WithinAbs;

namespace {

constexpr Real kCorner = 0.1;  // m, from the centre of a hexagon to its corners
const Real kSide = kCorner * std::sqrt(0.75);  // m, to its sides

// one side faces ahead
std::vector<CVector2> Hexagon(Real radius = kCorner) {
  std::vector<CVector2> corners = RegularPolygon(6, radius);
  for (CVector2& corner : corners) {
    corner.Rotate(CRadians::PI / 6.0);
  }
  return corners;
}

SShapeDescription HexagonPrism() {
  return SShapeDescription::Prism(Hexagon(), 0.1);
}

std::string CylinderXml(const std::string& id, Real x, Real y, Real radius, Real mass = 0.5) {
  std::ostringstream xml;
  xml << "<cylinder id='" << id << "' radius='" << radius << "' height='0.1' movable='"
      << (mass > 0.0 ? "true" : "false") << "' mass='" << mass << "'><body position='" << x << ","
      << y << ",0'/></cylinder>";
  return xml.str();
}

// how deep a round body is in a prism, m
Real ComputeDepth(CDriveWorld& world, const std::string& disc, Real radius,
                  const std::string& prism) {
  const SAnchor& origin = world.Body(prism).GetOriginAnchor();
  const SShapeDescription& shape = world.Body(prism).GetBodyDescription()->Shapes[0];
  CVector3 offset = world.Position(disc) - origin.Position;
  offset.Rotate(origin.Orientation.Inverse());
  offset -= shape.Offset;
  return radius - FindNearest(*shape.Vertices, CVector2(offset.GetX(), offset.GetY())).Distance;
}

}  // namespace

TEST_CASE("prisms: a hexagonal robot follows its arc and pushes with its side",
          "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "free", 3, 3, 30, 9, 10) +
                                        DriverXml("foot-bot", "pusher", 0, 0, 0, 10, 10) +
                                        CylinderXml("c", 0.3, 0, 0.05));
  // a new command takes effect late once
  CheckArcAndPush(world, engine, HexagonPrism(), kSide, 0.1 * engine.GetLag());
}

TEST_CASE("prisms: a polygon of many corners stops robots where its circle does",
          "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  const bool isRobotRound = GENERATE(true, false);
  CAPTURE(engine, isRobotRound);
  const SShapeDescription drum = SShapeDescription::Prism(RegularPolygon(20, 0.2), 0.3);
  CDriveWorld world(engine.ToXml(), DriverXml("foot-bot", "a", -0.5, 0.0, 0, 10, 10) +
                                        DriverXml("foot-bot", "b", 0.35, 0.45, -128, 10, 10) +
                                        CylinderXml("drum", 0, 0, 0.2, 0.0));
  world.Reshape("drum", drum);
  if (!isRobotRound) {
    for (const char* id : {"a", "b"}) {
      world.Reshape(id, SShapeDescription::Prism(RegularPolygon(30, kFootBotRadius), 0.1));
    }
  }
  for (int tick = 0; tick < 80; ++tick) {
    world.Step();
    for (const char* id : {"a", "b"}) {
      // the sides of the drum are up to 1.3 % inside its circle
      REQUIRE(world.Position(id).Length() > 0.98 * (0.2 + kFootBotRadius) - engine.Slack);
    }
  }
  CHECK_THAT(world.Position("a").Length(),
             WithinAbs(0.2 + kFootBotRadius, 0.02 * (0.2 + kFootBotRadius) + engine.Slack));
}

TEST_CASE("prisms: a rectangle as a prism moves like the box", "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  const auto arena = DriverXml("foot-bot", "r", 0, 0.03, 5, 10, 11) +
                     DriverXml("foot-bot", "round", 0.1, 0.6, -60, 10, 10) +
                     "<box id='b' size='0.2,0.1,0.1' movable='true' mass='0.5'><body "
                     "position='0.3,-0.02,0' orientation='20,0,0'/></box>"
                     "<box id='w' size='0.2,0.4,0.1' movable='false'><body position='0.9,0.1,0' "
                     "orientation='10,0,0'/></box>";
  const CVector3 size(0.16, 0.2, 0.1);
  CDriveWorld boxes(engine.ToXml(), arena);
  boxes.Reshape("r", SShapeDescription::Box(size));
  CDriveWorld prisms(engine.ToXml(), arena);
  prisms.Reshape("r", SShapeDescription::Prism(RectanglePolygon(0.16, 0.2), 0.1));
  prisms.Reshape("b", SShapeDescription::Prism(RectanglePolygon(0.2, 0.1), 0.1));
  prisms.Reshape("w", SShapeDescription::Prism(RectanglePolygon(0.2, 0.4), 0.1));
  // a polygon's corners come in another order than a box's; ODE finds other points of contact
  const Real tolerance = engine.HasMomentum ? 1e-3 + 10.0 * engine.Slack : 1e-9;
  for (int tick = 0; tick < 80; ++tick) {
    boxes.Step();
    prisms.Step();
    for (const std::string id : {"r", "b", "round"}) {
      CAPTURE(tick, id);
      REQUIRE(Distance(boxes.Position(id), prisms.Position(id)) < tolerance);
    }
  }
  CHECK(prisms.Position("b").GetX() > 0.4);
}

TEST_CASE("prisms: robots push a triangle without penetrating it", "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  // towards a corner, towards a side, and beside the centre
  const Real yaw = GENERATE(0.0, 60.0, 100.0);
  CAPTURE(engine, yaw);
  // the origin of the body is not inside its base
  const SShapeDescription triangle = SShapeDescription::Prism(
      {CVector2(-0.3, -0.1), CVector2(-0.05, -0.1), CVector2(-0.15, 0.12)}, 0.1);
  CDriveWorld world(engine.ToXml(),
                    DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) + CylinderXml("t", 0.6, 0, 0.05));
  world.Reshape("t", triangle);
  REQUIRE(world.Body("t").MoveTo(CVector3(0.5, 0.0, 0.0),
                                 CQuaternion(CRadians(yaw * ARGOS_PI / 180.0), CVector3::Z)));
  const auto locate = [&] {
    CVector3 centre = triangle.ComputeCentroid();
    centre.Rotate(world.Body("t").GetOriginAnchor().Orientation);
    return world.Position("t") + centre;
  };
  const CVector3 before = locate();
  Real deepest = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    deepest = std::max(deepest, ComputeDepth(world, "r", kFootBotRadius, "t"));
  }
  CHECK(deepest <= 0.02 * kFootBotRadius + engine.Slack);
  // the robot has touched it
  CHECK(deepest > -1e-3);
  CHECK(Distance(locate(), before) > 1e-3);
}

TEST_CASE("prisms: a crowd of hexagons overlaps by at most two percent",
          "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithContacts));
  CAPTURE(engine);
  constexpr int kRobots = 9;
  std::string arena;
  for (int i = 0; i < kRobots; ++i) {
    const Real angle = 2.0 * ARGOS_PI * i / kRobots;
    arena += DriverXml("foot-bot", "r" + std::to_string(i), 0.6 * std::cos(angle),
                       0.6 * std::sin(angle), 180.0 + 180.0 / ARGOS_PI * angle, 9.0 + 0.2 * i, 10);
  }
  CDriveWorld world(engine.ToXml(), arena);
  for (int i = 0; i < kRobots; ++i) {
    world.Reshape("r" + std::to_string(i), HexagonPrism());
  }
  // smaller by one percent of the width on each side
  const SShapeDescription smaller = SShapeDescription::Prism(Hexagon(0.98 * kCorner), 0.09);
  Real least = HUGE_VAL;
  for (int tick = 0; tick < 150; ++tick) {
    world.Step();
    for (int i = 0; i < kRobots; ++i) {
      for (int j = 0; j < i; ++j) {
        const SAnchor& a = world.Body("r" + std::to_string(i)).GetOriginAnchor();
        const SAnchor& b = world.Body("r" + std::to_string(j)).GetOriginAnchor();
        CAPTURE(tick, i, j);
        REQUIRE_FALSE(SolidsOverlap({&smaller, a.Position, a.Orientation},
                                    {&smaller, b.Position, b.Orientation}));
        least = std::min(least, Distance(a.Position, b.Position));
      }
    }
  }
  // they have met
  CHECK(least < 2.0 * kCorner);
}

TEST_CASE("prisms: rays and placement respect their sides", "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(from_range(kEnginesWithWheels));
  CAPTURE(engine);
  // a building with a right angle at (2, -1) and legs of 2 m, and a hexagonal robot
  CDriveWorld world(engine.ToXml(), CylinderXml("house", 2, -1, 0.05, 0.0) +
                                        DriverXml("foot-bot", "robot", 1, 1.5, 0, 0, 0) +
                                        DriverXml("foot-bot", "visitor", -1, 0, 0, 0, 0));
  world.Reshape("house",
                SShapeDescription::Prism({CVector2(0, 0), CVector2(2, 0), CVector2(0, 2)}, 0.5));
  world.Reshape("robot", HexagonPrism());
  world.Step();
  const auto look = [&](const CVector3& start, const CVector3& end) {
    SEmbodiedEntityIntersectionItem item;
    return GetClosestEmbodiedEntityIntersectedByRay(item, CRay3(start, end)) ? item.TOnRay : -1.0;
  };
  // tolerance of a few roundings of numbers below 10
  const Real tolerance = 1e-13 + engine.Slack;
  CHECK_THAT(look(CVector3(0, 0, 0.2), CVector3(8, 0, 0.2)), WithinAbs(0.25, tolerance));
  // from the right: the long side is at x = 3 - y
  CHECK_THAT(look(CVector3(8, 0.5, 0.2), CVector3(0, 0.5, 0.2)), WithinAbs(5.5 / 8.0, tolerance));
  CHECK(look(CVector3(8, 0.5, 0.6), CVector3(0, 0.5, 0.6)) < 0.0);
  // from above, through the roof
  CHECK_THAT(look(CVector3(2.5, -0.5, 1.5), CVector3(2.5, -0.5, -0.5)), WithinAbs(0.5, tolerance));
  CHECK(look(CVector3(3.5, 0.5, 1.5), CVector3(3.5, 0.5, -0.5)) < 0.0);
  CHECK_THAT(look(CVector3(3, 1.5, 0.08), CVector3(-1, 1.5, 0.08)),
             WithinAbs((2.0 - kSide) / 4.0, tolerance));
  // a place that the building's bounding circle covers, 1 mm from the long side
  const Real away = (kFootBotRadius + 0.001) / std::sqrt(2.0);
  const CVector3 beside(3.0 + away, away, 0.0);
  CHECK(world.Body("visitor").MoveTo(beside, CQuaternion(), true));
  CHECK_FALSE(
      world.Body("visitor").MoveTo(beside - CVector3(0.002, 0.002, 0.0), CQuaternion(), true));
  CHECK(world.Body("visitor").MoveTo(CVector3(-1, 0, 0), CQuaternion()));
  world.GetSimulator().Reset();
  CHECK_THAT(look(CVector3(0, 0, 0.2), CVector3(8, 0, 0.2)), WithinAbs(0.25, tolerance));
}

TEST_CASE("prisms: each side that overlaps a wall is moved to its surface",
          "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(kDynamics2D, kKinematics2D);
  const size_t numCorners = GENERATE(3, 6, 8, 9, 14, 20, 30);
  constexpr Real kDepth = 0.004;  // m
  const Real side = kCorner * std::cos(ARGOS_PI / static_cast<Real>(numCorners));
  for (size_t i = 0; i < numCorners; ++i) {
    CAPTURE(engine, numCorners, i);
    const Real yaw = 180.0 * static_cast<Real>(2 * i + 1) / static_cast<Real>(numCorners);
    std::ostringstream wall;
    wall << "<box id='w' size='0.2,1,0.1' movable='false'><body position='" << side - kDepth + 0.1
         << ",0,0'/></box>";
    CDriveWorld world(engine.ToXml(), wall.str() + DriverXml("e-puck", "r", 0, 0, yaw, 0, 0));
    world.Reshape("r", SShapeDescription::Prism(RegularPolygon(numCorners, kCorner), 0.1));
    world.Step(10);
    CHECK_THAT(world.Position("r").GetX(), WithinAbs(-kDepth, 1e-4));
    CHECK_THAT(world.Position("r").GetY(), WithinAbs(0.0, 1e-4));
  }
}

TEST_CASE("prisms: in a plane, a tilted box is the rectangle around it",
          "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(kDynamics2D, kKinematics2D);
  // a beam of 1 m that leans towards +x or +y; its base is around the origin
  const bool leansAside = GENERATE(false, true);
  const Real ahead = 0.5 * 0.2 * 0.5 + std::sqrt(0.75);
  struct SApproach {
    Real Angle, Across;  // degrees: of the way to the beam; m: of the way beside its base
    Real Stop;  // m: from the origin to the robot's edge, along the way
  };
  const SApproach approach = GENERATE_COPY(
      SApproach{180.0, 0.0, ahead}, SApproach{180.0, 0.12, ahead}, SApproach{180.0, -0.12, ahead},
      SApproach{0.0, 0.0, 0.05}, SApproach{90.0, 0.0, 0.15}, SApproach{-90.0, 0.0, 0.15},
      SApproach{90.0, -0.85, 0.15}, SApproach{-90.0, 0.85, 0.15});
  const Real yaw = GENERATE(0.0, 30.0);
  CAPTURE(engine, leansAside, approach.Angle, approach.Across, yaw);
  const Real angle = approach.Angle + yaw + (leansAside ? 90.0 : 0.0);
  CVector3 start(-1.5, approach.Across, 0.0);
  start.RotateZ(ToRadians(CDegrees(angle)));
  std::ostringstream arena;
  arena << "<prototype id='p' movable='false'><body position='0,0,0' orientation='" << yaw
        << ",0,0'/><links ref='beam'><link id='beam' geometry='box' mass='1' position='0,0,0' "
        << (leansAside ? "size='0.3,0.2,1' orientation='0,0,-60'"
                       : "size='0.2,0.3,1' orientation='0,60,0'")
        << "/></links></prototype>"
        << DriverXml("e-puck", "r", start.GetX(), start.GetY(), angle, 10, 10);
  CDriveWorld world(engine.ToPromptXml(), arena.str());
  world.Step(160);
  CVector3 end = world.Position("r");
  end.RotateZ(ToRadians(CDegrees(-angle)));
  CHECK_THAT(end.GetX(), WithinAbs(-approach.Stop - kEPuckRadius, 0.02 * kEPuckRadius));
  CHECK_THAT(end.GetY(), WithinAbs(approach.Across, 1e-3));
}

TEST_CASE("prisms: a pushed box stops at the rectangle around a tilted one",
          "[contract][engine][prism]") {
  const SEngineType engine = GENERATE(kDynamics2D, kKinematics2D);
  CAPTURE(engine);
  CDriveWorld world(
      engine.ToPromptXml(),
      "<prototype id='p' movable='false'><body position='0,0,0'/><links ref='beam'>"
      "<link id='beam' geometry='box' size='0.2,0.3,1' mass='1' position='0,0,0' "
      "orientation='0,60,0'/></links></prototype>"
      "<box id='b' size='0.1,0.1,0.1' movable='true' mass='0.5'><body position='1.2,0,0'/></box>" +
          DriverXml("e-puck", "r", 1.35, 0, 180, 10, 10));
  world.Step(50);
  CHECK_THAT(world.Position("b").GetX(), WithinAbs(0.05 + std::sqrt(0.75) + 0.05, 1e-3));
}

}  // namespace argos::prisms_test
