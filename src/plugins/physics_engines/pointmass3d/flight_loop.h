#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_FLIGHT_LOOP_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_POINTMASS3D_FLIGHT_LOOP_H

#include <argos3/core/simulator/physics_engine/body_description.h>

namespace argos {

/*
 * When the control loops of a flying body are stable; see the README beside this file for the
 * derivations. Each is discrete: the controller runs once in each substep of length h, and what it
 * asks for acts in the next one.
 */

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
