#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_PRISM_CONTACTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_PRISM_CONTACTS_H

#include <ode/ode.h>

namespace argos {

/**
 * The contacts of a prism or a box with a plane, box, cylinder, sphere or prism; in either order,
 * at most four, which are far apart. The normals point into the first.
 *
 * Exact, except that a cylinder counts as one with 24 sides where it is skew to the prism or on top
 * of it, turned so that one of its edges is the line that is nearest to the prism.
 * @param skip   bytes from one contact to the next.
 * @param reach  m: solids at up to this distance have contacts, too, with a depth below 0.
 * @return their number, at most @p most.
 */
int FindPrismContacts(dGeomID first, dGeomID second, int most, dContactGeom* contacts, int skip,
                      dReal reach);

}  // namespace argos

#endif
