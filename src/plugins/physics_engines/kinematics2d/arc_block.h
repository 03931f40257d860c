#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_ARC_BLOCK_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_ARC_BLOCK_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>

namespace argos {

/** The arcs of several robots, in arrays that the compiler can vectorise. */
struct SArcBlock {
  static constexpr size_t kSize = 64;

  // in
  Real Path[kSize];  // m, along the arc, negative backwards
  Real Quarter[kSize];  // rad; a quarter of the change of the heading
  // in and out: half of the heading
  Real HalfCos[kSize];
  Real HalfSin[kSize];
  // out: the chord, m, world frame
  Real StepX[kSize];
  Real StepY[kSize];

  /**
   * Follows the first @p count arcs, and overwrites the others; exact except for rounding errors.
   * The result of a robot does not depend on the others.
   *
   * Source: as for FollowArc() of core/simulator/physics_engine/planar_motion.h.
   */
  void Drive(size_t count);
};

}  // namespace argos

#endif
