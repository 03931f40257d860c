#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_FLIGHT_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_FLIGHT_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

namespace argos {

/**
 * Holds an attached body where it is, as if its mass were infinite; otherwise applies the forces of
 * a body's propellers for the next substep: of its controllers on position or velocity and on the
 * yaw (SPropellersDescription), and of one that keeps it upright.
 * @param gravity  m/s^2: the weight that the propellers counter.
 * @param substep  s.
 * @param origin   of the frame in which the body is, m, world frame: that of targets of positions.
 */
void PushFlyingBody(SRigidBody& body, const CVector3& gravity, Real substep,
                    const CVector3& origin);

}  // namespace argos

#endif
