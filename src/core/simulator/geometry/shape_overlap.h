#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_SHAPE_OVERLAP_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_SHAPE_OVERLAP_H

#include <argos3/core/simulator/geometry/indexed_shape.h>

namespace argos {

/**
 * True if two solids overlap by more than 1e-9 m in every direction.
 *
 * Exact for upright boxes and cylinders; other solids count as the cylinders that bound them, see
 * SolidsOverlap().
 */
bool ShapesOverlap(const SIndexedShape& a, const SIndexedShape& b);

}  // namespace argos

#endif
