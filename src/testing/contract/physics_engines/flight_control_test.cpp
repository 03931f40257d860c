// Compares the flight controllers with closed forms and with a second
// implementation of their specification.

#include <argos3/testing/contract/physics_engines/flight_world.h>

#include <argos3/plugins/robots/eye-bot/simulator/eyebot_entity.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace argos::flight_control_test {

using Catch::Matchers::WithinAbs;
using testing::ComputeContinuousResponse;
using testing::ComputeContinuousWay;
using testing::ComputeStepResponse;
using testing::ComputeWayToSpeed;
using testing::SPDLoop;

namespace {

constexpr Real kSubstep = 0.01;  // s: 10 in a tick of 0.1 s
constexpr UInt32 kSubsteps = 10;
// tolerance for thousands of roundings of numbers below 10, which the loops damp
constexpr Real kRounding = 1e-12;

SFlightExperiment OneRobot(const std::string& actuator, const CVector3& position = CVector3(),
                           Real yaw = 0.0) {
  SFlightExperiment experiment;
  experiment.Actuator = actuator;
  experiment.Arena = EyeBotXml("r", position, yaw);
  return experiment;
}

// the difference of two angles, in [-pi, pi]
Real Difference(Real a, Real b) {
  return std::remainder(a - b, 2.0 * std::numbers::pi);
}

}  // namespace

TEST_CASE("flight: a robot without orders hovers at a bit-identical position",
          "[contract][flight]") {
  const std::string actuator =
      GENERATE(as<std::string>(), "", "quadrotor_position", "quadrotor_speed");
  const Real gravity = GENERATE(-9.81, 0.0, 3.7);
  CAPTURE(actuator, gravity);
  SFlightExperiment experiment = OneRobot(actuator, CVector3(1.1, -2.3, 0.7), 33.0);
  experiment.Engines = "<pointmass3d id='e' gravity='" + std::to_string(gravity) + "'/>";
  CFlightWorld world(experiment);
  const Real yaw = world.Yaw();
  world.Step(300);
  CHECK(world.Position() == CVector3(1.1, -2.3, 0.7));
  // the yaw is stored as an angle
  CHECK_THAT(world.Yaw(), WithinAbs(yaw, 1e-15));
}

TEST_CASE("flight: the response to a step of the target follows the recurrence",
          "[contract][flight]") {
  const CVector3 start(1.0, -2.0, 3.0);
  const CVector3 step = GENERATE(CVector3(0.5, 0, 0), CVector3(0, 0.5, 0), CVector3(0, 0, 0.5),
                                 CVector3(-0.2, 0.3, -0.4));
  CAPTURE(step);
  CFlightWorld world(OneRobot("quadrotor_position", start));
  world.Step();
  world.Places().SetAbsolutePosition(start + step);
  const Real a = 20.0 * kSubstep * kSubstep;
  const Real b = 10.0 * kSubstep;
  for (UInt32 tick = 1; tick <= 60; ++tick) {
    world.Step();
    const Real share = ComputeStepResponse(a, b, tick * kSubsteps);
    CHECK_THAT(Distance(world.Position(), start + step * share), WithinAbs(0.0, kRounding));
  }
  // the robot has arrived
  CHECK_THAT(Distance(world.Position(), start + step), WithinAbs(0.0, 1e-5));
}

TEST_CASE("flight: the response follows the recurrence for any number of substeps",
          "[contract][flight]") {
  const UInt32 substeps = GENERATE(3U, 5U, 10U, 1000U);
  CAPTURE(substeps);
  SFlightExperiment experiment = OneRobot("quadrotor_position");
  experiment.Engines = "<pointmass3d id='e' iterations='" + std::to_string(substeps) + "'/>";
  CFlightWorld world(experiment);
  world.Places().SetAbsolutePosition(CVector3(0.5, 0, 0));
  const Real substep = 0.1 / substeps;
  for (UInt32 tick = 1; tick <= 30; ++tick) {
    world.Step();
    const Real share =
        ComputeStepResponse(20.0 * substep * substep, 10.0 * substep, tick * substeps);
    // a thousand roundings in each tick
    CHECK_THAT(world.Position().GetX(), WithinAbs(0.5 * share, kRounding));
  }
}

