#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CONTACT_SPREAD_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_CONTACT_SPREAD_H

#include <argos3/core/utility/math/vector3.h>

#include <ode/ode.h>

namespace argos {

/** The contact with that number in an array of ODE's. @param skip  bytes from one to the next. */
inline dContactGeom& ContactAt(dContactGeom* contacts, int number, int skip) {
  return *reinterpret_cast<dContactGeom*>(reinterpret_cast<char*>(contacts) +
                                          static_cast<size_t>(number) * skip);
}

/** Fills a contact of two geoms. @param normal  points to the first of them. */
inline void SetContact(dContactGeom& contact, const CVector3& point, const CVector3& normal,
                       Real depth, dGeomID first, dGeomID second) {
  for (UInt32 i = 0; i < 3; ++i) {
    contact.pos[i] = point[i];
    contact.normal[i] = normal[i];
  }
  contact.depth = depth;
  contact.g1 = first;
  contact.g2 = second;
  contact.side1 = contact.side2 = -1;
}

/**
 * Keeps those of @p count contacts with one surface that support a body as all of them do: at most
 * four, far apart.
 * @param kept  receives them. @param most  room there. @param skip  bytes from one to the next.
 * @return their number.
 */
int KeepSpread(const dContactGeom* contacts, int count, int most, dContactGeom* kept, int skip);

}  // namespace argos

#endif
