#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_MOTION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_MOTION_H

#include <argos3/plugins/simulator/physics_engines/dynamics3d/impulse_blocks.h>
#include <argos3/plugins/simulator/physics_engines/dynamics3d/rigid_body.h>

namespace argos {

/** The mass of a body with its wheels and turret, which may spin about their axes. */
struct SJointMass {
  Real Mass = 0.0;  // kg
  CVector3 Offset;  // of its centre from the centre of mass of the main part, frame of the body, m
  SSymmetric3 Inertia;  // about its centre, without spins of rotors, frame of the body, kg m^2
};

/** Of a movable body that is not free, without links. */
SJointMass AddUpParts(const SRigidBody& body);

/** @param rotation  in ODE's order. */
CVector3 InWorld(const dReal* rotation, const CVector3& vector);
SSymmetric3 InWorld(const dReal* rotation, const SSymmetric3& matrix);

/**
 * The angular velocity of a body without torques after a time: one step of Newton's method for the
 * implicit Euler step of Euler's equations, which is stable.
 * @param turn rad/s, world frame. @param inertia  frame of the body, kg m^2.
 * Source: E. Catto, Numerical methods, Game Developers Conference 2015 (gyroscopic torque).
 */
CVector3 TurnFreely(const CVector3& turn, const dReal* rotation, const SSymmetric3& inertia,
                    Real duration);

/** An orientation after a rotation. @param angle  times the axis, rad. */
CQuaternion Rotate(const CQuaternion& orientation, const CVector3& angle);

/** Sets the orientation of a part in ODE; or place and motion, and clears forces. */
void PutOrientation(dBodyID part, const CQuaternion& orientation);
void PutMotion(dBodyID part, const CVector3& position, const CVector3& velocity,
               const CVector3& turn);

}  // namespace argos

#endif
