#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_LIMITS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_PLANAR_LIMITS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/angles.h>

namespace argos {

// The README of this engine gives the reasons and measurements.

/**
 * Coefficients of contact friction; the coefficient of a contact is the product of both. Source:
 * the values of ARGoS 3's dynamics2d.
 */
constexpr Real kMovableFriction = 0.7;
constexpr Real kImmovableFriction = 0.1;

/** Substeps of a tick unless the user sets their number. */
constexpr UInt32 kDefaultSubsteps = 2;
/**
 * Two bodies may meet in a tick if their distance may fall below this in it, in radii of the
 * smallest movable body. It covers rounding errors, and the corrections of other robots' overlaps.
 */
constexpr Real kProximitySlack = 0.02;

/**
 * While a body is held by a spring whose rate, rad/s, times a substep is less than kSoftGrip, a
 * substep of its cluster takes at most kMaxGripSubstep, s, unless the user sets their number: its
 * swing is then resolved. A stiffer spring has no swing, because it settles within the substep.
 */
constexpr Real kSoftGrip = 2.0;
constexpr Real kMaxGripSubstep = 0.01;
/** Tolerance of an island with grips, as a share of that without. */
constexpr float kGripTolerance = 0.01F;
/** Share of an error across the arm of a grip that is corrected in a substep. */
constexpr Real kGripCorrection = 0.2;
/**
 * A body in a grip may be so many times as fast at the end of a tick as at its start, or as its
 * drive and turret make it.
 */
constexpr Real kMaxGripGrowth = 1.5;

/**
 * A body moves by at most this share of half its narrowest side in a substep, so that none passes
 * through another.
 */
constexpr Real kMaxStepShare = 0.5;
/** A body turns at most this much in a substep, rad. */
constexpr Real kMaxStepTurn = 0.5;
/** Most substeps that a tick gets for fast bodies. */
constexpr UInt32 kMaxSubsteps = 64;

/*
 * The crowd: CCrowdSolver.
 */
/**
 * Sweeps of a substep, at most.
 */
constexpr UInt32 kMaxCrowdSweeps = 300;
/**
 * Velocities are solved when a sweep changes none by more than this share of a radius in the
 * substep. This and the depths below hold for two substeps in a tick: more are more accurate.
 */
constexpr Real kCrowdTolerance = 0.001;
/**
 * In a cluster with solids: sweeps of an island at most, and its tolerance as a share of
 * kCrowdTolerance.
 */
constexpr UInt32 kMaxTouchSweeps = 150;
constexpr UInt32 kMaxIslandRounds = 20;  // of sweeps over everything
constexpr size_t kIslandGrain = 16;  // islands that a thread solves in a chunk
constexpr float kTouchTolerance = 0.2F;
/** No part of a solid moves farther than so many times the longest path of a body in the tick. */
constexpr Real kSolidReach = 1.5;
/**
 * In a crowd the forces of drives add up. A tick has a substep for each such multiple of the force
 * of a drive in the greatest force of a contact.
 */
constexpr float kDrivesOfSubstep = 8.0F;
/**
 * Share of an overlap that is corrected in a tick, by the speed at which the discs must part, and
 * the greatest correction as a share of the smallest radius. The speed does not depend on the
 * number of substeps: what moves the discs apart in a short substep would hurl them.
 */
constexpr Real kCrowdCorrection = 0.6;
constexpr Real kMaxCrowdCorrection = 0.25;
/**
 * Overlaps up to this share of the smallest radius are not corrected: at rest nothing moves.
 */
constexpr Real kCrowdSlop = 0.002;
/**
 * At the end of a tick, overlaps deeper than this share of the smallest radius are reduced, in at
 * most so many sweeps.
 */
constexpr Real kDeepEnough = 0.005;
constexpr UInt32 kMaxPushes = 12;
/**
 * Gaps up to this share of the smallest radius count as touching.
 */
constexpr Real kTouchingGap = 0.005;
/**
 * Slightly more than the change of velocity takes, for rounding errors
 */
constexpr float kAmpleImpulse = 1.01F;

/** Coefficients of friction between two robots, and between a robot and an immovable body. */
constexpr float kDiscFriction = static_cast<float>(kMovableFriction * kMovableFriction);
constexpr float kWallFriction = static_cast<float>(kMovableFriction * kImmovableFriction);

}  // namespace argos

#endif
