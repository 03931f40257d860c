#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_SETTINGS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_SETTINGS_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** Parameters of a rigid world, and every tuned number of it. */
struct SRigidSettings {
  enum class EStepper {
    Mixed, /**< Direct for islands of up to MaxDirectRows rows, Iterative for larger ones */
    Direct, /**< dWorldStep: exact, time and memory grow with the square or cube of an island */
    Iterative /**< dWorldQuickStep: approximate, in proportion to an island */
  };

  Real Tick = 0.1;  // s, > 0
  UInt32 Substeps = 10;  // of a tick, >= 1; more while something is too fast for its size
  EStepper Stepper = EStepper::Mixed;
  UInt32 SolverIterations = 32;  // sweeps of the iterative stepper over the constraints, >= 1
  // of an island that is solved directly; a robot on the floor has 22, a box 12
  UInt32 MaxDirectRows = 100;

  // ODE's constraints: the share of an error that is corrected in a substep, and the softness that
  // keeps redundant contacts solvable, m/s per N
  Real ErrorReduction = 0.2;
  Real ConstraintForceMixing = 1e-5;

  Real Friction = 1.0;  // Coulomb coefficient of a body; of a contact: the product of both bodies'
  Real Restitution = 0.0;  // in [0,1]
  Real BounceSpeed = 0.02;  // m/s: what meets more slowly does not bounce
  Real SurfaceLayer = 1e-5;  // m: how deep contacts may rest in each other
  Real MaxCorrectingSpeed = 1.0;  // m/s: what is inside each other is pushed apart no faster
  bool Sleep = true;  // bodies at rest are left out until something comes near
};

// a robot's wheel and the part of its mass that it has
constexpr Real kWheelMassShare = 0.025;
// a robot's casters and its clearance, in radii of its wheels
constexpr Real kCasterRadius = 0.5;
constexpr Real kClearance = 0.5;
// Wheels are sprung, so that they keep the floor where it bends: they bear that share of the
// robot's weight when they are pressed in by that many of their radii, as they are on a flat floor.
// Casters bear the rest, and keep the robot upright.
constexpr Real kWheelLoad = 0.8;
constexpr Real kWheelTravel = 0.5;
// contacts of wheels and casters count up to 60 degrees from straight below: those from the side
// belong to the solids
constexpr Real kRollerSupport = 0.5;

// m: so far before faces of regions and of ghosts their geoms begin, so that what comes is seen
constexpr Real kFaceMargin = 0.01;

// a body moves by at most this share of its narrowest side, and of that of what is fixed, in a
// substep
constexpr Real kMaxStride = 0.5;
// rows of an island that the direct solver manages in any case: a robot on the floor has 22
constexpr UInt32 kSimpleRows = 24;
// however fast something is, a tick has no more than that many times the substeps asked for, or
// that many
constexpr UInt32 kMaxRefinement = 16;
constexpr UInt32 kMaxRefined = 160;

// bodies are at rest if, for this long, all that touch each other are slower than that
constexpr Real kQuietTime = 0.5;  // s
constexpr Real kQuietSpeed = 1e-3;  // m/s
constexpr Real kQuietTurn = 1e-2;  // rad/s

}  // namespace argos

#endif