TEST_CASE("flight: the response to a step is that of continuous time for any number of substeps",
          "[contract][flight]") {
  // 1 becomes 3, see the test of the number of substeps
  const UInt32 substeps = GENERATE(1U, 10U, 100U, 1000U);
  // the bound of the engine's README, and a second-order error
  const Real share = 3.0 / std::max<Real>(3.0, substeps);
  const Real bound = 0.0025 * share * share;
  CAPTURE(substeps);
  const auto run = [&](const std::string& actuator, const auto& order, const auto& check) {
    SFlightExperiment experiment = OneRobot(actuator);
    experiment.Engines = "<pointmass3d id='e' iterations='" + std::to_string(substeps) + "'/>";
    CFlightWorld world(experiment);
    order(world);
    for (UInt32 tick = 1; tick <= 20; ++tick) {
      world.Step();
      CAPTURE(tick);
      check(world, 0.1 * tick);
    }
  };
  run(
      "quadrotor_position",
      [](CFlightWorld& world) {
        world.Places().SetAbsolutePosition(CVector3(1, 0, 0));
        world.Places().SetAbsoluteYaw(CRadians(1.0));
      },
      [&](CFlightWorld& world, Real time) {
        CHECK_THAT(world.Position().GetX(),
                   WithinAbs(ComputeContinuousResponse(EyeBotPlace(), time), bound));
        CHECK_THAT(world.Yaw(), WithinAbs(ComputeContinuousResponse(EyeBotYaw(), time), bound));
      });
  run(
      "quadrotor_speed",
      [](CFlightWorld& world) {
        world.Speeds().SetLinearVelocity(CVector3(1, 0, 0));
        world.Speeds().SetRotationalSpeed(CRadians(1.0));
      },
      [&](CFlightWorld& world, Real time) {
        CHECK_THAT(world.Position().GetX(),
                   WithinAbs(ComputeContinuousWay(EyeBotVelocity(), time), bound));
        CHECK_THAT(world.Yaw(), WithinAbs(ComputeContinuousWay(EyeBotYawRate(), time), bound));
      });
}

TEST_CASE("flight: a target that moves ahead by the lead Kd / Kp + T / 2 is followed at its speed",
          "[contract][flight]") {
  // with the target v (Kd / Kp + T / 2) ahead in each tick of T, the mean force at the speed v is 0
  CFlightWorld world(OneRobot("quadrotor_position"));
  const auto follow = [&world](int ticks) {
    for (int tick = 0; tick < ticks; ++tick) {
      world.Places().SetRelativePosition(CVector3(0.4 * (10.0 / 20.0 + 0.05), 0, 0));
      world.Step();
    }
  };
  follow(50);
  const CVector3 before = world.Position();
  follow(10);
  CHECK_THAT(world.Position().GetX() - before.GetX(), WithinAbs(0.4, 1e-3));
}

TEST_CASE("flight: position orders of all kinds follow the specification", "[contract][flight]") {
  // distant targets, so that thrust is limited, and new targets before the robot arrives
  CFlightWorld world(OneRobot("quadrotor_position", CVector3(0.5, 0.25, 1.0), 90.0));
  SPDLoop axes[3] = {EyeBotPlace(), EyeBotPlace(), EyeBotPlace()};
  axes[2].Weight = -9.81;
  SPDLoop yaw = EyeBotYaw();
  CVector3 target(0.5, 0.25, 1.0);
  Real yawTarget = 0.5 * std::numbers::pi;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    axes[axis].Place = target[axis];
  }
  yaw.Place = yawTarget;
  for (UInt32 tick = 0; tick < 120; ++tick) {
    if (tick == 10) {
      target = CVector3(7.0, -3.0, 5.0);
      world.Places().SetAbsolutePosition(target);
    } else if (tick == 14) {
      yawTarget = -2.5;
      world.Places().SetAbsoluteYaw(CRadians(yawTarget));
    } else if (tick == 30) {
      // 2 m ahead and 1 m to the left in the present orientation
      CVector3 offset(2.0, 1.0, -0.5);
      offset.Rotate(world.Body().GetOriginAnchor().Orientation);
      target = world.Position() + offset;
      world.Places().SetRelativePosition(CVector3(2.0, 1.0, -0.5));
    } else if (tick == 33) {
      yawTarget = world.Yaw() + 1.25;
      world.Places().SetRelativeYaw(CRadians(1.25));
    }
    world.Step();
    for (UInt32 i = 0; i < kSubsteps; ++i) {
      for (UInt32 axis = 0; axis < 3; ++axis) {
        axes[axis].StepToPlace(target[axis], kSubstep);
      }
      yaw.StepToPlace(yawTarget, kSubstep);
    }
    CAPTURE(tick);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      CHECK_THAT(world.Position()[axis], WithinAbs(axes[axis].Place, kRounding));
    }
    CHECK_THAT(Difference(world.Yaw(), yaw.Place), WithinAbs(0.0, kRounding));
  }
}

