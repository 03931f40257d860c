// Prisms in space: at rest on each other and on other solids, as ramps, and tumbling.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/polygons.h>

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::rigid_prisms_test {

using Catch::Matchers::WithinAbs;

namespace {

std::string BoxAt(const std::string& id, const CVector3& position, Real mass) {
  return SBoxXml{id, CVector3(0.1, 0.1, 0.1), position, CVector3(), mass}.ToXml();
}

SShapeDescription Hexagon(Real radius, Real height) {
  return SShapeDescription::Prism(RegularPolygon(6, radius), height);
}

}  // namespace

TEST_CASE("rigid prisms: rest on the floor, on each other, on boxes, cylinders and spheres",
          "[contract][engine][rigid][prism]") {
  const std::string stepper = GENERATE("mixed", "iterative");
  CAPTURE(stepper);
  CRigidScene world(
      GroundedEngine("sleep='false'", "<solver stepper='" + stepper + "'/>"),
      BoxAt("a", CVector3(), 1.0) + BoxAt("b", CVector3(0, 0, 0.1), 1.0) +
          BoxAt("table", CVector3(2, 0, 0), 0.0) + BoxAt("on_table", CVector3(2, 0, 0.1), 1.0) +
          BoxAt("drum", CVector3(4, 0, 0), 1.0) + BoxAt("on_drum", CVector3(4, 0, 0.1), 1.0) +
          BoxAt("under", CVector3(6, 0, 0), 1.0) + BoxAt("round", CVector3(6, 0, 0.1), 1.0));
  world.Reshape("a", Hexagon(0.15, 0.1));
  world.Reshape("b", SShapeDescription::Prism(RegularPolygon(3, 0.1), 0.1));
  world.Reshape("on_table", Hexagon(0.1, 0.2));
  world.Reshape("drum", SShapeDescription::Cylinder(0.1, 0.1));
  world.Reshape("on_drum", SShapeDescription::Prism(RegularPolygon(5, 0.08), 0.1));
  world.Reshape("under", Hexagon(0.1, 0.1));
  world.Reshape("round", SShapeDescription::Cylinder(0.08, 0.1));
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
  }
  for (const auto& [id, x, z] :
       {std::tuple("a", 0.0, 0.0), std::tuple("b", 0.0, 0.1), std::tuple("on_table", 2.0, 0.1),
        std::tuple("drum", 4.0, 0.0), std::tuple("on_drum", 4.0, 0.1),
        std::tuple("under", 6.0, 0.0), std::tuple("round", 6.0, 0.1)}) {
    CAPTURE(id);
    // tolerance for the compliance of contacts
    CHECK(Distance(world.Position(id), CVector3(x, 0, z)) < 2e-3);
    CHECK(world.Tilt(id) < 5e-3);
  }
}

TEST_CASE("rigid prisms: a stack of five sleeps, and falls when the lowest is removed",
          "[contract][engine][rigid][prism]") {
  std::string arena;
  for (int i = 0; i < 5; ++i) {
    arena += BoxAt("p" + std::to_string(i), CVector3(0, 0, 0.1 * i), 0.5);
  }
  CRigidScene world(GroundedEngine(), arena);
  for (int i = 0; i < 5; ++i) {
    SShapeDescription prism = Hexagon(0.12, 0.1);
    prism.Orientation = CQuaternion(CRadians(0.2 * i), CVector3::Z);
    world.Reshape("p" + std::to_string(i), prism);
  }
  world.Step(100);
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK(Distance(world.Position("p" + std::to_string(i)), CVector3(0, 0, 0.1 * i)) < 3e-3);
  }
  world.GetSimulator().GetLoopFunctions().RemoveEntity("p0");
  world.Step(20);
  CHECK_THAT(world.Position("p4").GetZ(), WithinAbs(0.3, 3e-3));
}

