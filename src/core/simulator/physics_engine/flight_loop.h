#ifndef ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_FLIGHT_LOOP_H
#define ARGOS3_CORE_SIMULATOR_PHYSICS_ENGINE_FLIGHT_LOOP_H

#include <argos3/core/simulator/physics_engine/body_description.h>

#include <algorithm>

namespace argos {

/*
 * The control loops of a flying body, for every engine that has such, and when they are stable; the
 * README of the engine pointmass3d derives the bounds. Each is discrete: the controller runs once
 * in each substep of length h, and what it asks for acts in the next one.
 */

/**
 * The thrust of a controller along one axis, limited.
 * @param proportional, derivative  N/m and N (for a change of the error in one substep), or N m.
 * @param error       target - actual value.
 * @param change      of the error in the last substep.
 * @param weight      N, along the axis: what the thrust has to counter besides.
 * @param max         N, > 0: of what the controller asks for.
 * @return N, or N m: what it asks for, the weight countered but not added.
 */
inline Real ComputeThrust(Real proportional, Real derivative, Real error, Real change, Real weight,
                          Real max) {
  const Real wanted = proportional * error + derivative * change - weight;
  return std::min(std::max(wanted, -max), max);
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
 * What a loop on velocity multiplies the error with.
 *
 * The derivative of the error is that of the substep to come, in which the force F changes the
 * velocity: F = Kp e - Kd F / m. Taken from the substep before, the loop would diverge at any h as
 * soon as Kd >= m.
 * @return N s/m, or N m s/rad.
 */
Real ComputeSpeedGain(const SControlGains& gains, Real inertia);

/** The smallest of the four bounds of a body with propellers, s. */
Real ComputeFlightBound(const SBodyDescription& body);

}  // namespace argos

#endif