TEST_CASE("flight: the velocity approaches the order as a geometric series", "[contract][flight]") {
  const CVector3 velocity = GENERATE(CVector3(1, 0, 0), CVector3(0, -0.7, 0), CVector3(0, 0, 2),
                                     CVector3(0.3, 0.2, -0.1));
  const Real yaw = GENERATE(0.0, 120.0);  // degrees; velocities are in the world frame
  CAPTURE(velocity, yaw);
  CFlightWorld world(OneRobot("quadrotor_speed", CVector3(), yaw));
  world.Speeds().SetLinearVelocity(velocity);
  for (UInt32 tick = 1; tick <= 50; ++tick) {
    world.Step();
    const Real way = kSubstep * ComputeWayToSpeed(20.0 * kSubstep, tick * kSubsteps);
    CHECK_THAT(Distance(world.Position(), velocity * way), WithinAbs(0.0, kRounding));
  }
  const CVector3 before = world.Position();
  world.Step(10);
  // finally the velocity is exactly the ordered one
  CHECK_THAT(Distance(world.Position() - before, velocity), WithinAbs(0.0, kRounding));
}

TEST_CASE("flight: the yaw rate approaches the order as a geometric series", "[contract][flight]") {
  const Real rate = GENERATE(0.5, -2.0, 25.0);  // rad/s
  CAPTURE(rate);
  CFlightWorld world(OneRobot("quadrotor_speed", CVector3(1, 2, 3)));
  world.Speeds().SetRotationalSpeed(CRadians(rate));
  // the derivative of the error counts as inertia
  const Real p = 0.5 * kSubstep / (0.01 + 0.1);
  for (UInt32 tick = 1; tick <= 100; ++tick) {
    world.Step();
    const Real way = kSubstep * ComputeWayToSpeed(p, tick * kSubsteps);
    // up to 40 turns, rounded in every substep
    CHECK_THAT(Difference(world.Yaw(), rate * way), WithinAbs(0.0, 1e-11));
  }
  CHECK(world.Position() == CVector3(1, 2, 3));
}

TEST_CASE("flight: changing speed orders follow the specification", "[contract][flight]") {
  CFlightWorld world(OneRobot("quadrotor_speed"));
  SPDLoop axes[3] = {EyeBotVelocity(), EyeBotVelocity(), EyeBotVelocity()};
  axes[2].Weight = -9.81;
  SPDLoop yaw = EyeBotYawRate();
  CVector3 velocity;
  Real rate = 0.0;
  for (UInt32 tick = 0; tick < 90; ++tick) {
    if (tick % 7 == 0) {
      velocity = CVector3(std::sin(tick), std::cos(tick), 0.5 * std::sin(2.0 * tick));
      rate = 2.0 * std::cos(3.0 * tick);
      world.Speeds().SetLinearVelocity(velocity);
      world.Speeds().SetRotationalSpeed(CRadians(rate));
    }
    world.Step();
    for (UInt32 i = 0; i < kSubsteps; ++i) {
      for (UInt32 axis = 0; axis < 3; ++axis) {
        axes[axis].StepToSpeed(velocity[axis], kSubstep);
      }
      yaw.StepToSpeed(rate, kSubstep);
    }
    CAPTURE(tick);
    for (UInt32 axis = 0; axis < 3; ++axis) {
      CHECK_THAT(world.Position()[axis], WithinAbs(axes[axis].Place, kRounding));
    }
    CHECK_THAT(Difference(world.Yaw(), yaw.Place), WithinAbs(0.0, kRounding));
  }
}

