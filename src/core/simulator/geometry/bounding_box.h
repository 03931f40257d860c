#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_BOUNDING_BOX_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_BOUNDING_BOX_H

#include <argos3/core/utility/math/vector3.h>

namespace argos {

/** Axis-aligned box in the world frame, m. */
struct SBoundingBox {
  CVector3 MinCorner;
  CVector3 MaxCorner;

  /** True if the boxes share a point. */
  bool Intersects(const SBoundingBox& other) const {
    return MinCorner <= other.MaxCorner && other.MinCorner <= MaxCorner;
  }
};

}  // namespace argos

#endif
