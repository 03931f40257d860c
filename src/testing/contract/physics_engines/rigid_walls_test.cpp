// Walls at the faces of the region of an engine of rigid bodies.

#include <argos3/testing/contract/physics_engines/flight_world.h>
#include <argos3/testing/contract/physics_engines/regions.h>
#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/robot_sizes.h>

#include <argos3/core/simulator/physics_engine/physics_model.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::rigid_walls_test {

using Catch::Matchers::WithinAbs;

namespace {

const std::string kWall = "wall='true'";

// an engine with a region of 2 m x 2 m and walls on all sides
std::string Pen(const std::string& children, const std::string& heights) {
  return RigidEngine(
      "", children + Boundaries({{-1, -1, kWall}, {1, -1, kWall}, {1, 1, kWall}, {-1, 1, kWall}},
                                heights));
}

}  // namespace

TEST_CASE("rigid walls: a robot stops at a wall for any direction and speed",
          "[contract][engine][rigid][partition]") {
  const std::string robot = GENERATE(as<std::string>(), "e-puck", "foot-bot");
  const Real speed = GENERATE(3.0, 12.0, 30.0);  // cm/s
  const int quarter = GENERATE(0, 1, 2, 3);
  CAPTURE(robot, speed, quarter);
  const Real radius = robot == "e-puck" ? kEPuckRadius : kFootBotRadius;
  CRigidScene world(Pen("", ""), DriverXml(robot, "r", 0, 0, 90.0 * quarter, speed, speed));
  const Real angle = 0.5 * ARGOS_PI * quarter;
  const auto ahead = [&world, angle] {
    const CVector3 position = world.Position("r");
    return position.GetX() * std::cos(angle) + position.GetY() * std::sin(angle);
  };
  const int ticks = static_cast<int>(1500.0 / speed);
  for (int tick = 0; tick < ticks; ++tick) {
    world.Step();
    // contacts are predicted, so that the robot is never inside the wall
    REQUIRE(ahead() <= 1.0 - 0.98 * radius);
  }
  CHECK_THAT(ahead(), WithinAbs(1.0 - radius, 0.02 * radius));
}

TEST_CASE("rigid walls: a robot that drives into a corner touches both walls",
          "[contract][engine][rigid][partition]") {
  CRigidScene world(Pen("", ""), DriverXml("foot-bot", "r", 0, 0, 45, 10, 10));
  world.Step(200);
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(1.0 - kFootBotRadius, 0.02 * kFootBotRadius));
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(1.0 - kFootBotRadius, 0.02 * kFootBotRadius));
}

TEST_CASE("rigid walls: the bottom of a region is a floor",
          "[contract][engine][rigid][partition]") {
  // without the add-on this is the only floor; with it only the higher one counts
  const std::string children = GENERATE("", "<gravity g='9.81'/>", "<gravity g='9.81'/><floor/>");
  CAPTURE(children);
  CRigidScene world(
      Pen(children, "<bottom height='0.25' wall='true'/>"),
      SBoxXml{"b", CVector3(0.2, 0.3, 0.1), CVector3(0.5, 0.5, 0.5)}.ToXml() +
          "<foot-bot id='r'><body position='0,0,0.25'/><controller config='driver'><params "
          "left='10' right='10'/></controller></foot-bot>");
  world.Step(51);
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.25, 1e-3));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.5, 5e-3));
  CHECK_THAT(world.Position("r").GetZ(), WithinAbs(0.25, 1e-3));
}

TEST_CASE("rigid walls: the top of a region stops bodies that fall upwards",
          "[contract][engine][rigid][partition]") {
  CRigidScene world(Pen("<gravity vector='0,0,9.81'/>", "<top height='1' wall='true'/>"),
                    SBoxXml{"b", CVector3(0.2, 0.3, 0.1), CVector3(0.5, 0.5, 0.85)}.ToXml());
  for (int tick = 0; tick < 50; ++tick) {
    world.Step();
    REQUIRE(world.Position("b").GetZ() <= 0.9 + 1e-3);
  }
  CHECK_THAT(world.Position("b").GetZ(), WithinAbs(0.9, 1e-3));
  CHECK(world.Tilt("b") < 1e-3);
}

TEST_CASE("rigid walls: top and sides stop a flying robot",
          "[contract][engine][rigid][partition]") {
  SFlightExperiment experiment;
  experiment.Engines = Pen("", "<top height='1' wall='true'/><bottom height='0' wall='true'/>");
  experiment.Arena = EyeBotXml("r", CVector3(0, 0, 0.2));
  CFlightWorld world(experiment);
  world.Places().SetAbsolutePosition(CVector3(2.0, 0.0, 0.2));
  world.Step(200);
  const auto highest = [&world] {
    return world.Body().GetPhysicsModel(0).GetBoundingBox().MaxCorner;
  };
  CHECK_THAT(highest().GetX(), WithinAbs(1.0, 2e-3));
  CHECK_THAT(world.Position().GetZ(), WithinAbs(0.2, 2e-3));
  world.Places().SetAbsolutePosition(CVector3(0.0, 0.0, 3.0));
  world.Step(200);
  CHECK_THAT(highest().GetZ(), WithinAbs(1.0, 2e-3));
}

TEST_CASE("rigid walls: a lying body with its base at a wall belongs to its engine",
          "[contract][engine][rigid][partition]") {
  // A lying cylinder moves towards the wall with its base ahead, where its origin is.
  const std::string cylinder =
      "<cylinder id='c' radius='0.1' height='0.3' movable='true' mass='1'>"
      "<body position='0.8,0,0.5' orientation='0,-90,0'/></cylinder>";
  const Real speed = GENERATE(0.1, 1.0);  // m/s
  CAPTURE(speed);
  CRigidScene world(Pen("<gravity g='0'/>" + KickXml("c", CVector3(speed, 0, 0)), ""), cylinder);
  REQUIRE_THAT(world.Tilt("c"), WithinAbs(0.5 * ARGOS_PI, 1e-6));
  Real farthest = 0.0;
  for (int tick = 0; tick < 40; ++tick) {
    world.Step();
    farthest = std::max(farthest, world.Position("c").GetX());
  }
  CHECK(world.Body("c").GetPhysicsModelsNum() == 1);
  CHECK_THAT(farthest, WithinAbs(1.0, 1e-3));
  CHECK_THAT(world.Position("c").GetX(), WithinAbs(1.0, 1e-3));
}

}  // namespace argos::rigid_walls_test
