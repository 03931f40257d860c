#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_DISC_LIST_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_DISC_LIST_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>

namespace argos {

/** Footprints of solids that are discs, m, world frame, in arrays that loops vectorize over. */
struct SDiscList {
  static constexpr size_t kCapacity = 64;

  Real X[kCapacity], Y[kCapacity], Radius[kCapacity];
  UInt32 Body[kCapacity]; /**< numbers in the index */
  size_t Size = 0;
};

/** Which solids a sensor searches for, see CBodyIndex::ListDiscsNear(). */
struct SDiscQuery {
  Real X, Y, Reach; /**< circle on the ground, m, world frame */
  Real MinZ, MaxZ; /**< heights that a disc must span, m */
  UInt32 IgnoredBody; /**< its number in the index */
};

/** How near to a point of a ray a solid has to come, m. */
struct SRayReach {
  Real Across = 0.0; /**< seen from above */
  Real Vertical = 0.0; /**< from the point's height to the solid's span of heights */
};

}  // namespace argos

#endif
