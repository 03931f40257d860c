#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_DISC_ENTRIES_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_DISC_ENTRIES_H

#include <argos3/core/simulator/geometry/indexed_shape.h>
#include <argos3/plugins/robots/generic/simulator/planar_rays.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace argos {

/**
 * Where several planar rays first enter any of several discs; equal to the bit to
 * IntersectFootprint() with each disc.
 *
 * With a = d.d, b = p.d and c = p.p - r^2 for the start p of a ray d relative to the centre of a
 * disc of radius r, the ray enters the disc at (-b - sqrt(b^2 - a c)) / a. The quotient grows with
 * its numerator, so only the least numerator of each ray is kept, and divided once. One loop over
 * the rays, which the compiler vectorizes, rejects those that miss a disc; only for the others a
 * root is computed.
 */
template <size_t MAX_RAYS>
class CDiscEntries {
 public:
  /** @param rays  must outlive this. */
  explicit CDiscEntries(const SPlanarRays<MAX_RAYS>& rays) : m_rays(rays) {}

  /** Before all other functions, when the rays are set. @param count  of rays. */
  void Start(size_t count) {
    m_count = count;
    for (size_t i = 0; i < count; ++i) {
      // beyond the end of the ray by more than the rounding error
      m_least[i] = m_rays.SquareLength[i] * kMore;
    }
  }
  /** Only for rays of lengths > 0, at a height that the disc has. */
  void Enter(const SIndexedShape& disc) {
    Real b[MAX_RAYS];
    Real discriminant[MAX_RAYS];
    Real key[MAX_RAYS];
    const Real squareRadius = disc.HalfX * disc.HalfX;
    for (size_t i = 0; i < m_count; ++i) {
      const Real x = m_rays.X[i] - disc.X;
      const Real y = m_rays.Y[i] - disc.Y;
      b[i] = x * m_rays.DX[i] + y * m_rays.DY[i];
      const Real c = x * x + y * y - squareRadius;
      discriminant[i] = b[i] * b[i] - m_rays.SquareLength[i] * c;
      // a root shorter than this ends before the start, or begins after the least numerator
      const Real beyond = -b[i] - m_least[i];
      const Real outside = beyond > b[i] ? beyond : b[i];
      const Real least = outside > 0.0 ? outside : 0.0;
      key[i] = discriminant[i] - kLess * (least * least);
    }
    Real greatest = -1.0;
    for (size_t i = 0; i < m_count; ++i) {
      greatest = key[i] > greatest ? key[i] : greatest;
    }
    if (greatest < 0.0) {
      return;
    }
    for (size_t i = 0; i < m_count; ++i) {
      if (key[i] >= 0.0) {
        Keep(i, b[i], std::sqrt(discriminant[i]));
      }
    }
  }

  /** Lowers @p fractions (count) to the entries that are at most 1. */
  void Take(Real* fractions) const {
    for (size_t i = 0; i < m_count; ++i) {
      if (m_least[i] <= m_rays.SquareLength[i]) {
        fractions[i] = std::min(fractions[i], m_least[i] / m_rays.SquareLength[i]);
      }
    }
  }

 private:
  static constexpr Real kMore = 1.0 + 1e-9;
  static constexpr Real kLess = 1.0 - 1e-6;

  void Keep(size_t ray, Real b, Real root) {
    if (root < b) {
      return;  // the disc is behind the start
    }
    const Real numerator = -b - root;
    // 0: the ray starts in the disc
    m_least[ray] = std::min(m_least[ray], numerator > 0.0 ? numerator : 0.0);
  }

  const SPlanarRays<MAX_RAYS>& m_rays;
  size_t m_count = 0;
  Real m_least[MAX_RAYS];  // m^2; least numerator of each ray
};

}  // namespace argos

#endif
