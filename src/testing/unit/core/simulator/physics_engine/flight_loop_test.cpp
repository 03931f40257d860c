// Compares the stability bounds of the flight loops with the eigenvalues of their recurrences.

#include <argos3/core/simulator/physics_engine/flight_loop.h>

#include <argos3/core/utility/math/random_stream.h>

#include <Eigen/Eigenvalues>
#include <catch2/catch.hpp>

#include <cmath>

namespace flight_loop_test {

using namespace argos;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

// factor by which the slowest mode of the position loop shrinks or grows in a substep
Real ComputePositionLoopFactor(const SControlGains& gains, Real inertia, Real substep) {
  const Real a = gains.Proportional * substep * substep / inertia;
  const Real b = gains.Derivative * substep / inertia;
  Eigen::Matrix3d companion;
  companion << 2.0, -(1.0 + a + b), b, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
  return companion.eigenvalues().cwiseAbs().maxCoeff();
}

// a random factor, log-uniform over four decades
Real RandomFactor(CRandomStream& random) {
  return std::pow(10.0, random.Uniform(-2.0, 2.0));
}

}  // namespace

TEST_CASE("flight loops: a position loop is stable until its eigenvalues leave the unit circle",
          "[pointmass3d]") {
  CRandomStream random(3, "test", "flight loops", "");
  for (int i = 0; i < 200; ++i) {
    const SControlGains gains{RandomFactor(random), RandomFactor(random)};
    const Real inertia = RandomFactor(random);
    const Real bound = ComputePositionLoopBound(gains, inertia);
    CAPTURE(gains.Proportional, gains.Derivative, inertia, bound);
    CHECK(ComputePositionLoopFactor(gains, inertia, 0.999 * bound) < 1.0);
    CHECK(ComputePositionLoopFactor(gains, inertia, 1.001 * bound) > 1.0);
  }
}

TEST_CASE("flight loops: a speed loop is stable until its factor reaches -1", "[pointmass3d]") {
  CRandomStream random(4, "test", "flight loops", "");
  for (int i = 0; i < 200; ++i) {
    const SControlGains gains{RandomFactor(random), i % 2 == 0 ? 0.0 : RandomFactor(random)};
    const Real inertia = RandomFactor(random);
    const Real bound = ComputeSpeedLoopBound(gains, inertia);
    const Real factor = 1.0 - ComputeSpeedGain(gains, inertia) * bound / inertia;
    CHECK_THAT(factor, WithinAbs(-1.0, 1e-14));
  }
}

TEST_CASE("flight loops: the derivative of a speed's error counts as inertia", "[pointmass3d]") {
  // F = Kp e - Kd F / m
  const SControlGains gains{0.5, 0.1};
  const Real error = 2.0;
  const Real force = ComputeSpeedGain(gains, 0.01) * error;
  CHECK_THAT(force, WithinRel(0.5 * error - 0.1 * force / 0.01, 1e-14));
}

TEST_CASE("flight loops: the bounds of the eye-bot", "[pointmass3d]") {
  // m Kd / (m Kp + Kd^2) = 10 / 120; 0.001 / (0.005 + 0.01); 2 m / Kp; 2 (m + Kd) / Kp
  CHECK_THAT(ComputePositionLoopBound({20.0, 10.0}, 1.0), WithinRel(1.0 / 12.0, 1e-15));
  CHECK_THAT(ComputePositionLoopBound({0.5, 0.1}, 0.01), WithinRel(1.0 / 15.0, 1e-14));
  CHECK_THAT(ComputeSpeedLoopBound({20.0, 0.0}, 1.0), WithinRel(0.1, 1e-15));
  CHECK_THAT(ComputeSpeedLoopBound({0.5, 0.1}, 0.01), WithinRel(0.44, 1e-15));

  SBodyDescription body;
  body.Shapes.push_back(SShapeDescription::Cylinder(0.25, 0.5));
  body.Mass = 1.0;
  body.PlanarInertia = 0.01;
  body.Propellers =
      SPropellersDescription{{20.0, 10.0}, {0.5, 0.1}, {20.0, 0.0}, {0.5, 0.1}, 1000.0, 1000.0};
  CHECK_THAT(ComputeFlightBound(body), WithinRel(1.0 / 15.0, 1e-14));
  // a body description without inertia has that of its solids: m r^2 / 2 = 0.005
  body.Shapes = {SShapeDescription::Cylinder(0.1, 0.5)};
  body.PlanarInertia.reset();
  CHECK_THAT(ComputeFlightBound(body), WithinRel(0.1 * 0.005 / (0.5 * 0.005 + 0.01), 1e-14));
}

}  // namespace flight_loop_test
