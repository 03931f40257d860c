#ifndef ARGOS3_CORE_SIMULATOR_GEOMETRY_DISC_LIST_H
#define ARGOS3_CORE_SIMULATOR_GEOMETRY_DISC_LIST_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cmath>
#include <cstddef>

namespace argos {

/** Footprints of solids that are discs, m, world frame, in arrays that loops vectorize over. */
struct SDiscList {
  static constexpr size_t kCapacity = 64;

  Real X[kCapacity], Y[kCapacity], Radius[kCapacity];
  size_t Size = 0;
};

/** Which solids a sensor searches for, see CBodyIndex::ListDiscsNear(). */
struct SDiscQuery {
  Real X, Y, Reach; /**< circle on the ground, m, world frame */
  Real MinZ, MaxZ; /**< heights that a disc must span, m */
  UInt32 IgnoredBody; /**< its number in the index */
};

/**
 * What most sensors need of a small solid: a third of an SIndexedShape, so that more of them are in
 * the cache.
 */
struct SIndexedDisc {
  /** Heights in whole steps of 1/1024 m, so that comparing them errs in one direction only. */
  struct SHeights {
    SInt16 Low, High;

    /** The steps that are within the heights; None() if they are more than 31 m high. */
    static SHeights Inside(Real min, Real max) {
      const Real low = std::ceil(min * kStepsOfMeter);
      const Real high = std::floor(max * kStepsOfMeter);
      return low > -kEnd && high < kEnd && low <= high
                 ? SHeights{static_cast<SInt16>(low), static_cast<SInt16>(high)}
                 : None();
    }
    /** The steps that contain the heights. */
    static SHeights Around(Real min, Real max) {
      const Real low = std::floor(min * kStepsOfMeter);
      const Real high = std::ceil(max * kStepsOfMeter);
      return low > -kEnd && high < kEnd
                 ? SHeights{static_cast<SInt16>(low), static_cast<SInt16>(high)}
                 : SHeights{-kEnd - 1, kEnd};
    }
    /** Heights that span no others. */
    static SHeights None() { return {kEnd, -kEnd}; }
    bool Span(const SHeights& others) const {
      // without a branch
      return static_cast<bool>(static_cast<int>(Low <= others.Low) &
                               static_cast<int>(High >= others.High));
    }

   private:
    static constexpr Real kStepsOfMeter = 1024.0;
    static constexpr SInt16 kEnd = 32767;
  };

  Real X, Y, Radius; /**< m, world frame; valid if it spans heights */
  UInt32 Body; /**< number of the body in the index */
  SHeights Spanned; /**< none if the solid is no upright disc */
};
static_assert(sizeof(SIndexedDisc) == 32, "two of them are a cache line");

}  // namespace argos

#endif
