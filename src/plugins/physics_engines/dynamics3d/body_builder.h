#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_BODY_BUILDER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_BODY_BUILDER_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <string>

namespace argos {

/**
 * Makes the parts of a body in ODE from its Source, at rest, at @p pose.
 *
 * Solids have the density of the whole. A drive becomes two sprung wheels on hinges with motors,
 * and four casters without friction, on all sides; solids begin above the ground by a small
 * clearance.
 */
void BuildRigidBody(SRigidBody& body, const SRigidPose& pose, const SRigidSettings& settings,
                    dWorldID world);
/**
 * Tunes the springs of a robot's wheels.
 * @param gravity m/s^2. @param substep s.
 */
void TuneWheels(SRigidBody& body, Real gravity, Real substep);
/** Undoes BuildRigidBody(). */
void DestroyRigidBody(SRigidBody& body);

/** Puts all parts there, with that motion. Of fixed bodies, the motion means nothing. */
void PlaceRigidBody(SRigidBody& body, const SRigidPose& pose, const SRigidMotion& motion);
SRigidPose GetRigidPose(const SRigidBody& body);
SRigidMotion GetRigidMotion(const SRigidBody& body);

/**
 * Why a body cannot be built from a description; empty if it can.
 * @param movable  is it to move?
 */
std::string FindFlaw(const SBodyDescription& description, bool movable);

}  // namespace argos

#endif
