#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_LIMITS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_LIMITS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>

namespace argos {

// The README of this engine says where these come from, with measurements.

/** The farthest that a robot goes in a tick, in half narrowest sides: faster wheels slip. */
constexpr Real kMaxStep = 64.0;
/**
 * Rounds in a tick in which robots that are in each other's way step towards where their wheels
 * want them; there are fewer where nobody can go farther.
 */
constexpr UInt32 kMaxRounds = 8;
/** A step shorter than this, in radii, is none. */
constexpr Real kNegligibleStep = 1e-6;
/** Bodies deeper in each other than this, m, were put there: they are pushed apart. */
constexpr Real kMaxRounding = 1e-9;

/** Robots that a thread works on in a row. */
constexpr size_t kDiscGrain = 512;
/** Cells of the grid, of which about every second has a robot, that a thread works on in a row. */
constexpr size_t kCellGrain = 1024;
/** Ticks after which the grid is laid anew, because the swarm may be elsewhere. */
constexpr UInt32 kTicksOfGrid = 32;

/** Solids may come this deep into each other, in half narrowest sides. */
constexpr Real kSolidTolerance = 1e-5;
/** Solids step at most this share of half their narrowest side, so that none passes another. */
constexpr Real kSolidStep = 0.25;
/** Iterations of the solver of pushes. */
constexpr int kPushIterations = 200;
/**
 * What is pushed resists with this share of its friction, besides friction itself, when it is moved
 * as fast as its pusher wants: it makes the solver converge.
 */
constexpr Real kPushSlack = 1e-3;

}  // namespace argos

#endif
