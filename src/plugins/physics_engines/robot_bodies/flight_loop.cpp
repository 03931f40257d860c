#include <argos3/plugins/simulator/physics_engines/robot_bodies/flight_loop.h>

#include <cmath>

namespace argos {

namespace {

// With it, responses deviate by the shares that the README of pointmass3d gives for `iterations` 1.
constexpr Real kAccurateShare = 2.0 / 3.0;

// The fastest rate, 1/s, at which m x'' + Kd x' + Kp x = 0 settles or oscillates.
Real ComputePositionRate(const SControlGains& gains, Real inertia) {
  const Real damping = gains.Derivative / (2.0 * inertia);
  const Real stiffness = gains.Proportional / inertia;
  const Real beyondCritical = damping * damping - stiffness;
  return beyondCritical > 0.0 ? damping + std::sqrt(beyondCritical) : std::sqrt(stiffness);
}

}  // namespace

// The force is constant in a substep, so in its middle the speed is v + h F / 2m; the position
// there counts as the mean of both ends, x + h (v + h F / 2m) / 2. F = Kp e - Kd v of these, solved
// for F.
SSubstepGains ComputePositionGains(const SControlGains& gains, Real inertia, Real substep) {
  const Real half = 0.5 * substep;
  const Real implicit = 1.0 + half * (gains.Derivative + half * gains.Proportional) / inertia;
  return {gains.Proportional / implicit, (gains.Derivative + half * gains.Proportional) / implicit};
}

SSubstepGains ComputeSpeedGains(const SControlGains& gains, Real inertia, Real substep) {
  return {gains.Proportional * inertia /
              (inertia + gains.Derivative + 0.5 * substep * gains.Proportional),
          0.0};
}

Real ComputeSpeedGain(const SControlGains& gains, Real inertia) {
  return ComputeSpeedGains(gains, inertia, 0.0).Error;
}

Real ComputeMaxFlightSubstep(const SBodyDescription& body) {
  const SPropellersDescription& propellers = *body.Propellers;
  const Real inertia = body.GetPlanarInertia();
  const Real fastest = std::max({ComputePositionRate(propellers.Position, body.Mass),
                                 ComputePositionRate(propellers.Yaw, inertia),
                                 ComputeSpeedGain(propellers.Velocity, body.Mass) / body.Mass,
                                 ComputeSpeedGain(propellers.YawRate, inertia) / inertia});
  return kAccurateShare / fastest;
}

}  // namespace argos