TEST_CASE("rigid prisms: falls as far as a box, and lies on a side in the end",
          "[contract][engine][rigid][prism]") {
  // an upright triangle of height 1 with an edge of 0.2: it topples at once if tilted by 20 degrees
  CRigidScene world(
      GroundedEngine(),
      SBoxXml{"p", CVector3(0.1, 0.1, 0.1), CVector3(0, 0, 0.5), CVector3(0, 20, 0)}.ToXml());
  world.Reshape("p", SShapeDescription::Prism(RegularPolygon(3, 0.1), 0.6));
  world.Step(2);
  // free fall: n substeps of 10 ms make g h^2 n (n + 1) / 2
  const CVector3 fallen = world.Position("p");
  CHECK_THAT(fallen.GetZ(), WithinAbs(0.5 - kSceneGravity * 1e-4 * 20 * 21 / 2, 1e-9));
  world.Step(100);
  CHECK_THAT(world.Tilt("p"), WithinAbs(0.5 * ARGOS_PI, 0.02));
  const SBoundingBox box = world.Body("p").GetBodyDescription()->ComputeBoundingBox(
      world.Position("p"), world.Orientation("p"));
  CHECK_THAT(box.MinCorner.GetZ(), WithinAbs(0.0, 2e-3));
  CHECK_THAT(box.MaxCorner.GetZ(), WithinAbs(0.15, 3e-3));
}

TEST_CASE("rigid prisms: a robot climbs a wedge, objects slide down a steep one",
          "[contract][engine][rigid][prism]") {
  // profiles in the vertical plane: 1 m long and 0.1 m high, and 1 m long with 30 degrees
  const auto wedge = [](Real height) {
    SShapeDescription prism =
        SShapeDescription::Prism({CVector2(0, 0), CVector2(1, 0), CVector2(1, height)}, 1.0);
    // its axis along -y, its plane upright
    prism.Orientation = CQuaternion(CRadians::PI_OVER_TWO, CVector3::X);
    prism.Offset = CVector3(0.5, 0.5, 0.5 * height);
    return prism;
  };
  CRigidScene world(
      GroundedEngine(),
      BoxAt("ramp", CVector3(0.3, 0, 0), 0.0) + DriverXml("foot-bot", "r", 0, 0, 0, 10, 10) +
          BoxAt("slide", CVector3(0, 5, 0), 0.0) +
          SBoxXml{"box", CVector3(0.1, 0.1, 0.05), CVector3(0.8, 5.0, 0.48), CVector3(0, -30, 0)}
              .ToXml());
  world.Reshape("ramp", wedge(0.1));
  world.Reshape("slide", wedge(std::tan(ARGOS_PI / 6.0)));
  const CVector3 start = world.Position("box");
  world.Step(90);
  // the robot has driven 0.9 m, of which 0.5 m or more on a slope of 10 %
  const CVector3 robot = world.Position("r");
  CHECK_THAT(robot.GetX(), WithinAbs(0.89, 0.03));
  CHECK_THAT(robot.GetZ(), WithinAbs(0.1 * (robot.GetX() - 0.3), 5e-3));
  CHECK_THAT(world.Tilt("r"), WithinAbs(0.1, 0.02));
  // friction holds the box to 45 degrees
  CHECK(Distance(world.Position("box"), start) < 0.02);
  // without friction it slides with g sin a
  CRigidScene smooth(
      GroundedEngine("default_friction='0'"),
      BoxAt("slide", CVector3(0, 5, 0), 0.0) +
          SBoxXml{"box", CVector3(0.1, 0.1, 0.05),
                  CVector3(0.8, 5.0, 0.8 * std::tan(ARGOS_PI / 6.0) + 1e-4), CVector3(0, -30, 0)}
              .ToXml());
  smooth.Reshape("slide", wedge(std::tan(ARGOS_PI / 6.0)));
  smooth.Step(1);
  const CVector3 before = smooth.Position("box");
  const Real speed = smooth.Motion("box").Velocity.Length();
  smooth.Step(3);
  CHECK_THAT(Distance(smooth.Position("box"), before),
             WithinAbs(speed * 0.3 + 0.5 * kSceneGravity * 0.5 * 0.09, 0.01));
}

}  // namespace argos::rigid_prisms_test
