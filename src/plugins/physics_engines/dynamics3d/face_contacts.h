#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_FACE_CONTACTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_FACE_CONTACTS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <ode/ode.h>

namespace argos {

/**
 * As FindContacts(), but contacts of one normal are in a plane, and boxes that only touch with an
 * edge of parallel faces have none.
 * @param skins  m: of both, by which they are larger on each side. @param contacts  receives up to
 * CContactCache::kMaxContacts. @return their number.
 */
int FindFaceContacts(dGeomID first, dGeomID second, Real reach, Real skins, dContact* contacts);

}  // namespace argos

#endif
