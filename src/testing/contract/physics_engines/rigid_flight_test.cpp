// Robots with propellers as rigid bodies.

#include <argos3/testing/contract/physics_engines/flight_world.h>
#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <cmath>

namespace argos::rigid_flight_test {

using Catch::Matchers::WithinAbs;

namespace {

SFlightExperiment Flight(const std::string& actuator, const std::string& engine,
                         const CVector3& position, Real yaw = 0.0) {
  SFlightExperiment experiment;
  experiment.Actuator = actuator;
  experiment.Engines = engine;
  experiment.Arena = EyeBotXml("r", position, yaw);
  return experiment;
}

}  // namespace

TEST_CASE("rigid flight: a robot without orders hovers under any gravity",
          "[contract][engine][rigid]") {
  const std::string gravity =
      GENERATE("<gravity g='0'/>", "<gravity g='9.81'/>", "<gravity vector='1,-2,3.5'/>");
  CAPTURE(gravity);
  CFlightWorld world(Flight("", RigidEngine("", gravity), CVector3(1.1, -2.3, 0.7), 33.0));
  world.Step(300);
  CHECK(Distance(world.Position(), CVector3(1.1, -2.3, 0.7)) < 1e-9);
  CHECK_THAT(world.Yaw(), WithinAbs(33.0 * ARGOS_PI / 180.0, 1e-9));
}

TEST_CASE("rigid flight: a robot flies to the ordered position and yaw and hovers there",
          "[contract][engine][rigid]") {
  CFlightWorld world(Flight("quadrotor_position", GroundedEngine(), CVector3(0, 0, 0)));
  world.Places().SetAbsolutePosition(CVector3(1.0, -2.0, 1.5));
  world.Places().SetAbsoluteYaw(CRadians(2.5));
  world.Step(60);
  CHECK(Distance(world.Position(), CVector3(1.0, -2.0, 1.5)) < 1e-3);
  CHECK_THAT(world.Yaw(), WithinAbs(2.5, 1e-3));
  world.Step(100);
  CHECK(Distance(world.Position(), CVector3(1.0, -2.0, 1.5)) < 1e-6);
}

TEST_CASE("rigid flight: a robot flies at the ordered speed", "[contract][engine][rigid]") {
  CFlightWorld world(Flight("quadrotor_speed", GroundedEngine(), CVector3(0, 0, 1)));
  world.Speeds().SetLinearVelocity(CVector3(0.3, 0.2, 0.1));
  world.Speeds().SetRotationalSpeed(CRadians(0.5));
  // the yaw rate approaches its target at a rate of 4.5 / s
  world.Step(50);
  const CVector3 before = world.Position();
  const Real yaw = world.Yaw();
  world.Step(10);
  CHECK(Distance(world.Position() - before, CVector3(0.3, 0.2, 0.1)) < 1e-6);
  CHECK_THAT(world.Yaw() - yaw, WithinAbs(0.5, 1e-5));
}

TEST_CASE("rigid flight: a robot stops at a wall, and its step response is that of the loop",
          "[contract][engine][rigid]") {
  SFlightExperiment experiment = Flight("quadrotor_position", GroundedEngine(), CVector3(0, 0, 1));
  experiment.Arena +=
      "<box id='wall' size='0.2,4,4' movable='false'><body position='2.1,0,0'/></box>";
  CFlightWorld world(experiment);
  world.Places().SetAbsolutePosition(CVector3(2.0, 0.0, 1.0));
  world.Step(100);
  // its arms reach 0.25 m
  CHECK_THAT(world.Position().GetX(), WithinAbs(1.75, 0.01));
  world.Places().SetAbsolutePosition(CVector3(0.0, 0.0, 1.0));
  // within 2 % after 1.3 s in continuous time, see the README of pointmass3d
  world.Step(25);
  CHECK_THAT(world.Position().GetX(), WithinAbs(0.0, 0.02 * 1.75));
}

TEST_CASE("rigid flight: a robot placed on its side returns upright", "[contract][engine][rigid]") {
  CFlightWorld world(Flight("quadrotor_position", GroundedEngine(), CVector3(0, 0, 2)));
  world.Step();
  const CQuaternion side(CRadians(1.5), CVector3::X);
  REQUIRE(world.Body().MoveTo(CVector3(0, 0, 2), side));
  world.Step(50);
  CVector3 up = CVector3::Z;
  up.Rotate(world.Body().GetOriginAnchor().Orientation);
  CHECK_THAT(up.GetZ(), WithinAbs(1.0, 1e-4));
  CHECK(Distance(world.Position(), CVector3(0, 0, 2)) < 0.01);
}

}  // namespace argos::rigid_flight_test
