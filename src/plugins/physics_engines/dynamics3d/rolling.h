#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ROLLING_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ROLLING_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

namespace argos {

// The motion of free robots: upright on a horizontal floor, without contacts besides it.

/** The floor, and how robots are pressed on it. */
struct SRollGround {
  Real Height = 0.0;  // m
  Real Friction = 0.0;
  Real Gravity = 0.0;  // m/s^2, downward
};

SRigidPose GetRollPose(const SRollState& state);
/** The motion of a free robot as its parts in ODE would have it. */
SRigidMotion GetRollMotion(const SRigidBody& robot);

/** The state that an active robot has as a free one: its lean and vertical motion are left out. */
SRollState ReadRollState(const SRigidBody& robot);
/** @return true if an active robot moves as a free one within kFreeHeight, kFreeLean and so on. */
bool RollsFreely(const SRigidBody& robot, const SRollState& state, const SRollGround& ground);
/**
 * @return true if the drive of a robot can hold it on the arc of a command: with kFreeGrip of the
 * friction of its wheels, or of the greatest force of a planar drive.
 */
bool HoldsArc(const SRigidBody& robot, const SDriveCommand& command, const SRollGround& ground);

/**
 * Moves a free robot. Its speeds change in steps at the start of substeps, as in ODE, by what the
 * limits of its motors and the friction of its wheels allow. From the substep on in which it has
 * reached the speeds of the command, it follows the arc in closed form.
 * @param state     at the start. @param command  of its drive.
 * @param substep   s. @param substeps  their number.
 */
SRollState Roll(const SRigidBody& robot, SRollState state, const SDriveCommand& command,
                const SRollGround& ground, Real substep, UInt32 substeps);

}  // namespace argos

#endif
