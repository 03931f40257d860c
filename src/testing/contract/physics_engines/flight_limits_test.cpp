// Limits of flying robots: the arena, the thrust of their propellers, the length of
// a substep; and refused bodies.

#include <argos3/testing/contract/physics_engines/flight_world.h>

#include <argos3/core/simulator/entity/composable_entity.h>
#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>
#include <argos3/plugins/simulator/physics_engines/pointmass3d/pointmass3d_engine.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>
#include <limits>

namespace argos::flight_limits_test {

using Catch::Matchers::Contains;
using Catch::Matchers::WithinAbs;
using testing::SPDLoop;

namespace {

constexpr Real kSubstep = 0.01;  // s
constexpr UInt32 kSubsteps = 10;
constexpr Real kRounding = 1e-12;
constexpr Real kRadius = 0.25;  // m, of an eye-bot
constexpr Real kHeight = 0.566;  // m

// an arena of 6 x 4 x 3 m on the ground
SFlightExperiment InBox(const std::string& actuator) {
  SFlightExperiment experiment;
  experiment.Actuator = actuator;
  experiment.ArenaSize = "6,4,3' center='1,0,1.5";
  experiment.Arena = EyeBotXml("r", CVector3(1, 0, 1));
  return experiment;
}

// the error of a world with a changed body description
std::string ErrorWithBody(const std::function<void(SBodyDescription&)>& change) {
  SFlightExperiment experiment;
  experiment.Arena = EyeBotXml("r", CVector3());
  CFlightWorld world(experiment);
  CEmbodiedEntity& body = world.Body();
  auto description = std::make_shared<SBodyDescription>(*body.GetBodyDescription());
  change(*description);
  world.GetSpace().RemoveEntityFromPhysicsEngines(body);
  body.SetBodyDescription(std::move(description));
  try {
    world.GetSpace().AddEntityToPhysicsEngine(body);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("flight limits: the borders of the arena stop the surface of a robot",
          "[contract][flight]") {
  CFlightWorld world(InBox("quadrotor_speed"));
  const Real lowest[3] = {-2.0 + kRadius, -2.0 + kRadius, 0.0};
  const Real highest[3] = {4.0 - kRadius, 2.0 - kRadius, 3.0 - kHeight};
  const UInt32 axis = GENERATE(0U, 1U, 2U);
  const Real speed = GENERATE(2.0, -2.0);
  CAPTURE(axis, speed);
  CVector3 velocity;
  velocity[axis] = speed;
  world.Speeds().SetLinearVelocity(velocity);
  world.Step(40);
  CVector3 expected(1, 0, 1);
  expected[axis] = speed > 0.0 ? highest[axis] : lowest[axis];
  for (UInt32 i = 0; i < 3; ++i) {
    CHECK_THAT(world.Position()[i], WithinAbs(expected[i], i == axis ? 0.0 : kRounding));
  }
}

TEST_CASE("flight limits: borders stop a robot with the motion of ARGoS 3, too",
          "[contract][flight]") {
  SFlightExperiment experiment = InBox("quadrotor_speed");
  experiment.Engines = "<pointmass3d id='e' motion='argos3'/>";
  CFlightWorld world(experiment);
  const UInt32 axis = GENERATE(0U, 1U, 2U);
  const Real speed = GENERATE(2.0, -2.0);
  CAPTURE(axis, speed);
  const Real lowest[3] = {-2.0 + kRadius, -2.0 + kRadius, 0.0};
  const Real highest[3] = {4.0 - kRadius, 2.0 - kRadius, 3.0 - kHeight};
  CVector3 velocity;
  velocity[axis] = speed;
  world.Speeds().SetLinearVelocity(velocity);
  world.Step(200);
  CHECK(world.Position()[axis] == (speed > 0.0 ? highest[axis] : lowest[axis]));
}

TEST_CASE("flight limits: a robot leaves a border at once, because its speed there is zero",
          "[contract][flight]") {
  // the second implementation of the specification, bounded by the wall
  CFlightWorld world(InBox("quadrotor_speed"));
  SPDLoop loop = EyeBotVelocity();
  loop.Place = 1.0;
  loop.Highest = 4.0 - kRadius;
  const auto step = [&](Real speed, int ticks) {
    world.Speeds().SetLinearVelocity(CVector3(speed, 0, 0));
    for (int tick = 0; tick < ticks; ++tick) {
      world.Step();
      for (UInt32 i = 0; i < kSubsteps; ++i) {
        loop.StepToSpeed(speed, kSubstep);
      }
      REQUIRE_THAT(world.Position().GetX(), WithinAbs(loop.Place, kRounding));
    }
  };
  step(3.0, 30);
  REQUIRE(world.Position().GetX() == loop.Highest);
  step(-3.0, 1);
  // from rest: in 0.1 s it gains a speed of 3 (1 - e^-2)
  CHECK(world.Position().GetX() < loop.Highest - 0.1);
}

TEST_CASE("flight limits: with a target outside the arena the robot stops at the border",
          "[contract][flight]") {
  CFlightWorld world(InBox("quadrotor_position"));
  world.Places().SetAbsolutePosition(CVector3(100, -100, 100));
  world.Step(50);
  CHECK(world.Position() == CVector3(4.0 - kRadius, -2.0 + kRadius, 3.0 - kHeight));
  world.Places().SetAbsolutePosition(CVector3(1, 0, 0.5));
  world.Step(80);
  CHECK_THAT(Distance(world.Position(), CVector3(1, 0, 0.5)), WithinAbs(0.0, 1e-6));
}

TEST_CASE("flight limits: thrust is bounded along each axis", "[contract][flight]") {
  // a step of 200 m requires 4000 N at first, and 2900 N at the end of the tick
  CFlightWorld world([] {
    SFlightExperiment experiment;
    experiment.ArenaSize = "1000,40,40";
    experiment.Arena = EyeBotXml("r", CVector3());
    return experiment;
  }());
  SPDLoop loop = EyeBotPlace();
  world.Places().SetAbsolutePosition(CVector3(200, 0, 0));
  for (int tick = 0; tick < 20; ++tick) {
    world.Step();
    for (UInt32 i = 0; i < kSubsteps; ++i) {
      loop.StepToPlace(200.0, kSubstep);
    }
    // positions up to 200 m
    CHECK_THAT(world.Position().GetX(), WithinAbs(loop.Place, 1e-10));
    if (tick == 0) {
      // 1000 N / 1 kg, (0.1 s)^2 / 2
      CHECK_THAT(world.Position().GetX(), WithinAbs(5.0, kRounding));
    }
  }
}

TEST_CASE("flight limits: a robot too heavy for its propellers falls", "[contract][flight]") {
  // 1500 N down, 1000 N up: 500 m/s^2
  SFlightExperiment experiment;
  experiment.Engines = "<pointmass3d id='e' gravity='-1500'/>";
  experiment.Arena = EyeBotXml("r", CVector3(0, 0, 10));
  CFlightWorld world(experiment);
  world.Step();
  CHECK_THAT(world.Position().GetZ(), WithinAbs(10.0 - 0.5 * 500.0 * 0.1 * 0.1, kRounding));
  world.Step(5);
  // it stops at the lower border of the arena
  CHECK(world.Position().GetZ() == -20.0);
}

TEST_CASE("flight limits: the number of substeps follows from the robots", "[contract][flight]") {
  struct SCase {
    UInt32 TicksPerSecond;
    std::string Iterations;
    UInt32 Expected;
  };
  // an eye-bot needs substeps of at most 1/30 s: its loop on velocity has a time constant of 1/20 s
  const SCase c =
      GENERATE(SCase{10, "", 10}, SCase{10, "1", 3}, SCase{10, "3", 3}, SCase{10, "25", 25},
               SCase{1, "", 30}, SCase{30, "1", 1}, SCase{29, "1", 2});
  CAPTURE(c.TicksPerSecond, c.Iterations);
  SFlightExperiment experiment;
  experiment.TicksPerSecond = c.TicksPerSecond;
  experiment.Engines = "<pointmass3d id='e' " +
                       (c.Iterations.empty() ? "" : "iterations='" + c.Iterations + "'") + "/>";
  experiment.Arena = EyeBotXml("r", CVector3());
  CFlightWorld world(experiment);
  auto& engine =
      dynamic_cast<CPointMass3DEngine&>(*world.GetSimulator().GetPhysicsEngines().front());
  CHECK(engine.GetSubsteps() == c.Expected);
  world.Step();
  // the robot responds to a step of the target and settles
  world.Places().SetAbsolutePosition(CVector3(0.1, 0, 0));
  world.Step(10 * c.TicksPerSecond);
  CHECK_THAT(world.Position().GetX(), WithinAbs(0.1, 1e-6));
  CHECK(engine.GetIterations() == (c.Iterations.empty() ? 10 : std::stoul(c.Iterations)));
}

TEST_CASE("flight limits: the robot with the fastest controller sets the number of substeps",
          "[contract][flight]") {
  SFlightExperiment experiment;
  experiment.Engines = "<pointmass3d id='e' iterations='1'/>";
  experiment.Arena = EyeBotXml("a", CVector3()) + EyeBotXml("b", CVector3(2, 0, 0));
  CFlightWorld world(experiment);
  // the velocity loop of one has the rate 40 / s instead of 20 / s; it enters first or last
  const std::string fast = GENERATE("a", "b");
  CAPTURE(fast);
  for (const std::string id : {"a", "b"}) {
    CEmbodiedEntity& body = world.Body(id);
    auto description = std::make_shared<SBodyDescription>(*body.GetBodyDescription());
    description->Propellers->Velocity.Proportional *= id == fast ? 2.0 : 1.0;
    world.GetSpace().RemoveEntityFromPhysicsEngines(body);
    body.SetBodyDescription(std::move(description));
    world.GetSpace().AddEntityToPhysicsEngine(body);
  }
  auto& engine =
      dynamic_cast<CPointMass3DEngine&>(*world.GetSimulator().GetPhysicsEngines().front());
  CHECK(engine.GetSubsteps() == 6);
}

TEST_CASE("flight limits: bodies that cannot fly are refused with a reason",
          "[contract][flight][errors]") {
  SFlightExperiment experiment;
  experiment.Arena = EyeBotXml("r", CVector3());
  const auto error = [&experiment] { return LoadError(experiment.ToExperiment()); };
  REQUIRE(error() == "");

  experiment.ArenaSize = "0.4,10,10";
  CHECK_THAT(error(), Contains("the arena, of the size \"0.4,10,10\" m, is too small for \"r\"") &&
                          Contains("0.5 m along x and y, and 0.566 m of height"));
  experiment.ArenaSize = "10,10,0.5";
  CHECK_THAT(error(), Contains("is too small for \"r\""));
  experiment.ArenaSize = "10,10,10";

  experiment.Engines = "<dynamics2d id='e'/>";
  CHECK_THAT(error(), Contains("accepts \"r\" (<eye-bot>)") &&
                          Contains("\"e\" is two-dimensional, but a <eye-bot> flies") &&
                          Contains("<pointmass3d>"));
  experiment.Engines = "<pointmass3d id='e' gravity='inf'/>";
  CHECK_THAT(error(), Contains("attribute \"gravity\": found \"inf\", expected a real number"));
}

TEST_CASE("flight limits: a body that could not be controlled is refused",
          "[contract][flight][errors]") {
  CHECK(ErrorWithBody([](SBodyDescription&) {}) == "");
  CHECK_THAT(ErrorWithBody([](SBodyDescription& body) { body.Mass = 0.0; }),
             Contains("\"r\": mass (kg) must be a number > 0, got 0"));
  CHECK_THAT(ErrorWithBody([](SBodyDescription& body) { body.PlanarInertia = -1.0; }),
             Contains("\"r\": moment of inertia (kg m^2) must be a number > 0, got -1"));
  CHECK_THAT(
      ErrorWithBody([](SBodyDescription& body) { body.Propellers->Position.Derivative = 0.0; }),
      Contains("\"r\": derivative gain on position must be a number > 0, got 0"));
  CHECK_THAT(
      ErrorWithBody([](SBodyDescription& body) { body.Propellers->Yaw.Proportional = -2.0; }),
      Contains("\"r\": proportional gain on yaw must be a number > 0, got -2"));
  CHECK_THAT(
      ErrorWithBody([](SBodyDescription& body) { body.Propellers->Velocity.Derivative = -1.0; }),
      Contains("\"r\": derivative gain on velocity must be a number >= 0, got -1"));
  CHECK_THAT(ErrorWithBody([](SBodyDescription& body) {
               body.Propellers->YawRate.Proportional = std::numeric_limits<Real>::quiet_NaN();
             }),
             Contains("proportional gain on yaw rate must be a number > 0"));
  CHECK_THAT(ErrorWithBody([](SBodyDescription& body) { body.Propellers->MaxForce = 0.0; }),
             Contains("\"r\": greatest force of the propellers (N) must be a number > 0"));
  CHECK_THAT(ErrorWithBody([](SBodyDescription& body) { body.Propellers->MaxTorque = 0.0; }),
             Contains("greatest torque of the propellers (N m) must be a number > 0"));
  // an eye-bot needs 3 substeps in a tick of 0.1 s; at most 10,000 are possible
  const auto withSubsteps = [](Real substeps) {
    return ErrorWithBody([substeps](SBodyDescription& body) {
      body.Propellers->Velocity.Proportional *= substeps / 3.0;
    });
  };
  CHECK(withSubsteps(9999.5) == "");
  CHECK_THAT(withSubsteps(10000.5), Contains("would take more than 10000"));
  // its time constant is 1e-6 s: 150,000 substeps in a tick
  CHECK_THAT(
      ErrorWithBody([](SBodyDescription& body) { body.Propellers->Position.Derivative = 1e6; }),
      Contains("\"r\" need substeps of at most 6.66667e-07 s") &&
          Contains("raise \"ticks_per_second\""));
}

TEST_CASE("flight limits: a flying robot needs a quadrotor component",
          "[contract][flight][errors]") {
  SFlightExperiment experiment;
  experiment.Arena = "<box id='r' size='1,1,1' movable='true' mass='1'><body/></box>";
  CFlightWorld world(experiment);
  CEmbodiedEntity& body = world.Body();
  auto description = std::make_shared<SBodyDescription>(*body.GetBodyDescription());
  description->Propellers =
      SPropellersDescription{{20, 10}, {0.5, 0.1}, {20, 0}, {0.5, 0.1}, 10, 10};
  world.GetSpace().RemoveEntityFromPhysicsEngines(body);
  body.SetBodyDescription(std::move(description));
  CHECK_THROWS_WITH(world.GetSpace().AddEntityToPhysicsEngine(body), Contains("\"quadrotor\""));
}

}  // namespace argos::flight_limits_test
