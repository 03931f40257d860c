// Robots with propellers as rigid bodies.

#include <argos3/testing/contract/physics_engines/flight_world.h>
#include <argos3/testing/contract/physics_engines/rigid_scene.h>

#include <argos3/core/utility/math/angles.h>

#include <catch2/catch.hpp>

#include <algorithm>
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
  // within 2 % after 1.6 s in continuous time, see the README of pointmass3d
  world.Step(25);
  CHECK_THAT(world.Position().GetX(), WithinAbs(0.0, 0.02 * 1.75));
}

TEST_CASE("rigid flight: the response to a step is that of continuous time for any substeps",
          "[contract][engine][rigid]") {
  const UInt32 substeps = GENERATE(1U, 10U, 100U, 1000U);
  CAPTURE(substeps);
  const std::string iterations = "iterations='" + std::to_string(substeps) + "'";
  CFlightWorld world(
      Flight("quadrotor_position", RigidEngine(iterations, "<gravity g='9.81'/>"), CVector3()));
  world.Places().SetAbsolutePosition(CVector3(1, 0, 0));
  world.Places().SetAbsoluteYaw(CRadians(1.0));
  // ODE moves a body by its speed at the end of the substep, so half a substep too far; the speeds
  // are at most 1.4 m/s and 2.9 rad/s
  const Real half = 0.5 * 0.1 / std::max<Real>(3.0, substeps);
  for (int tick = 1; tick <= 20; ++tick) {
    world.Step();
    CAPTURE(tick);
    CHECK_THAT(
        world.Position().GetX(),
        WithinAbs(testing::ComputeContinuousResponse(EyeBotPlace(), 0.1 * tick), 1.4 * half));
    CHECK_THAT(world.Yaw(),
               WithinAbs(testing::ComputeContinuousResponse(EyeBotYaw(), 0.1 * tick), 2.9 * half));
  }
}

TEST_CASE("rigid flight: a robot turns the shorter way, also across 180 degrees",
          "[contract][engine][rigid]") {
  const Real side = GENERATE(1.0, -1.0);
  // full turns of a target do not count
  const Real turns = GENERATE(0.0, 1.0);
  CAPTURE(side, turns);
  CFlightWorld world(
      Flight("quadrotor_position", GroundedEngine(), CVector3(0, 0, 1), side * 170.0));
  world.Places().SetAbsoluteYaw(
      CRadians(-side * 170.0 * ARGOS_PI / 180.0 + turns * 2.0 * ARGOS_PI));
  for (int tick = 1; tick <= 30; ++tick) {
    world.Step();
    // 20 degrees, of which the response overshoots by 4.3 %
    CAPTURE(tick);
    const Real beyond = std::remainder(side * world.Yaw() - ARGOS_PI, 2.0 * ARGOS_PI);
    CHECK_THAT(beyond, WithinAbs(0.0, 11.0 * ARGOS_PI / 180.0));
  }
  CHECK_THAT(std::remainder(world.Yaw() + side * 170.0 * ARGOS_PI / 180.0, 2.0 * ARGOS_PI),
             WithinAbs(0.0, 1e-3));
}

TEST_CASE("rigid flight: a robot placed on its side returns upright", "[contract][engine][rigid]") {
  CFlightWorld world(Flight("quadrotor_position", GroundedEngine(), CVector3(0, 0, 2)));
  world.Step();
  // also upside down, where no side is nearer than another
  const CQuaternion side =
      GENERATE(CQuaternion(CRadians(1.5), CVector3::X), CQuaternion(0.0, 1.0, 0.0, 0.0),
               CQuaternion(0.0, 0.0, 1.0, 0.0));
  REQUIRE(world.Body().MoveTo(CVector3(0, 0, 2), side));
  world.Step(50);
  CVector3 up = CVector3::Z;
  up.Rotate(world.Body().GetOriginAnchor().Orientation);
  CHECK_THAT(up.GetZ(), WithinAbs(1.0, 1e-4));
  CHECK(Distance(world.Position(), CVector3(0, 0, 2)) < 0.01);
}

}  // namespace argos::rigid_flight_test
