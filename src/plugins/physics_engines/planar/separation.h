#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_SEPARATION_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_SEPARATION_H

#include <argos3/core/utility/math/planar_vector.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <cmath>

namespace argos {

/**
 * A separating line of two convex shapes, or their contact if they touch or overlap.
 *
 * While the first shape moves along the normal by less than Gap more than the second, they stay
 * apart: on the whole path, not only at its end, because the line separates them.
 */
struct SSeparation {
  Real NormalX = 0.0, NormalY = 0.0;  // from the first to the second, of unit length
  Real Gap = 0.0;  // m, along the normal; negative if they overlap
  Real PointX = 0.0, PointY = 0.0;  // nearest point of the second, m, world frame

  SPlanarVector GetNormal() const { return {NormalX, NormalY}; }
};

/**
 * A separating line of two discs, chosen for their planned steps.
 *
 * If they do not touch on the way, the line allows the whole steps; if they do, it is the tangent
 * at their first contact, along which they slide on the rest of the way.
 * @param offset    from the first centre to the second, m.
 * @param relative  planned step of the second relative to the first, m.
 * @param reach     sum of the radii, m.
 */
inline SSeparation SeparateDiscs(const SPlanarVector& offset, const SPlanarVector& relative,
                                 Real reach) {
  const Real squaredDistance = SquareLength(offset);
  const Real squaredPath = SquareLength(relative);
  const Real approach = Dot(offset, relative);
  SPlanarVector between = offset;
  if (approach < 0.0 && squaredDistance > reach * reach) {
    Real share = std::fmin(1.0, -approach / squaredPath);
    if (SquareLength(offset + share * relative) < reach * reach) {
      const Real root = approach * approach - squaredPath * (squaredDistance - reach * reach);
      share = std::fmax(0.0, (-approach - std::sqrt(std::fmax(0.0, root))) / squaredPath);
    }
    between = offset + share * relative;
  }
  const Real length = std::sqrt(SquareLength(between));
  SSeparation separation;
  if (length > 0.0) {
    separation.NormalX = between.X / length;
    separation.NormalY = between.Y / length;
  } else {
    separation.NormalX = 1.0;
  }
  separation.Gap = Dot(separation.GetNormal(), offset) - reach;
  return separation;
}

/** The same for a disc with a planned step and a fixed footprint. */
SSeparation SeparateFromFootprint(Real x, Real y, Real radius, const SPlanarVector& step,
                                  const SFootprint& footprint);

/**
 * Finds the points where two footprints touch, or would touch if they were closer: one or two.
 * @param contacts  room for two; the normals are from @p a to @p b, the points are of the one or
 * the other.
 * @return their number.
 */
int FindContacts(const SFootprint& a, const SFootprint& b, SSeparation* contacts);

/** The gap between two footprints along the line that separates them best, m; below 0: overlap. */
Real ComputeGap(const SFootprint& a, const SFootprint& b);

/** Radius of the circle around the centre that encloses a footprint, m. */
inline Real ComputeExtent(const SFootprint& footprint) {
  return footprint.Radius +
         std::sqrt(footprint.HalfX * footprint.HalfX + footprint.HalfY * footprint.HalfY);
}

}  // namespace argos

#endif
