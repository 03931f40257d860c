#include <argos3/testing/support/closed_form/pd_loop.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace argos::testing {

namespace {

using TMatrix = std::array<std::array<Real, 2>, 2>;

constexpr Real kTurn = 2.0 * std::numbers::pi;

TMatrix Multiply(const TMatrix& a, const TMatrix& b) {
  TMatrix product{};
  for (size_t i = 0; i < 2; ++i) {
    for (size_t j = 0; j < 2; ++j) {
      for (size_t k = 0; k < 2; ++k) {
        product[i][j] += a[i][k] * b[k][j];
      }
    }
  }
  return product;
}

}  // namespace

Real SPDLoop::ComputePlaceError(Real target, Real place) const {
  return IsAngle ? std::remainder(target - place, kTurn) : target - place;
}

// Solves thrust = limited(control(middle of the substep)) by bisection: the right side decreases
// with the thrust.
template <typename CONTROL>
void SPDLoop::Step(Real substep, CONTROL&& control) {
  Real low = -MaxThrust + Weight;
  Real high = MaxThrust + Weight;
  for (int i = 0; i < 200; ++i) {
    const Real force = 0.5 * (low + high);
    const Real speed = Speed + 0.5 * substep * force / Inertia;
    const Real wanted = control(Place + 0.5 * substep * speed, speed, force);
    (std::clamp(wanted - Weight, -MaxThrust, MaxThrust) + Weight > force ? low : high) = force;
  }
  const Real force = 0.5 * (low + high);
  Place += Speed * substep + 0.5 * substep * substep * force / Inertia;
  Speed += force * substep / Inertia;
  if (IsAngle) {
    Place -= kTurn * std::floor(Place / kTurn);
  } else if (Place < Lowest || Place > Highest) {
    Place = Place < Lowest ? Lowest : Highest;
    Speed = 0.0;
  }
}

void SPDLoop::StepToPlace(Real target, Real substep) {
  // of the angle, the shorter way at the start of the substep
  const Real error = ComputePlaceError(target, Place);
  const Real start = Place;
  Step(substep, [&](Real place, Real speed, Real) {
    return Proportional * (error - (place - start)) - Derivative * speed;
  });
}

void SPDLoop::StepToSpeed(Real target, Real substep) {
  // F = Kp e + Kd de/dt with de/dt = -F / m
  Step(substep, [&](Real, Real speed, Real force) {
    return Proportional * (target - speed) - Derivative * force / Inertia;
  });
}

Real ComputeStepResponse(Real a, Real b, UInt32 substeps) {
  // (I - A / 2)^-1 (I + A / 2) with A = ((0, 1), (-a, -b))
  const Real determinant = 1.0 + 0.5 * b + 0.25 * a;
  const TMatrix inverse = {{{(1.0 + 0.5 * b) / determinant, 0.5 / determinant},
                            {-0.5 * a / determinant, 1.0 / determinant}}};
  TMatrix square = Multiply(inverse, {{{1.0, 0.5}, {-0.5 * a, 1.0 - 0.5 * b}}});
  TMatrix power = {{{1, 0}, {0, 1}}};
  for (UInt32 n = substeps; n > 0; n /= 2) {
    if (n % 2 == 1) {
      power = Multiply(power, square);
    }
    square = Multiply(square, square);
  }
  return 1.0 - power[0][0];
}

Real ComputeWayToSpeed(Real p, UInt32 substeps) {
  // the speed after k substeps is 1 - r^k; the mean of both ends of each, summed
  const Real n = substeps;
  return n - (1.0 - std::pow((1.0 - 0.5 * p) / (1.0 + 0.5 * p), n)) / p;
}

Real ComputeContinuousResponse(const SPDLoop& loop, Real time) {
  // from the partial fractions of Kp / (m s^2 + Kd s + Kp) / s
  using TComplex = std::complex<Real>;
  const Real twice = 2.0 * loop.Inertia;
  const TComplex root =
      std::sqrt(TComplex(loop.Derivative * loop.Derivative - 2.0 * twice * loop.Proportional));
  const TComplex poles[2] = {(-loop.Derivative + root) / twice, (-loop.Derivative - root) / twice};
  TComplex response = 1.0;
  for (int i = 0; i < 2; ++i) {
    response += loop.Proportional / (poles[i] * loop.Inertia * (poles[i] - poles[1 - i])) *
                std::exp(poles[i] * time);
  }
  return response.real();
}

Real ComputeContinuousWay(const SPDLoop& loop, Real time) {
  const Real rate = loop.Proportional / (loop.Inertia + loop.Derivative);
  return time - (1.0 - std::exp(-rate * time)) / rate;
}

}  // namespace argos::testing
