#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_PRISM_GEOM_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS3D_PRISM_GEOM_H

#include <argos3/core/utility/math/vector2.h>

#include <ode/ode.h>

#include <vector>

namespace argos {

/**
 * Creates a geom that is a prism along its z axis, with the origin half-way up.
 *
 * It is a class of this engine, which ODE itself never collides: use FindContacts().
 * @param base  a convex polygon in the plane z = 0, m; must outlive the geom.
 */
dGeomID CreatePrism(const std::vector<CVector2>& base, dReal height);

/** @return true if the geom is a prism. */
bool IsPrism(dGeomID geom);

/** Of a prism. */
const std::vector<CVector2>& GetPrismBase(dGeomID prism);
/** Of a prism, m. */
dReal GetPrismHeight(dGeomID prism);

}  // namespace argos

#endif
