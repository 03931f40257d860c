// The gains of the flight loops against the equations that they solve, and their stability.

#include <argos3/plugins/simulator/physics_engines/robot_bodies/flight_loop.h>

#include <argos3/core/utility/math/random_stream.h>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <cmath>

namespace flight_loop_test {

using namespace argos;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// a random factor, log-uniform over four decades
Real RandomFactor(CRandomStream& random) {
  return std::pow(10.0, random.Uniform(-2.0, 2.0));
}

}  // namespace

TEST_CASE("flight loops: a position loop applies the force of the middle of the substep",
          "[pointmass3d]") {
  CRandomStream random(3, "test", "flight loops", "");
  for (int i = 0; i < 200; ++i) {
    const SControlGains gains{RandomFactor(random), RandomFactor(random)};
    const Real inertia = RandomFactor(random);
    const Real substep = 0.1 * RandomFactor(random);
    const Real error = random.Uniform(-1.0, 1.0);
    const Real speed = random.Uniform(-1.0, 1.0);
    CAPTURE(gains.Proportional, gains.Derivative, inertia, substep, error, speed);
    const SSubstepGains chosen = ComputePositionGains(gains, inertia, substep);
    const Real force = chosen.Error * error - chosen.Speed * speed;
    const Real middleSpeed = speed + 0.5 * substep * force / inertia;
    const Real middleError = error - 0.5 * substep * middleSpeed;
    CHECK_THAT(force, WithinAbs(gains.Proportional * middleError - gains.Derivative * middleSpeed,
                                1e-10 * (gains.Proportional + gains.Derivative) *
                                    (1.0 + substep + substep * substep)));
  }
}

TEST_CASE("flight loops: a position loop is stable in substeps of any length", "[pointmass3d]") {
  CRandomStream random(5, "test", "flight loops", "");
  for (int i = 0; i < 200; ++i) {
    const SControlGains gains{RandomFactor(random), RandomFactor(random)};
    const Real inertia = RandomFactor(random);
    const Real h = RandomFactor(random);
    CAPTURE(gains.Proportional, gains.Derivative, inertia, h);
    const SSubstepGains chosen = ComputePositionGains(gains, inertia, h);
    const Real perError = chosen.Error / inertia;
    const Real perSpeed = chosen.Speed / inertia;
    Eigen::Matrix2d step;
    step << 1.0 - 0.5 * h * h * perError, h - 0.5 * h * h * perSpeed, -h * perError,
        1.0 - h * perSpeed;
    CHECK(step.eigenvalues().cwiseAbs().maxCoeff() < 1.0);
  }
}

TEST_CASE("flight loops: a speed loop shrinks the error in substeps of any length",
          "[pointmass3d]") {
  CRandomStream random(4, "test", "flight loops", "");
  for (int i = 0; i < 200; ++i) {
    const SControlGains gains{RandomFactor(random), i % 2 == 0 ? 0.0 : RandomFactor(random)};
    const Real inertia = RandomFactor(random);
    const Real h = RandomFactor(random);
    // the midpoint rule: (1 - q) / (1 + q) with q = Kp h / 2 (m + Kd)
    const Real q = 0.5 * gains.Proportional * h / (inertia + gains.Derivative);
    const Real factor = 1.0 - ComputeSpeedGains(gains, inertia, h).Error * h / inertia;
    CHECK_THAT(factor, WithinAbs((1.0 - q) / (1.0 + q), 1e-12));
    CHECK(ComputeSpeedGains(gains, inertia, h).Speed == 0.0);
  }
}

TEST_CASE("flight loops: the derivative of a speed's error counts as inertia", "[pointmass3d]") {
  // F = Kp e - Kd F / m
  const SControlGains gains{0.5, 0.1};
  const Real error = 2.0;
  const Real force = ComputeSpeedGain(gains, 0.01) * error;
  CHECK_THAT(force, WithinRel(0.5 * error - 0.1 * force / 0.01, 1e-14));
}

TEST_CASE("flight loops: the thrust counters the weight within its limit", "[pointmass3d]") {
  CHECK(ComputeThrust(3.0, -10.0, 20.0) == 13.0);
  CHECK(ComputeThrust(15.0, -10.0, 20.0) == 20.0);
  CHECK(ComputeThrust(-35.0, -10.0, 20.0) == -20.0);
}

TEST_CASE("flight loops: substeps are 2/3 of the time constant of the fastest loop",
          "[pointmass3d]") {
  SBodyDescription body;
  body.Shapes.push_back(SShapeDescription::Cylinder(0.25, 0.5));
  body.Mass = 1.0;
  body.PlanarInertia = 0.01;
  // the eye-bot: its loop on velocity, at a rate of 20 / s
  body.Propellers =
      SPropellersDescription{{20.0, 10.0}, {0.5, 0.1}, {20.0, 0.0}, {0.5, 0.1}, 1000.0, 1000.0};
  CHECK_THAT(ComputeMaxFlightSubstep(body), WithinRel(1.0 / 30.0, 1e-14));
  // yaw: s^2 + 100 s + 500
  body.PlanarInertia = 0.001;
  CHECK_THAT(ComputeMaxFlightSubstep(body),
             WithinRel(2.0 / 3.0 / (50.0 + std::sqrt(2000.0)), 1e-14));
  // a body description without inertia has that of its solids: m r^2 / 2; s^2 + 8 s + 5000
  // oscillates
  body.Shapes = {SShapeDescription::Cylinder(0.5, 0.5)};
  body.PlanarInertia.reset();
  body.Propellers->Yaw = {625.0, 1.0};
  CHECK_THAT(ComputeMaxFlightSubstep(body), WithinRel(2.0 / 3.0 / std::sqrt(5000.0), 1e-14));
  // position: s^2 + 200 s + 100; yaw rate: 625 / (0.125 + 0.5)
  body.Propellers->Position = {100.0, 200.0};
  CHECK_THAT(ComputeMaxFlightSubstep(body),
             WithinRel(2.0 / 3.0 / (100.0 + std::sqrt(9900.0)), 1e-14));
  body.Propellers->YawRate = {625.0, 0.5};
  CHECK_THAT(ComputeMaxFlightSubstep(body), WithinRel(2.0 / 3.0 / 1000.0, 1e-14));
}

}  // namespace flight_loop_test
