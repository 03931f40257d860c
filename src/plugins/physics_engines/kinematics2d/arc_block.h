#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_ARC_BLOCK_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_ARC_BLOCK_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstddef>

namespace argos {

/**
 * Some robots and the arcs that they drive, in arrays that the compiler can work on several at a
 * time.
 */
struct SArcBlock {
  static constexpr size_t kSize = 64;

  // in
  Real Path[kSize];  // m, along the arc, negative backwards
  Real Quarter[kSize];  // rad: a quarter of what the heading turns by
  // in and out: the heading, of half of it
  Real HalfCos[kSize];
  Real HalfSin[kSize];
  // out: the chord, m, world frame
  Real StepX[kSize];
  Real StepY[kSize];

  /**
   * Drives the first @p count arcs; exact but for rounding. What becomes of a robot does not depend
   * on the others.
   *
   * Source: as FollowArc() of core/simulator/physics_engine/planar_motion.h.
   */
  void Drive(size_t count);
};

}  // namespace argos

#endif
