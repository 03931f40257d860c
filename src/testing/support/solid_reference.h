#ifndef ARGOS3_TESTING_SUPPORT_SOLID_REFERENCE_H
#define ARGOS3_TESTING_SUPPORT_SOLID_REFERENCE_H

#include <argos3/core/simulator/physics_engine/body_description.h>
#include <argos3/core/utility/math/ray3.h>

#include <optional>
#include <vector>

namespace argos {

/** A body as the reference sees it: nothing but its solids and its pose. */
struct SReferenceBody {
  const SBodyDescription* Description;
  CVector3 Position; /**< m, world frame */
  CQuaternion Orientation; /**< world frame */
};

/**
 * Where a ray enters a body: fraction of its length in [0,1], 0 if it starts inside; none if it
 * misses. Straight from the definitions of the solids, in three dimensions, one after the other.
 */
std::optional<Real> ReferenceHit(const SReferenceBody& body, const CRay3& ray);

/** Points on the surface of one solid of a body, world frame, m. */
std::vector<CVector3> SurfacePoints(const SReferenceBody& body, size_t solid);

}  // namespace argos

#endif
