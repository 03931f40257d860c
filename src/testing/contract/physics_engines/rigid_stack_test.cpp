// Stacks of boxes and cylinders: stable and toppling ones.

#include <argos3/testing/contract/physics_engines/rigid_scene.h>
#include <argos3/testing/support/captured_logs.h>

#include <argos3/core/simulator/loop_functions.h>
#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::rigid_stack_test {

using Catch::Matchers::WithinAbs;

namespace {

std::string Stepper(const std::string& name) {
  return "<solver stepper='" + name + "'/>";
}

std::string Name(int i) {
  return "b" + std::to_string(i);
}

std::string Stack(int count) {
  std::string boxes;
  for (int i = 0; i < count; ++i) {
    boxes += SBoxXml{Name(i), CVector3(0.2, 0.2, 0.1), CVector3(0, 0, 0.1 * i),
                     CVector3(10.0 * i, 0, 0), 0.5}
                 .ToXml();
  }
  return boxes;
}

}  // namespace

TEST_CASE("rigid stack: a cylinder on a box stays at rest", "[contract][engine][rigid]") {
  const std::string table = GENERATE("movable='false'", "movable='true' mass='5'");
  const Real x = GENERATE(0.0, 0.43);  // with the second value it extends over the edge
  CAPTURE(table, x);
  std::ostringstream arena;
  arena << "<box id='t' size='1,1,0.2' " << table << "><body position='0,0,0'/></box>"
        << "<cylinder id='c' radius='0.1' height='0.3' movable='true' mass='1'><body position='"
        << x << ",0.1,0.2' orientation='10,0,0'/></cylinder>";
  CRigidScene world(GroundedEngine("sleep='false'"), arena.str());
  Real most = 0.0;
  for (int tick = 0; tick < 100; ++tick) {
    world.Step();
    most = std::max(most, world.Tilt("c"));
  }
  // a rocking cylinder would tilt by more than the limit that is reported as upright
  CHECK(most < 1e-6);
  CHECK(Distance(world.Position("c"), CVector3(x, 0.1, 0.2)) < 1e-3);
}

TEST_CASE("rigid stack: five stacked boxes rest for 10 s", "[contract][engine][rigid]") {
  const std::string stepper = GENERATE("mixed", "direct", "iterative");
  const std::string sleep = GENERATE("sleep='true'", "sleep='false'");
  CAPTURE(stepper, sleep);
  CRigidScene world(GroundedEngine(sleep, Stepper(stepper)), Stack(5));
  world.Step(100);
  if (stepper == "direct") {
    // it leaves some contacts of boxes with relative rotation unsolved, and reports it
    CHECK_THAT(TakeLogErr(), Catch::Matchers::Contains("has left contacts unsolved"));
  }
  // 2 % of a box's side for the iterative stepper, 1 % for the others
  const Real aside = stepper == "iterative" ? 4e-3 : 2e-3;
  for (int i = 0; i < 5; ++i) {
    CAPTURE(i);
    CHECK_THAT(world.Position(Name(i)).GetX(), WithinAbs(0.0, aside));
    CHECK_THAT(world.Position(Name(i)).GetY(), WithinAbs(0.0, aside));
    // tolerance for the compliance of contacts
    CHECK_THAT(world.Position(Name(i)).GetZ(), WithinAbs(0.1 * i, 1e-3));
    CHECK(world.Tilt(Name(i)) < 5e-3);
  }
}

TEST_CASE("rigid stack: a box falls when the box below is removed", "[contract][engine][rigid]") {
  CRigidScene world(GroundedEngine(), Stack(2));
  // long enough for both to fall asleep
  world.Step(20);
  world.GetSimulator().GetLoopFunctions().RemoveEntity("b0");
  world.Step(10);
  CHECK_THAT(world.Position("b1").GetZ(), WithinAbs(0.0, 1e-3));
}

