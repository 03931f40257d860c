#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_LIMITS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_LIMITS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

// The README of this engine says where these come from, with measurements.

/** Radius of the smallest movable body, Box2D units: what the length scale is chosen for. */
constexpr Real kSmallestRadiusInUnits = 1.0;
/** Box2D units to a metre in a world where nothing moves. */
constexpr Real kDefaultUnitsPerMetre = 10.0;

/** Substeps of a tick unless the user says otherwise. */
constexpr UInt32 kDefaultSubsteps = 2;
/**
 * Where a crowd is so dense that overlaps are left, a tick is cut finer: by one substep more after
 * each tick that left more than the first depth (Box2D units), up to the most, and by one less
 * after that many ticks that left less than the second.
 */
constexpr float kTooDeep = 0.01F;
constexpr float kShallow = 0.002F;
constexpr UInt32 kMaxExtraSubsteps = 8;
constexpr UInt32 kCalmTicks = 20;
/**
 * In a crowd the forces of drives add up along chains of robots, and the solver passes them on by
 * about one contact per iteration. If the greatest force in a contact was that of n drives in the
 * last tick, a tick gets this times n substeps per sqrt(radius * mass / force of one drive).
 */
constexpr float kSubstepsPerDrive = 0.5F;
/** Iterations of Box2D's velocity solver in a substep; of one in a tick cut finer for a crowd. */
constexpr int kVelocityIterations = 8;
constexpr int kCrowdVelocityIterations = 4;
/** More substeps than this are for a crowd. */
constexpr UInt32 kFewSubsteps = 4;
/** Iterations of Box2D's position solver in a substep; COverlapSolver does this work. */
constexpr int kPositionIterations = 1;

/**
 * Robots get into play when they may come this close to something, and stay there until they are
 * farther from everything by the second length; both in radii of the smallest movable body. The
 * first covers what roundings and the pushing apart of others add to a path.
 */
constexpr Real kEncounterSlack = 0.02;
constexpr Real kAround = 0.3;

/**
 * While something is held, substeps are not longer than this, s, unless the user says otherwise,
 * and the velocity solver has so many iterations per second of a substep, from the usual number up
 * to the most. A heavy load on a light robot is what a sequential solver is slowest with; what it
 * has not solved lives on as an oscillation of the spring.
 */
constexpr Real kMaxGripSubstep = 0.01;
constexpr float kGripIterationsPerSecond = 800.0F;
constexpr int kMaxGripIterations = 40;

/** The angles that Box2D adds up lose digits when they grow: beyond this they are wrapped, rad. */
constexpr Real kMaxAngle = 4.0 * ARGOS_PI;

/** A body moves at most this share of half its narrowest side in a substep: none passes another. */
constexpr Real kMaxStepShare = 0.5;
/** A body turns at most this much in a substep, rad. */
constexpr Real kMaxStepTurn = 0.5;
/** Most substeps that a tick is cut into for the sake of fast bodies. */
constexpr UInt32 kMaxSubsteps = 64;

}  // namespace argos

#endif
