#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SEPARATION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_SEPARATION_H

#include <argos3/plugins/simulator/physics_engines/kinematics2d/half_planes.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <cmath>

namespace argos {

/**
 * A line between two convex things that do not overlap, or where they touch or overlap.
 *
 * While the first goes less than Gap along the normal, farther than the second does, they stay
 * apart: on the whole way, not only at its end, because a line keeps them apart.
 */
struct SSeparation {
  Real NormalX = 0.0, NormalY = 0.0;  // from the first to the second, of unit length
  Real Gap = 0.0;  // m, along the normal; negative if they overlap
  Real PointX = 0.0, PointY = 0.0;  // of the second, where it is nearest; m, world frame
};

/**
 * A line between two discs that suits steps they want to take.
 *
 * If they would not meet on the way, the line allows all of it; if they would, it is where they
 * first touch, so that the rest of the way they slide.
 * @param offset    from the first centre to the second, m.
 * @param relative  how the second wants to go, seen from the first, m.
 * @param reach     sum of the radii, m.
 */
inline SSeparation SeparateDiscs(const SStep& offset, const SStep& relative, Real reach) {
  const Real squaredDistance = offset.X * offset.X + offset.Y * offset.Y;
  const Real squaredPath = relative.X * relative.X + relative.Y * relative.Y;
  const Real approach = offset.X * relative.X + offset.Y * relative.Y;
  Real x = offset.X;
  Real y = offset.Y;
  if (approach < 0.0 && squaredDistance > reach * reach) {
    Real share = std::fmin(1.0, -approach / squaredPath);
    const Real nearestX = x + share * relative.X;
    const Real nearestY = y + share * relative.Y;
    if (nearestX * nearestX + nearestY * nearestY < reach * reach) {
      const Real root = approach * approach - squaredPath * (squaredDistance - reach * reach);
      share = std::fmax(0.0, (-approach - std::sqrt(std::fmax(0.0, root))) / squaredPath);
    }
    x += share * relative.X;
    y += share * relative.Y;
  }
  const Real length = std::sqrt(x * x + y * y);
  SSeparation separation;
  if (length > 0.0) {
    separation.NormalX = x / length;
    separation.NormalY = y / length;
  } else {
    separation.NormalX = 1.0;
  }
  separation.Gap = separation.NormalX * offset.X + separation.NormalY * offset.Y - reach;
  return separation;
}

/** The same of a disc that wants to take a step and a footprint that stays. */
SSeparation SeparateFromFootprint(Real x, Real y, Real radius, const SStep& step,
                                  const SFootprint& footprint);

/**
 * Where two footprints touch, or would if they came closer: one or two points.
 * @param contacts  room for two; the normals are from @p a to @p b, the points are of the one or
 * the other.
 * @return how many there are.
 */
int FindContacts(const SFootprint& a, const SFootprint& b, SSeparation* contacts);

/** The gap between two footprints along the line that separates them best, m; below 0: overlap. */
Real ComputeGap(const SFootprint& a, const SFootprint& b);

/** Radius of the circle around the centre that holds a footprint, m. */
inline Real ComputeExtent(const SFootprint& footprint) {
  return footprint.Radius +
         std::sqrt(footprint.HalfX * footprint.HalfX + footprint.HalfY * footprint.HalfY);
}

}  // namespace argos

#endif
