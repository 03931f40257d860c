#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_FLIGHT_LOOP_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_ROBOT_BODIES_FLIGHT_LOOP_H

#include <argos3/core/simulator/geometry/body_description.h>

#include <algorithm>

namespace argos {

/*
 * The control loops of a flying body, for all engines; the README of the engine pointmass3d derives
 * the gains. The loops are those of continuous time, so that the response of a body does not depend
 * on the number of substeps: a substep of length h applies a constant thrust, which is the one that
 * the controller would exert in the middle of the substep.
 */

/** The gains of a loop in a substep: thrust = Error * error - Speed * speed, both at its start. */
struct SSubstepGains {
  Real Error = 0.0; /**< N/m (N s/m on velocity), or the same with N m and rad */
  Real Speed = 0.0; /**< N s/m, or N m s/rad; 0 on velocity */
};

/**
 * The gains of a loop on position (or yaw), F = Kp e - Kd v. The derivative is that of the position
 * only: one of the error would contain an impulse for each step of the target.
 * @param inertia  m: kg, or kg m^2 of a loop on yaw; > 0.
 * @param substep  h: s.
 */
SSubstepGains ComputePositionGains(const SControlGains& gains, Real inertia, Real substep);

/**
 * The gains of a loop on velocity (or yaw rate), F = Kp e + Kd de/dt, with de/dt = -F / m.
 * @param inertia, substep  as above.
 */
SSubstepGains ComputeSpeedGains(const SControlGains& gains, Real inertia, Real substep);

/**
 * The gain of the same in continuous time, with the derivative resolved: F = Kp e / (1 + Kd / m).
 * @return N s/m, or N m s/rad.
 */
Real ComputeSpeedGain(const SControlGains& gains, Real inertia);

/**
 * The limited thrust of a controller along one axis.
 * @param wanted   N, or N m: the force along the axis that the controller intends.
 * @param weight   N, along the axis: an additional force that the thrust has to counter.
 * @param max      N, > 0: the limit of the thrust.
 * @return N, or N m: the thrust, which counters the weight but does not include it.
 */
inline Real ComputeThrust(Real wanted, Real weight, Real max) {
  return std::min(std::max(wanted - weight, -max), max);
}

/**
 * The longest substep for a body with propellers, s: a share of 2/3 of the time constant of its
 * fastest loop. The loops are stable in longer ones, too, but less accurate.
 */
Real ComputeMaxFlightSubstep(const SBodyDescription& body);

}  // namespace argos

#endif
