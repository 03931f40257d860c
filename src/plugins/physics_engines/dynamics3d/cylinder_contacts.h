#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CYLINDER_CONTACTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CYLINDER_CONTACTS_H

#include <ode/ode.h>

namespace argos {

// cosine of the greatest angle between the axes of solids that stand side by side: 2 degrees
constexpr dReal kParallel = 0.9994;

/**
 * dCollide(), except for two upright cylinders side by side, the most frequent contact of robots:
 * contacts at both ends of the line on which they touch, also where they lean by up to 15 degrees
 * against each other. For a cylinder and a box, at most
 * four contacts, which are far apart. For a cylinder on a plane, up to four points of its rims. For
 * prisms, FindPrismContacts().
 * @param skip   bytes from one contact to the next.
 * @param reach  m: cylinders side by side, and prisms, at up to this distance have a contact, too,
 *               with a depth below 0. If it is more than kSkin, also boxes, and cylinders that
 *               stand beside boxes.
 * @return the number of contacts, at most @p most.
 */
int FindContacts(dGeomID first, dGeomID second, int most, dContactGeom* contacts, int skip,
                 dReal reach = 0.0);

}  // namespace argos

#endif
