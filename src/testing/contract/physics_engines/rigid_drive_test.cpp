// Robots that roll on wheels, on slopes and ramps.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>

#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

namespace argos::rigid_drive_test {

using Catch::Matchers::WithinAbs;

namespace {

// a slope about the y axis, rising towards x; its upper face contains the origin
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

}  // namespace

TEST_CASE("rigid drive: without gravity the wheels have no traction", "[contract][engine][rigid]") {
  CRigidScene world(RigidEngine("", "<floor/>"), DriverXml("foot-bot", "r", 0, 0, 0, 10, 10));
  CHECK_THAT(TakeLogErr(), Catch::Matchers::Contains("\"e\" has no gravity, so the drives"));
  world.Step(50);
  // the reaction to the start of the wheels turns the robot slightly backwards
  CHECK(world.Position("r").Length() < 0.01);
}

TEST_CASE("rigid drive: a robot drives up a slope at the speed of its wheels",
          "[contract][engine][rigid]") {
  const std::string robot = GENERATE("foot-bot", "e-puck");
  const Real degrees = GENERATE(5.0, 15.0);
  const Real speed = GENERATE(10.0, -10.0);  // cm/s
  CAPTURE(robot, degrees, speed);
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>"),
                    Slope(degrees) + OnSlope(robot, degrees, speed, speed));
  world.Step(101);
  const Real angle = degrees * ARGOS_PI / 180.0;
  CHECK_THAT(world.Position("r").GetZ(), WithinAbs(0.1 * speed * std::sin(angle), 0.02));
  CHECK_THAT(world.Position("r").GetX(), WithinAbs(0.1 * speed * std::cos(angle), 0.02));
  CHECK_THAT(world.Tilt("r"), WithinAbs(angle, 0.03));
}

TEST_CASE("rigid drive: a braking robot stands on a slope if friction suffices",
          "[contract][engine][rigid]") {
  const std::string robot = GENERATE("foot-bot", "e-puck");
  CAPTURE(robot);
  CRigidScene holds(RigidEngine("", "<gravity g='9.81'/>"),
                    Slope(15.0) + OnSlope(robot, 15.0, 0, 0));
  holds.Step(100);
  CHECK(holds.Position("r").Length() < 2e-3);
  // casters have no friction: the wheels, with part of the weight, would need tan(15 deg) and more
  CRigidScene slides(RigidEngine("default_friction='0.4'", "<gravity g='9.81'/>"),
                     Slope(15.0) + OnSlope(robot, 15.0, 0, 0));
  slides.Step(20);
  CHECK(slides.Position("r").GetX() < -0.05);
}

TEST_CASE("rigid drive: a robot climbs from the floor onto a ramp and across its top",
          "[contract][engine][rigid]") {
  // the upper face of a wedge from (0.5, 0) up to (1.5, 0.2), and a table behind it
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
  const std::string robot = GENERATE("foot-bot", "e-puck");
  CAPTURE(robot);
  CRigidScene world(GroundedEngine(), arena + DriverXml(robot, "r", 0.2, 0, 0, 10, 10));
  world.Step(190);
  CHECK_THAT(world.Position("r").GetZ(), WithinAbs(std::sin(angle) * length, 5e-3));
  CHECK_THAT(world.Position("r").GetY(), WithinAbs(0.0, 0.02));
  CHECK(world.Position("r").GetX() > 1.75);
  CHECK(world.Tilt("r") < 0.02);
  // at the end of the table it falls
  world.Step(120);
  CHECK(world.Position("r").GetZ() < 0.1);
}

}  // namespace argos::rigid_drive_test
