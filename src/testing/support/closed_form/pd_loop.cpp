#include <argos3/testing/support/closed_form/pd_loop.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace argos::testing {

namespace {

using TMatrix = std::array<std::array<Real, 3>, 3>;

constexpr Real kTurn = 2.0 * std::numbers::pi;

TMatrix Multiply(const TMatrix& a, const TMatrix& b) {
  TMatrix product{};
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) {
      for (size_t k = 0; k < 3; ++k) {
        product[i][j] += a[i][k] * b[k][j];
      }
    }
  }
  return product;
}

}  // namespace

void SPDLoop::Move(Real substep) {
  Place += Speed * substep;
  if (IsAngle) {
    Place -= kTurn * std::floor(Place / kTurn);
  } else if (Place < Lowest || Place > Highest) {
    Place = Place < Lowest ? Lowest : Highest;
    Speed = 0.0;
  }
  Speed += Thrust * substep / Inertia;
}

void SPDLoop::Push(Real wanted) {
  Thrust = std::clamp(wanted - Weight, -MaxThrust, MaxThrust) + Weight;
}

void SPDLoop::StepToPlace(Real target, Real substep) {
  Move(substep);
  Real error = target - Place;
  Real change = error - LastError;
  if (IsAngle) {
    error = std::remainder(error, kTurn);
    change = std::remainder(error - LastError, kTurn);
  }
  Push(Proportional * error + Derivative * change / substep);
  LastError = error;
}

void SPDLoop::StepToSpeed(Real target, Real substep) {
  Move(substep);
  // F = Kp e + Kd de/dt with de/dt = -F / m
  Push(Proportional * (target - Speed) / (1.0 + Derivative / Inertia));
  LastError = 0.0;
}

Real ComputeStepResponse(Real a, Real b, UInt32 substeps) {
  TMatrix power = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  TMatrix square = {{{2.0, -(1.0 + a + b), b}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}};
  for (UInt32 n = substeps; n > 0; n /= 2) {
    if (n % 2 == 1) {
      power = Multiply(power, square);
    }
    square = Multiply(square, square);
  }
  // After the first substep, which only sets the thrust, (d[2], d[1], d[0]) is (-1, -1, 0), where
  // d[0] is the error before the change of the target; the last component is then d[substeps].
  return 1.0 - power[2][0] - power[2][1];
}

Real ComputeWayToSpeed(Real p, UInt32 substeps) {
  // the speed after n substeps is 1 - (1 - p)^(n - 1); a geometric series
  const Real n = substeps;
  return (n - 1.0) - (1.0 - std::pow(1.0 - p, n - 1.0)) / p;
}

}  // namespace argos::testing
