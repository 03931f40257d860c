#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ARTICULATED_BODY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_ARTICULATED_BODY_H

#include <argos3/core/simulator/geometry/body_pose.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

#include <string>

namespace argos {

// Links and joints of a rigid body in ODE; bodies without an articulation have none.

/** Creates a joint for each link, whose parts are at their poses at the start, with the body at
 * @p pose. */
void MountLinks(SRigidBody& body, const SRigidPose& pose, dWorldID world);
/** Lists the pairs of solids of different links that collide with each other. */
void ListSelfPairs(SRigidBody& body);

/** Wakes the body if a command has changed. @param substep  nominal length, s, for impulses. */
void StartJointTick(SRigidBody& body, Real substep);
/** Sets the speeds of the motors for a substep, s. */
void DriveJoints(const SRigidBody& body, Real substep);
/** After a substep: writes the coordinates of the joints to their component. */
void ReadJoints(SRigidBody& body);

/** Pose of the body frame as it moves with a link, world frame. @param link  > 0. */
SBodyPose GetLinkFrame(const SRigidBody& body, UInt32 link);

/** The reason why joints cannot be built; empty if they can. */
std::string FindFlawOfJoints(const SBodyDescription& description);

}  // namespace argos

#endif
