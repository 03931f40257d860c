#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_SETTINGS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_SETTINGS_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

// m/s^2, downward: in an engine without add-ons, and of <gravity /> without attributes
constexpr Real kStandardGravity = 9.81;

/** Parameters of a rigid world, and all of its tuned numbers. */
struct SRigidSettings {
  enum class EStepper {
    Mixed, /**< CRigidStepper, until islands of up to MaxDirectRows rows converge */
    Direct, /**< dWorldStep: exact, time and memory grow with the square or cube of an island */
    Iterative /**< CRigidStepper with SolverIterations sweeps at most */
  };

  Real Tick = 0.1;  // s, > 0
  UInt32 Substeps = 10;  // of a tick, >= 1; more while a body is too fast for its size
  EStepper Stepper = EStepper::Mixed;
  UInt32 SolverIterations = 32;  // sweeps over the contacts of a large island at least, >= 1
  // of an island that is swept until it converges, or of joints that ODE solves directly; a robot
  // on the floor has 22, a box 12
  UInt32 MaxDirectRows = 100;

  // constraints: the share of an error that is corrected in a substep, and of ODE's the softness
  // that keeps redundant contacts solvable, m/s per N
  Real ErrorReduction = 0.2;
  Real ConstraintForceMixing = 1e-5;

  Real Friction = 1.0;  // Coulomb coefficient of a body; of a contact: the product of both bodies'
  Real Restitution = 0.0;  // in [0,1]
  Real BounceSpeed = 0.02;  // m/s; slower impacts do not bounce
  Real SurfaceLayer = 1e-5;  // m; overlap of bodies at rest
  Real MaxCorrectingSpeed = 1.0;  // m/s; greatest speed at which overlaps are corrected
  bool Sleep = true;  // bodies at rest are not simulated until another body approaches
  bool Upright = true;  // bodies that stand and touch others sideways move in the plane
  bool FreeRobots = true;  // robots that can touch nothing follow their arcs without ODE
  // m, world frame; of the frame in which the bodies are
  Real OriginX = 0.0, OriginY = 0.0;
};

// A robot may be free if it deviates from a free one by at most this: height and lean at rest, and
// speeds of the origin, of its wheels against the ground, and about the horizontal axes.
constexpr Real kFreeHeight = 1e-4;  // m
constexpr Real kFreeLean = 1e-3;  // rad
constexpr Real kFreeSpeed = 2e-3;  // m/s
constexpr Real kFreeTurn = 2e-2;  // rad/s
// share of the greatest sideways force of a drive that the arc of a free robot may need
constexpr Real kFreeGrip = 0.5;
// m; distance from other bodies that a free robot keeps in a tick, and how much more an active one
// must keep to become free
constexpr Real kFreeSlack = 1e-3;
constexpr Real kFreeMargin = 0.01;
// spare parts in ODE that are kept besides as many as active robots have
constexpr UInt32 kFewSpareParts = 64;

// share of a robot's mass in each wheel
constexpr Real kWheelMassShare = 0.025;
// radius of a robot's casters and its clearance, in radii of its wheels
constexpr Real kCasterRadius = 0.5;
constexpr Real kClearance = 0.5;
// Wheels are sprung, so that they stay in contact with an uneven floor: on a flat floor they bear
// kWheelLoad of the robot's weight and are pressed in by kWheelTravel of their radius. Casters bear
// the rest, and keep the robot upright.
constexpr Real kWheelLoad = 0.8;
constexpr Real kWheelTravel = 0.5;
// softness of the motors of a planar drive, as ODE's constraints have it, m/s per N and rad/s per
// N m
constexpr Real kMotorSoftness = 1e-10;
// cosine of the greatest angle from straight below of contacts of wheels and casters, 60 degrees;
// the solids handle contacts from the side
constexpr Real kRollerSupport = 0.5;

// m; the geoms of faces of regions and ghosts begin this far before them, so that ODE detects
// approaching bodies
constexpr Real kFaceMargin = 0.01;

// m, and share of the narrowest side: the geoms of movable objects are larger by the lesser of
// both, so that bodies which rest on each other keep their contacts when they rock
constexpr Real kSkin = 1e-4;
constexpr Real kSkinShare = 0.01;

// a contact is anticipated if it will occur within that many substeps at the present speed
constexpr Real kForesight = 1.5;

// a body moves in a substep by at most this share of its narrowest side, and of the narrowest side
// of fixed bodies
constexpr Real kMaxStride = 0.5;
// rows of an island that the direct solver can always solve: a robot on the floor has 22
constexpr UInt32 kSimpleRows = 24;
// for fast bodies, a tick has at most kMaxRefinement times the requested substeps, or kMaxRefined
constexpr UInt32 kMaxRefinement = 16;
constexpr UInt32 kMaxRefined = 1000;

// sweeps over an island at most, and sweeps times contacts over one of more than MaxDirectRows
// rows; the change of speeds with which sweeps end, m/s
constexpr UInt32 kMaxSweeps = 400;
constexpr size_t kMaxBlockSweeps = 30000;
constexpr Real kSweepTolerance = 1e-6;
// objects in an island of more than MaxDirectRows rows of which more than half are faster than
// this, m/s, tumble; they, and those with more contacts in single points than others, get at most
// so many sweeps, to a tolerance relative to the fastest
constexpr Real kTumblingSpeed = 0.05;
constexpr UInt32 kTumblingSweeps = 12;
constexpr Real kRelativeTolerance = 1e-3;
// radius of the patch of a contact of two objects in one point, as a share of the narrowest side
constexpr Real kPatchShare = 0.01;
// share of that radius by which the pressure moves ahead where they roll: a ball of radius R is
// resisted by 0.004 of its weight, as wood on a hard floor (assumed)
constexpr Real kRollShare = 0.2;

// a supported island rests if no body is faster than by this share of gravity in a substep; a body
// that is pulled by less than this share of its weight does not begin to move
constexpr Real kRestShare = 5e-4;

// of upright bodies: sweeps over an island at most, and sweeps times contacts over one for which
// that is more than kFewUprightSweeps; the change of speeds with which sweeps end, m/s: over an
// island of up to kSmallUprightIsland contacts, and over a crowd, where errors do not add up
constexpr UInt32 kMaxUprightSweeps = 150;
constexpr UInt32 kFewUprightSweeps = 32;
constexpr size_t kMaxUprightContactSweeps = 1200;
constexpr size_t kSmallUprightIsland = 16;
constexpr Real kUprightTolerance = 2e-4;
constexpr Real kUprightCrowdTolerance = 1e-3;
// from this ratio of masses on, islands are swept more often, and to a tolerance that is smaller by
// the ratio: a light body between heavy ones passes little on in each sweep
constexpr Real kUnequalMasses = 10.0;
constexpr UInt32 kMaxUnequalSweeps = 2400;
constexpr UInt32 kFewUnequalSweeps = 128;
constexpr size_t kMaxUnequalContactSweeps = 120000;
// the rim of a body that is no disc may move farther in a tick than the fastest body, by this
// factor
constexpr Real kTurningReach = 2.0;
// s: a body whose edge would have lifted is not upright for so long
constexpr Real kTippingTime = 0.3;

// an island is at rest if all its bodies were slower than this for this time
constexpr Real kQuietTime = 0.5;  // s
constexpr Real kQuietSpeed = 1e-3;  // m/s
constexpr Real kQuietTurn = 1e-2;  // rad/s

}  // namespace argos

#endif
