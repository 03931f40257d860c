#include <argos3/plugins/simulator/physics_engines/kinematics2d/arc_block.h>

#include <cmath>

namespace argos {

namespace {

// rad; up to this angle the series below are exact except for rounding: their first omitted terms
// are below 1e-18
constexpr Real kSmall = 0.5;

// sin(x) / x for small x, as a function of x^2
inline Real SineSeries(Real z) {
  return 1.0 +
         z * (-1.0 / 6.0 +
              z * (1.0 / 120.0 + z * (-1.0 / 5040.0 +
                                      z * (1.0 / 362880.0 +
                                           z * (-1.0 / 39916800.0 +
                                                z * (1.0 / 6227020800.0 - z / 1307674368000.0))))));
}

inline Real CosineSeries(Real z) {
  return 1.0 +
         z * (-1.0 / 2.0 +
              z * (1.0 / 24.0 +
                   z * (-1.0 / 720.0 +
                        z * (1.0 / 40320.0 + z * (-1.0 / 3628800.0 +
                                                  z * (1.0 / 479001600.0 - z / 87178291200.0))))));
}

// rotates a heading by an angle, both given by cosine and sine
inline void Turn(Real& halfCos, Real& halfSin, Real cosine, Real sine) {
  const Real c = halfCos * cosine - halfSin * sine;
  const Real s = halfSin * cosine + halfCos * sine;
  // one Newton step of 1/sqrt keeps the length at 1 over any number of rotations
  const Real scale = 1.5 - 0.5 * (c * c + s * s);
  halfCos = c * scale;
  halfSin = s * scale;
}

}  // namespace

void SArcBlock::Drive(size_t count) {
  for (size_t i = count; i < kSize; ++i) {
    Path[i] = Quarter[i] = HalfSin[i] = 0.0;
    HalfCos[i] = 1.0;
  }
  // angles beyond the range of the series are handled separately
  Real ratio[kSize];  // sin(quarter) / quarter
  Real cosine[kSize];
  for (size_t i = 0; i < kSize; ++i) {
    const Real z = Quarter[i] * Quarter[i];
    ratio[i] = SineSeries(z);
    cosine[i] = CosineSeries(z);
  }
  for (size_t i = 0; i < count; ++i) {
    if (std::abs(Quarter[i]) > kSmall) {
      ratio[i] = std::sin(Quarter[i]) / Quarter[i];
      cosine[i] = std::cos(Quarter[i]);
    }
  }
  for (size_t i = 0; i < kSize; ++i) {
    const Real sine = Quarter[i] * ratio[i];
    // the chord of an arc of length L and angle a: L sin(a/2) / (a/2), along the heading half-way
    const Real chord = Path[i] * ratio[i] * cosine[i];
    Turn(HalfCos[i], HalfSin[i], cosine[i], sine);
    StepX[i] = chord * (HalfCos[i] * HalfCos[i] - HalfSin[i] * HalfSin[i]);
    StepY[i] = chord * 2.0 * HalfSin[i] * HalfCos[i];
    Turn(HalfCos[i], HalfSin[i], cosine[i], sine);
  }
}

}  // namespace argos
