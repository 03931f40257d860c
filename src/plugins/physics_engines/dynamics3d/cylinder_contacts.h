#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CYLINDER_CONTACTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CYLINDER_CONTACTS_H

#include <ode/ode.h>

namespace argos {

/**
 * dCollide(), but for two cylinders that stand side by side, which is how most robots meet: exact
 * there, at both ends of the line on which they touch. Of a cylinder and a box, at most four
 * contacts that are far apart.
 * @param skip   bytes from one contact to the next.
 * @param reach  m: cylinders side by side also count when they are apart by as much, with a depth
 *               below 0.
 * @return the number of contacts, at most @p most.
 */
int FindContacts(dGeomID first, dGeomID second, int most, dContactGeom* contacts, int skip,
                 dReal reach = 0.0);

}  // namespace argos

#endif
