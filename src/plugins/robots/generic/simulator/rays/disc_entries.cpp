#include <argos3/plugins/robots/generic/simulator/disc_entries.h>

#include <argos3/core/utility/math/vectorized.h>

#include <cmath>

namespace argos {

namespace {

constexpr size_t kRays = SRayBlock::kSize;
// tolerances of the rejection, far above rounding errors
constexpr Real kMore = 1.0 + 1e-9;
constexpr Real kLess = 1.0 - 1e-6;

inline Real FindGreatest(const Real (&values)[kRays]) {
  static_assert(kRays == 8);
  Real ofPairs[4];
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < 4; ++i) {
    ofPairs[i] = values[i] > values[i + 4] ? values[i] : values[i + 4];
  }
  Real ofHalves[2];
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < 2; ++i) {
    ofHalves[i] = ofPairs[i] > ofPairs[i + 2] ? ofPairs[i] : ofPairs[i + 2];
  }
  return ofHalves[0] > ofHalves[1] ? ofHalves[0] : ofHalves[1];
}

}  // namespace

// no branches in the loops over rays, so that they are vectorized
ARGOS_VECTORIZED
void EnterDiscs(const SRayBlock& rays, const SUprightPose& pose, const SDiscList& discs,
                Real* fractions) {
  Real startX[kRays], startY[kRays], stepX[kRays], stepY[kRays];  // m, world frame
  Real square[kRays];  // m^2, of the lengths
  Real least[kRays];  // m^2; least numerator of each ray
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kRays; ++i) {
    startX[i] = pose.X + pose.Cos * rays.OffsetX[i] - pose.Sin * rays.OffsetY[i];
    startY[i] = pose.Y + pose.Sin * rays.OffsetX[i] + pose.Cos * rays.OffsetY[i];
    stepX[i] = pose.Cos * rays.DirectionX[i] - pose.Sin * rays.DirectionY[i];
    stepY[i] = pose.Sin * rays.DirectionX[i] + pose.Cos * rays.DirectionY[i];
    square[i] = stepX[i] * stepX[i] + stepY[i] * stepY[i];
    // the disc is beyond the end of the ray by more than the rounding error
    least[i] = square[i] * kMore;
  }
  for (size_t disc = 0; disc < discs.Size; ++disc) {
    const Real squareRadius = discs.Radius[disc] * discs.Radius[disc];
    Real b[kRays], discriminant[kRays];
    Real key[kRays];  // < 0 if the ray misses the disc, or enters it after another one
    ARGOS_VECTOR_LOOP
    for (size_t i = 0; i < kRays; ++i) {
      const Real x = startX[i] - discs.X[disc];
      const Real y = startY[i] - discs.Y[disc];
      b[i] = x * stepX[i] + y * stepY[i];
      const Real c = x * x + y * y - squareRadius;
      discriminant[i] = b[i] * b[i] - square[i] * c;
      // a root shorter than this ends before the start, or begins after the least numerator
      const Real beyond = -b[i] - least[i];
      const Real outside = beyond > b[i] ? beyond : b[i];
      const Real farthest = outside > 0.0 ? outside : 0.0;
      key[i] = discriminant[i] - kLess * (farthest * farthest);
    }
    if (FindGreatest(key) < 0.0) {
      continue;
    }
    ARGOS_VECTOR_LOOP
    for (size_t i = 0; i < kRays; ++i) {
      const Real root = std::sqrt(discriminant[i] > 0.0 ? discriminant[i] : 0.0);
      const Real numerator = -b[i] - root;
      // 0: the ray starts in the disc
      const Real entry = numerator > 0.0 ? numerator : 0.0;
      const Real nearer = entry < least[i] ? entry : least[i];
      const bool isAhead = root >= b[i];
      const bool isMet = key[i] >= 0.0;
      least[i] = (isMet & isAhead) ? nearer : least[i];
    }
  }
  ARGOS_VECTOR_LOOP
  for (size_t i = 0; i < kRays; ++i) {
    const Real fraction = least[i] / square[i];
    const Real lower = fraction < fractions[i] ? fraction : fractions[i];
    fractions[i] = least[i] <= square[i] ? lower : fractions[i];
  }
}

}  // namespace argos
