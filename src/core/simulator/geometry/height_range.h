#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_HEIGHT_RANGE_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_HEIGHT_RANGE_H

#include <argos3/core/utility/math/ray3.h>
#include <argos3/core/utility/math/ray_span.h>

#include <algorithm>
#include <cmath>

namespace argos {

/** Range of the heights of several solids, m, world frame; empty without solids. */
struct SHeightRange {
  Real Min = HUGE_VAL, Max = -HUGE_VAL;

  static SHeightRange All() { return {-HUGE_VAL, HUGE_VAL}; }
  bool Overlaps(const SHeightRange& other) const { return Min <= other.Max && Max >= other.Min; }
  void Include(Real min, Real max) {
    Min = std::min(Min, min);
    Max = std::max(Max, max);
  }
  /**
   * The part of a line, between fractions of the ray, that is at these heights or farther than the
   * reach (m) from them by less than a rounding; empty without solids.
   */
  SRaySpan FindPart(const CRay3& ray, Real reach) const {
    if (Min > Max) {
      return SRaySpan::None();
    }
    const Real rounded = reach + 1e-9;
    const Real z = ray.GetStart().GetZ();
    SRaySpan part{0.0, 1.0};
    part.ClipToSlab(z, ray.GetEnd().GetZ() - z, Min - rounded, Max + rounded);
    return part;
  }
};

}  // namespace argos

#endif
