#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_GROWN_BODY_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_GROWN_BODY_H

#include <argos3/core/simulator/geometry/body_description.h>

namespace argos {

/**
 * m; bodies that are closer touch each other, also if they do not overlap: engines leave gaps
 * between bodies that press against each other, dynamics2d up to half of this.
 */
constexpr Real kTouchDistance = 0.001;

/**
 * The solids of a body with all faces moved outwards, to find bodies that are near it with
 * CBodyIndex::FindOverlap().
 *
 * Boxes, cylinders and spheres grow by the margin. Prisms and hulls grow by a cube with edges of
 * twice the margin along the axes of the solid: by the margin to 1.74 of it, by direction.
 * @param margin  m, >= 0.
 */
SBodyDescription GrowBody(const SBodyDescription& body, Real margin);

}  // namespace argos

#endif
