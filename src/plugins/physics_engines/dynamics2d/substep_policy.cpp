#include <argos3/plugins/simulator/physics_engines/dynamics2d/substep_policy.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

UInt32 CSubstepPolicy::ChooseSubsteps(const SSubstepNeeds& needs) const {
  const UInt32 cap = std::max(kMaxSubsteps, m_settings.Substeps);
  // written so that NaN gets the cap
  if (!(needs.ForMotion < static_cast<float>(cap))) {
    return cap;
  }
  UInt32 substeps = std::max(m_settings.Substeps + m_extraSubsteps,
                             static_cast<UInt32>(std::ceil(needs.ForMotion)));
  if (m_settings.RefineInCrowds) {
    substeps = std::max(substeps, ComputeSubstepsForCrowds(needs.WeakestDrive));
    if (needs.IsHolding) {
      // the tolerance keeps a rounding error from adding a substep
      substeps = std::max(substeps,
                          static_cast<UInt32>(std::ceil(m_settings.Tick / kMaxGripSubstep - 1e-6)));
    }
  }
  return substeps;
}

// See kSubstepsPerDrive; the robot that needs most substeps decides.
UInt32 CSubstepPolicy::ComputeSubstepsForCrowds(Real weakestDrive) const {
  if (m_greatestForce == 0.0F) {
    return 0;
  }
  const float impulse = static_cast<float>(m_settings.Tick) * m_greatestForce;
  const float weakestInUnits =
      static_cast<float>(std::sqrt(weakestDrive) * m_settings.UnitsPerMetre);
  const float substeps = kSubstepsPerDrive * impulse / weakestInUnits;
  return static_cast<UInt32>(std::min(substeps, static_cast<float>(kMaxSubsteps)));
}

int CSubstepPolicy::ChooseIterations(UInt32 substeps, bool isHolding) const {
  if (isHolding) {
    const float duration = static_cast<float>(m_settings.Tick / substeps);
    return std::clamp(static_cast<int>(std::ceil(duration * kGripIterationsPerSecond)),
                      kVelocityIterations, kMaxGripIterations);
  }
  const bool isCrowd = m_settings.RefineInCrowds && substeps > kFewSubsteps;
  return isCrowd ? kCrowdVelocityIterations : kVelocityIterations;
}

void CSubstepPolicy::FinishTick(float deepestOverlap, float greatestForce) {
  m_greatestForce = greatestForce;
  if (!m_settings.RefineInCrowds) {
    return;
  }
  if (deepestOverlap > kTooDeep) {
    m_extraSubsteps = std::min(m_extraSubsteps + 1, kMaxExtraSubsteps);
    m_calmTicks = 0;
  } else if (deepestOverlap > kShallow) {
    m_calmTicks = 0;
  } else if (m_extraSubsteps > 0 && ++m_calmTicks >= kCalmTicks) {
    --m_extraSubsteps;
    m_calmTicks = 0;
  }
}

}  // namespace argos
