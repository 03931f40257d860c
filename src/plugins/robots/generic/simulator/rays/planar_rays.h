#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_PLANAR_RAYS_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_PLANAR_RAYS_H

#include <argos3/core/simulator/geometry/indexed_shape.h>

#include <cstddef>

namespace argos {

/**
 * Rays projected onto the ground, m, world frame, in arrays that the compiler can vectorize over.
 * A cheap test rejects most pairs of rays and solids before the exact test.
 */
template <size_t MAX_RAYS>
struct SPlanarRays {
  Real X[MAX_RAYS], Y[MAX_RAYS]; /**< start points */
  Real DX[MAX_RAYS], DY[MAX_RAYS]; /**< from start to end */
  Real SquareLength[MAX_RAYS]; /**< m^2 */

  void Set(size_t ray, Real x, Real y, Real dx, Real dy) {
    X[ray] = x;
    Y[ray] = y;
    DX[ray] = dx;
    DY[ray] = dy;
    SquareLength[ray] = dx * dx + dy * dy;
  }

  /**
   * Tests rays against the bounding circle of a solid's footprint.
   * @param count  of rays.
   * @param near   (count) < 0 if the circle is beside the ray or behind its start by more than the
   *               rounding error; otherwise >= 0, or not a number.
   */
  void ComputeNearness(const SIndexedShape& shape, size_t count, Real* __restrict near) const {
    constexpr Real kSlack = 1.0 + 1e-9;
    const Real square = shape.Radius * shape.Radius * kSlack;
    for (size_t i = 0; i < count; ++i) {
      const Real x = shape.X - X[i];
      const Real y = shape.Y - Y[i];
      const Real aside = DX[i] * y - DY[i] * x;
      const Real along = DX[i] * x + DY[i] * y;
      // behind the start, the start is the nearest point
      const Real behind = along < 0.0 ? along : 0.0;
      near[i] = square * SquareLength[i] - aside * aside - behind * behind;
    }
  }
};

}  // namespace argos

#endif
