#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_MASS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_RIGID_MASS_H

#include <argos3/core/utility/math/quaternion.h>
#include <argos3/core/utility/math/vector3.h>

#include <ode/ode.h>

namespace argos {

struct SBodyDescription;

/** The same rotation in ODE's form. @param quaternion of any length > 0. */
void ToODE(const CQuaternion& quaternion, dQuaternion result);

/**
 * Mass (kg) and inertia (kg m^2) of the solids of a link about the origin of its body.
 * @param mass  of the whole body, kg.
 */
dMass AddUpSolids(const SBodyDescription& description, Real mass, UInt32 link);

/** Moves the frame of a mass to its centre. @return the centre in the frame before, m. */
CVector3 CentreMass(dMass& mass);

}  // namespace argos

#endif
