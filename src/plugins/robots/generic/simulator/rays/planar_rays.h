#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_PLANAR_RAYS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_PLANAR_RAYS_H

#include <argos3/core/simulator/geometry/indexed_shape.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace argos {

/**
 * Rays projected onto the ground, m, world frame, in arrays that the compiler can vectorize over.
 *
 * A cheap test in single precision rejects most pairs of rays and solids before the exact test.
 */
template <size_t MAX_RAYS>
struct SPlanarRays {
  Real X[MAX_RAYS], Y[MAX_RAYS]; /**< start points */
  Real DX[MAX_RAYS], DY[MAX_RAYS]; /**< vector from start to end */
  Real SquareLength[MAX_RAYS]; /**< m^2 */

  /** @param x, y  a place near the starts: the cheap test is sharpest for solids near it. */
  void SetCenter(Real x, Real y) {
    m_centerX = x;
    m_centerY = y;
    m_farthestStart = 0.0;
  }
  /** After SetCenter(). */
  void Set(size_t ray, Real x, Real y, Real dx, Real dy) {
    X[ray] = x;
    Y[ray] = y;
    DX[ray] = dx;
    DY[ray] = dy;
    const Real startX = x - m_centerX;
    const Real startY = y - m_centerY;
    m_farthestStart = std::max(m_farthestStart, std::abs(startX) + std::abs(startY));
    m_x[ray] = static_cast<float>(startX);
    m_y[ray] = static_cast<float>(startY);
    m_dx[ray] = static_cast<float>(dx);
    m_dy[ray] = static_cast<float>(dy);
    SquareLength[ray] = dx * dx + dy * dy;
    m_squareLength[ray] = static_cast<float>(SquareLength[ray]);
  }

  /**
   * Tests rays against the bounding circle of a solid's footprint.
   * @param count  of rays.
   * @param near   (count) < 0 if the circle is beside the ray or behind its start by more than the
   *               rounding error; otherwise >= 0, or not a number.
   */
  void ComputeNearness(const SIndexedShape& shape, size_t count, float* __restrict near) const {
    const Real centerX = shape.X - m_centerX;
    const Real centerY = shape.Y - m_centerY;
    // the distance of a ray from the circle's centre is computed with an error of at most 11 units
    // of 2^-24 of the distances from the centre of the rays; this is half as much again
    const Real error = kError * (std::abs(centerX) + std::abs(centerY) + m_farthestStart);
    const Real inflated = shape.Radius * (1.0 + kError) + error;
    const auto square = static_cast<float>(inflated * inflated);
    const auto shapeX = static_cast<float>(centerX);
    const auto shapeY = static_cast<float>(centerY);
    for (size_t i = 0; i < count; ++i) {
      const float x = shapeX - m_x[i];
      const float y = shapeY - m_y[i];
      const float aside = m_dx[i] * y - m_dy[i] * x;
      const float along = m_dx[i] * x + m_dy[i] * y;
      // the start is the nearest point of what is behind it: twice min(along, 0) without a branch
      const float behind = along - std::abs(along);
      near[i] = square * m_squareLength[i] - aside * aside - 0.25F * (behind * behind);
    }
  }

 private:
  static constexpr Real kError = 1e-6;  // relative

  Real m_centerX, m_centerY;
  Real m_farthestStart;  // m, from the centre
  // the rays relative to the centre
  float m_x[MAX_RAYS], m_y[MAX_RAYS];
  float m_dx[MAX_RAYS], m_dy[MAX_RAYS];
  float m_squareLength[MAX_RAYS];  // m^2
};

}  // namespace argos

#endif