TEST_CASE("flight: a robot turns the shorter way, also across 180 degrees", "[contract][flight]") {
  // from 170 to 190 degrees, and the same mirrored
  const Real side = GENERATE(1.0, -1.0);
  const Real start = 170.0 / 180.0 * std::numbers::pi;
  const Real step = 20.0 / 180.0 * std::numbers::pi;
  CAPTURE(side);
  CFlightWorld world(OneRobot("quadrotor_position", CVector3(), side * 170.0));
  // -170 degrees plus full turns: a yaw is defined up to full turns
  const Real turns = GENERATE(0.0, 2.0, -1.0);
  world.Places().SetAbsoluteYaw(CRadians(-side * start + 2.0 * std::numbers::pi * turns));
  const Real a = 0.5 * kSubstep * kSubstep / 0.01;
  const Real b = 0.1 * kSubstep / 0.01;
  for (UInt32 tick = 1; tick <= 40; ++tick) {
    world.Step();
    const Real expected = side * (start + step * ComputeStepResponse(a, b, tick * kSubsteps));
    CHECK_THAT(Difference(world.Yaw(), expected), WithinAbs(0.0, kRounding));
  }
}

TEST_CASE("flight: a target that crosses 180 degrees turns the robot to the other side",
          "[contract][flight]") {
  // While the robot still has to turn far to one side, the target moves slightly, so that the
  // shorter way is to the other side.
  CFlightWorld world(OneRobot("quadrotor_position"));
  SPDLoop loop = EyeBotYaw();
  const auto step = [&](Real target) {
    world.Places().SetAbsoluteYaw(CRadians(target));
    world.Step();
    for (UInt32 i = 0; i < kSubsteps; ++i) {
      loop.StepToPlace(target, kSubstep);
    }
    CHECK_THAT(Difference(world.Yaw(), loop.Place), WithinAbs(0.0, kRounding));
  };
  step(3.0);
  const Real target = loop.Place + std::numbers::pi + 0.3;
  for (int tick = 0; tick < 30; ++tick) {
    step(target);
  }
  CHECK_THAT(Difference(world.Yaw(), target), WithinAbs(0.0, 1e-3));
}

TEST_CASE("flight: orders are kept when switching between POSITION_CONTROL and SPEED_CONTROL",
          "[contract][flight]") {
  // loop functions of users may switch the control method
  CFlightWorld world(OneRobot(""));
  CQuadRotorEntity& quadrotor = world.Get<CEyeBotEntity>("r").GetQuadRotorEntity();
  quadrotor.SetSpeedControlData({CVector3(1, 0, 0), CRadians()});
  quadrotor.SetPositionControlData({CVector3(5, 0, 0), CRadians()});
  SPDLoop loop = EyeBotVelocity();
  const auto step = [&](bool onPlace, UInt32 ticks) {
    loop.Proportional = onPlace ? EyeBotPlace().Proportional : EyeBotVelocity().Proportional;
    loop.Derivative = onPlace ? EyeBotPlace().Derivative : EyeBotVelocity().Derivative;
    world.Step(ticks);
    for (UInt32 i = 0; i < ticks * kSubsteps; ++i) {
      onPlace ? loop.StepToPlace(5.0, kSubstep) : loop.StepToSpeed(1.0, kSubstep);
    }
    CHECK_THAT(world.Position().GetX(), WithinAbs(loop.Place, kRounding));
  };
  step(false, 10);
  quadrotor.SetControlMethod(CQuadRotorEntity::POSITION_CONTROL);
  step(true, 10);
  quadrotor.SetControlMethod(CQuadRotorEntity::SPEED_CONTROL);
  step(false, 10);
  quadrotor.SetControlMethod(CQuadRotorEntity::POSITION_CONTROL);
  step(true, 30);
}

}  // namespace argos::flight_control_test
