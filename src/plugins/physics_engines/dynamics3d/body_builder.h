#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_BODY_BUILDER_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_BODY_BUILDER_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <string>

namespace argos {

/** Sets what follows from the description of a body alone, without parts. */
void DescribeRigidBody(SRigidBody& body, const SRigidSettings& settings);
/**
 * Creates the parts of a body in ODE from its Source, at rest, at @p pose.
 *
 * All solids have the same density. A drive becomes two sprung wheels on hinges with motors, and
 * four casters without friction, one on each side; solids have a small clearance from the ground.
 * A planar drive becomes four such casters, and motors of bounded force and torque.
 */
void BuildRigidBody(SRigidBody& body, const SRigidPose& pose, const SRigidSettings& settings,
                    dWorldID world);
/**
 * Tunes the springs of a robot's wheels.
 * @param gravity m/s^2. @param substep s.
 */
void TuneWheels(SRigidBody& body, Real gravity, Real substep);
/**
 * Sets the targets of the motors of a planar drive for the next substep (s): the chord of the arc
 * of its command. Without contact with the ground, they exert no force.
 */
void SetPlanarMotor(SRigidBody& body, Real substep);
/** Undoes BuildRigidBody(). */
void DestroyRigidBody(SRigidBody& body);
/** Destroys the parts that a free robot has given back. */
void DestroyRigidParts(SRigidParts& parts);

/** Places all parts at @p pose with that motion, which is ignored for fixed bodies. */
void PlaceRigidBody(SRigidBody& body, const SRigidPose& pose, const SRigidMotion& motion);
/** Of any movable body, free ones included. */
SRigidPose GetRigidPose(const SRigidBody& body);
CVector3 GetRigidVelocity(const SRigidBody& body); /**< of the centre of mass, m/s */
CVector3 GetRigidAngularVelocity(const SRigidBody& body); /**< rad/s */
SRigidMotion GetRigidMotion(const SRigidBody& body);

/**
 * The reason why a body cannot be built from a description; empty if it can.
 * @param movable  true if the body shall be movable.
 */
std::string FindFlaw(const SBodyDescription& description, bool movable);

}  // namespace argos

#endif
