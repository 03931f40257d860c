#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_SKIN_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_SKIN_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

struct SRigidBody;
struct SRigidSettings;

/**
 * By how much the geoms of a body are larger than its solids, m: see kSkin.
 *
 * Only those of objects made of boxes, cylinders and spheres: robots have other means. Not for
 * ODE's solver, which fails more often for more contacts.
 */
Real ComputeSkin(const SRigidBody& body, const SRigidSettings& settings);

}  // namespace argos

#endif
