#ifndef ARGOS3_TESTING_SUPPORT_SOLID_REFERENCE_H
#define ARGOS3_TESTING_SUPPORT_SOLID_REFERENCE_H

#include <argos3/core/simulator/geometry/body_description.h>
#include <argos3/core/utility/math/ray3.h>

#include <optional>
#include <vector>

namespace argos {

/** A body in the reference implementation: its solids and its pose. */
struct SReferenceBody {
  const SBodyDescription* Description;
  CVector3 Position; /**< m, world frame */
  CQuaternion Orientation; /**< world frame */
};

/**
 * Fraction of a ray's length in [0,1] at which it enters a body, 0 if it starts inside; empty if it
 * misses. Computed by brute force from the definitions of the solids in three dimensions.
 */
std::optional<Real> ReferenceHit(const SReferenceBody& body, const CRay3& ray);

/** Points on the surface of one solid of a body, world frame, m. */
std::vector<CVector3> SurfacePoints(const SReferenceBody& body, size_t solid);

}  // namespace argos

#endif
