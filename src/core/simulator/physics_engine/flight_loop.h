#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_FLIGHT_LOOP_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_FLIGHT_LOOP_H

#include <argos3/core/simulator/geometry/body_description.h>

#include <algorithm>

namespace argos {

/*
 * The control loops of a flying body, for all engines, and the conditions of their stability; the
 * README of the engine pointmass3d derives the bounds. Each loop is discrete: the controller runs
 * once in each substep of length h, and its thrust acts in the next one.
 */

/**
 * Upper bound of the substep, as a share of the one at which a control loop becomes unstable; with
 * it, loops settle about as fast as with the shortest substeps.
 */
constexpr Real kStableShare = 0.5;

/**
 * The limited thrust of a controller along one axis.
 * @param proportional, derivative  N/m and N (for a change of the error in one substep), or N m.
 * @param error       target - actual value.
 * @param change      of the error in the last substep.
 * @param weight      N, along the axis: an additional force that the thrust has to counter.
 * @param max         N, > 0: the limit of the thrust.
 * @return N, or N m: the thrust, which counters the weight but does not include it.
 */
inline Real ComputeThrust(Real proportional, Real derivative, Real error, Real change, Real weight,
                          Real max) {
  const Real unlimited = proportional * error + derivative * change - weight;
  return std::min(std::max(unlimited, -max), max);
}

/**
 * The bound of a loop on position (or yaw): it is stable if and only if h < Kd m / (Kp m + Kd^2).
 * @param inertia  m: kg, or kg m^2 of a loop on yaw; > 0.
 * @return s.
 */
Real ComputePositionLoopBound(const SControlGains& gains, Real inertia);

/**
 * The bound of a loop on velocity (or yaw rate): it is stable if and only if h < 2 (m + Kd) / Kp.
 * @return s.
 */
Real ComputeSpeedLoopBound(const SControlGains& gains, Real inertia);

/**
 * The gain of a loop on velocity.
 *
 * The derivative of the error is that of the next substep, in which the force F changes the
 * velocity: F = Kp e - Kd F / m. With the derivative of the previous substep, the loop would
 * diverge at any h as soon as Kd >= m.
 * @return N s/m, or N m s/rad.
 */
Real ComputeSpeedGain(const SControlGains& gains, Real inertia);

/** The smallest of the four bounds of a body with propellers, s. */
Real ComputeFlightBound(const SBodyDescription& body);

}  // namespace argos

#endif
