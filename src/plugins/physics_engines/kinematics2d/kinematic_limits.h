#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_LIMITS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_KINEMATIC_LIMITS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>

namespace argos {

// The README of this engine gives the reasons and measurements.

/** Longest path of a robot in a tick, in half narrowest sides: faster wheels slip. */
constexpr Real kMaxStep = 64.0;
/**
 * Greatest number of rounds in a tick in which active discs step towards their targets; there are
 * fewer if no disc can move farther.
 */
constexpr UInt32 kMaxRounds = 8;
/** A step shorter than this, in radii, counts as 0. */
constexpr Real kNegligibleStep = 1e-6;
/** Bodies with a deeper overlap than this, m, were placed so: they are pushed apart. */
constexpr Real kMaxRounding = 1e-9;

/** Robots in a chunk of work of a thread. */
constexpr size_t kDiscGrain = 512;
/** Cells of the grid, of which about half contain a robot, in a chunk of work of a thread. */
constexpr size_t kCellGrain = 1024;
/** Ticks after which the grid is checked, and rebuilt if it does not fit the swarm any more. */
constexpr UInt32 kTicksOfGrid = 32;

/** Greatest overlap of solids, in half narrowest sides. */
constexpr Real kSolidTolerance = 1e-4;
/** Solids step by at most this share of half their narrowest side, so that none passes another. */
constexpr Real kSolidStep = 0.25;
/** Greatest number of sweeps of CPushSolver over an island. */
constexpr UInt32 kPushSweeps = 3000;
/** Greatest number of corrections of an island's contacts by its motion. */
constexpr UInt32 kPushCorrections = 40;
/** Change in a sweep at which forces count as found, as a share of the greatest motion. */
constexpr Real kPushTolerance = 1e-6;
/** Change of a motion at which it counts as steady, as a share of the greatest motion. */
constexpr Real kPushSteady = 1e-4;
constexpr Real kCorrectedSteady = 2e-3;
/** Share of its mass that a body keeps when its contacts are corrected: the motion is known then.
 */
constexpr Real kMassOfCorrected = 0.3;
/**
 * From so many repetitions on, a body keeps this share of its mass in each: a row whose friction is
 * just overcome, of bodies with many contacts, would take hundreds.
 */
constexpr UInt32 kManyRepetitions = 8;
constexpr Real kLighter = 0.5;
/**
 * Share of the strongest drive that would accelerate a body to the greatest motion. A smaller share
 * needs more sweeps until the forces are found, a larger one until the motion is steady.
 */
constexpr Real kPushSlack = 5e-2;

}  // namespace argos

#endif
