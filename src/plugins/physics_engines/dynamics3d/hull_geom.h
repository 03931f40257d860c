#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_HULL_GEOM_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_HULL_GEOM_H

#include <ode/ode.h>

#include <vector>

namespace argos {

class CConvexSolid;

/** Arrays that a convex geom of ODE refers to, and which outlive it. */
struct SHullArrays {
  std::vector<dReal> Planes;  // normal and distance from the centroid
  std::vector<dReal> Points;  // m, from the centroid
  std::vector<unsigned int> Polygons;  // number of corners, then their indices, for each face
};

/** Creates a convex geom in no space, centred at the centroid of the solid. */
dGeomID MakeHullGeom(const CConvexSolid& solid, SHullArrays& arrays);

/**
 * dCollide() for a convex geom and a prism, or a cylinder, which counts as a prism of 24 sides
 * around it.
 */
int FindHullContacts(dGeomID hull, dGeomID upright, int most, dContactGeom* contacts, int skip);

}  // namespace argos

#endif
