#ifndef ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_DISC_ENTRIES_H
#define ARGOS3_PLUGINS_ROBOTS_GENERIC_SIMULATOR_RAYS_DISC_ENTRIES_H

#include <argos3/core/simulator/geometry/disc_list.h>
#include <argos3/plugins/simulator/entities/ray_layout.h>

#include <cstddef>

namespace argos {

/** The pose of the anchor of horizontal rays that stands upright. */
struct SUprightPose {
  Real X, Y; /**< m, world frame */
  Real Cos, Sin; /**< cosine and sine of the yaw */
};

/**
 * Finds where rays first enter any of several discs; equal to the bit to IntersectHorizontalRay()
 * of each ray with each disc.
 *
 * With a = d.d, b = p.d and c = p.p - r^2 for the start p of a ray d relative to the centre of a
 * disc of radius r, the ray enters the disc at (-b - sqrt(b^2 - a c)) / a. The quotient grows with
 * its numerator, so only the least numerator of each ray is kept, and divided once. Roots are
 * computed only for discs that one of the rays meets.
 *
 * @param rays       in the frame of the anchor, longer than 0, at a height that the discs have.
 * @param fractions  (SRayBlock::kSize) is lowered to the fraction of each ray at which it enters
 *                   the first disc, in [0,1]: 0 if it starts inside.
 */
void EnterDiscs(const SRayBlock& rays, const SUprightPose& pose, const SDiscList& discs,
                Real* fractions);

}  // namespace argos

#endif
