#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_SUBSTEP_POLICY_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_DYNAMICS2D_SUBSTEP_POLICY_H

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_settings.h>

#include <cmath>

namespace argos {

/** The state of a world at the start of a tick that determines its substeps. */
struct SSubstepNeeds {
  float ForMotion = 0.0F;  // substeps in which no body moves or turns too far in one
  bool IsHolding = false;  // a gripper holds a body
  Real WeakestDrive = HUGE_VAL;  // see CActiveSet::ComputeWeakestDrive()
};

/**
 * Chooses the substeps of each tick, and the iterations of Box2D's velocity solver in a substep.
 *
 * It adds substeps for fast bodies, for grips and, unless the user has set their number, for
 * crowds: after ticks that left overlaps, and in proportion to the greatest contact force. See
 * planar_limits.h.
 */
class CSubstepPolicy {
 public:
  explicit CSubstepPolicy(const SPlanarSettings& settings) : m_settings(settings) {}

  /** @return true if ChooseSubsteps() uses WeakestDrive. */
  bool UsesWeakestDrive() const { return m_settings.RefineInCrowds && m_greatestForce != 0.0F; }
  UInt32 ChooseSubsteps(const SSubstepNeeds& needs) const;
  int ChooseIterations(UInt32 substeps, bool isHolding) const;

  /**
   * Adapts the policy to the result of a tick.
   * @param deepestOverlap  that is left, Box2D units.
   * @param greatestForce   in a contact or grip, kg Box2D units / s^2.
   */
  void FinishTick(float deepestOverlap, float greatestForce);

 private:
  UInt32 ComputeSubstepsForCrowds(Real weakestDrive) const;

  SPlanarSettings m_settings;
  UInt32 m_extraSubsteps = 0;
  UInt32 m_calmTicks = 0;
  float m_greatestForce = 0.0F;  // in the last tick
};

}  // namespace argos

#endif