TEST_CASE("rigid stack: a tall box stands on a slope until its weight acts beyond its edge",
          "[contract][engine][rigid]") {
  // 0.1 m wide, 0.4 m tall: it topples beyond atan(1 / 4) = 14.04 degrees; friction holds to 45
  const auto slope = [](Real degrees) {
    const Real angle = degrees * ARGOS_PI / 180.0;
    const CVector3 top(0.1 * std::sin(angle), 0.0, 0.1 * std::cos(angle));
    return SBoxXml{"slope", CVector3(4, 2, 0.1), CVector3(), CVector3(0, degrees, 0), 0.0}.ToXml() +
           SBoxXml{"tall", CVector3(0.1, 0.1, 0.4), top, CVector3(0, degrees, 0)}.ToXml();
  };
  CRigidScene stands(RigidEngine("", "<gravity g='9.81'/>"), slope(13.0));
  stands.Step(50);
  CHECK_THAT(stands.Tilt("tall"), WithinAbs(13.0 * ARGOS_PI / 180.0, 0.01));
  CRigidScene topples(RigidEngine("", "<gravity g='9.81'/>"), slope(15.5));
  topples.Step(50);
  // it is on its side on the slope
  CHECK_THAT(topples.Tilt("tall"), WithinAbs(0.5 * ARGOS_PI + 15.5 * ARGOS_PI / 180.0, 0.05));
}

TEST_CASE("rigid stack: an impulse at its middle topples a tall box beyond a certain speed",
          "[contract][engine][rigid]") {
  // About its edge the box has the moment of inertia I = m (w^2 + h^2) / 3. An impulse p at half
  // its height h gives it the rate p h / (2 I), and it topples if the energy lifts its centre of
  // mass from h / 2 to sqrt(w^2 + h^2) / 2.
  const Real width = 0.1;
  const Real height = 0.4;
  const Real diagonal = std::hypot(width, height);
  const Real inertia = diagonal * diagonal / 3.0;
  const Real rate = std::sqrt(2.0 * 9.81 * 0.5 * (diagonal - height) / inertia);
  const Real impulse = rate * 2.0 * inertia / height;
  const Real share = GENERATE(0.85, 1.15);
  CAPTURE(share, impulse);
  // friction high enough that the edge does not slip
  CRigidScene world(
      GroundedEngine("default_friction='3'", KickXml("tall", CVector3(share * impulse, 0, 0))),
      SBoxXml{"tall", CVector3(width, width, height), CVector3()}.ToXml());
  world.Step(30);
  CHECK_THAT(world.Tilt("tall"), WithinAbs(share > 1.0 ? 0.5 * ARGOS_PI : 0.0, 0.01));
}

TEST_CASE("rigid stack: cylinders stand on each other and beside each other",
          "[contract][engine][rigid]") {
  const std::string cylinder =
      "<cylinder id='low' radius='0.1' height='0.2' movable='true' mass='1'><body "
      "position='0,0,0'/></cylinder><cylinder id='high' radius='0.1' height='0.2' movable='true' "
      "mass='1'><body position='0.02,0,0.2'/></cylinder><cylinder id='beside' radius='0.1' "
      "height='0.2' movable='true' mass='1'><body position='-0.2,0,0'/></cylinder>";
  CRigidScene world(GroundedEngine(), cylinder);
  world.Step(50);
  CHECK_THAT(world.Position("low").GetX(), WithinAbs(0.0, 1e-3));
  CHECK_THAT(world.Position("high").GetX(), WithinAbs(0.02, 2e-3));
  CHECK_THAT(world.Position("high").GetZ(), WithinAbs(0.2, 1e-3));
  CHECK_THAT(world.Position("beside").GetX(), WithinAbs(-0.2, 1e-3));
  CHECK(world.Tilt("high") < 0.01);
}

TEST_CASE("rigid stack: a cylinder on its side rolls down a slope with 2/3 of g sin a",
          "[contract][engine][rigid]") {
  const Real angle = 0.1;
  const Real degrees = angle * 180.0 / ARGOS_PI;
  // its axis, the z axis of its body, is along y: turned by 90 degrees about x
  const Real radius = 0.2;
  const CVector3 top((0.1 + radius) * std::sin(angle), 0.0, (0.1 + radius) * std::cos(angle));
  std::ostringstream arena;
  arena << SBoxXml{"slope", CVector3(8, 2, 0.1), CVector3(), CVector3(0, degrees, 0), 0.0}.ToXml()
        << "<cylinder id='c' radius='" << radius
        << "' height='0.4' movable='true' mass='1'><body position='" << top.GetX() << ",0.2,"
        << top.GetZ() << "' orientation='0,0,90'/></cylinder>";
  CRigidScene world(RigidEngine("", "<gravity g='9.81'/>"), arena.str());
  world.Step(10);
  const Real n = 100.0;
  const Real path = 2.0 / 3.0 * 9.81 * std::sin(angle) * 1e-4 * n * (n + 1.0) / 2.0;
  CHECK_THAT((world.Position("c") - CVector3(top.GetX(), 0.2, top.GetZ())).Length(),
             Catch::Matchers::WithinRel(path, 0.02));
}

}  // namespace argos::rigid_stack_test
