// Grips: the motion of two bodies, and of the turret between them, that a grip allows.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

void CCrowdSolver::FindGrips(const SCrowdRange& range, const SSubstep& substep) {
  for (UInt32 i = range.First; i < range.End; ++i) {
    FindGrip(i, substep);
  }
}

// The spring is implicit: it is as stiff and damped as described in any number of substeps (E.
// Catto, Soft Constraints, 2011). An error across the arm is corrected by a share in a substep.
void CCrowdSolver::FindGrip(UInt32 number, const SSubstep& substep) {
  const CCrowdClusters::SGrip& members = m_clusters->GetGrips()[number];
  const SCrowdGrip& state = (*m_gripStates)[members.Number];
  SGrip& grip = m_grips[number] = SGrip();
  grip.A = members.Holder;
  grip.B = members.Held;
  const SCrowdPosition& holder = m_positions[grip.A];
  const SCrowdPosition& held = m_positions[grip.B];
  const SPlanarVector pivot = Rotate(state.Pivot, holder.Turn);
  const SPlanarVector arm = Rotate(state.Arm, holder.Turn + state.Rotation);
  const SPlanarVector axis = Rotate(state.Axis, holder.Turn + state.Rotation);
  const SPlanarVector point = Rotate(state.Point, held.Turn);
  // from the pivot to the point
  const SPlanarVector way = {m_tick.Period.X.Shorten(held.X - holder.X) + point.X - pivot.X,
                             m_tick.Period.Y.Shorten(held.Y - holder.Y) + point.Y - pivot.Y};
  const Real errorX = way.X - arm.X;
  const Real errorY = way.Y - arm.Y;
  grip.NX = static_cast<float>(axis.X);
  grip.NY = static_cast<float>(axis.Y);
  const auto setLevers = [&](float* levers, const SPlanarVector& lever) {
    levers[kAxisAlong] = static_cast<float>(lever.X * axis.Y - lever.Y * axis.X);
    levers[kAxisAcross] = static_cast<float>(lever.X * axis.X + lever.Y * axis.Y);
  };
  grip.InverseArmInertia = state.InverseArmInertia;
  if (grip.HasTurret()) {
    setLevers(grip.BaseLever, pivot);
    setLevers(grip.ArmLever, way);
  } else {
    setLevers(grip.BaseLever, {pivot.X + way.X, pivot.Y + way.Y});
  }
  setLevers(grip.HeldLever, point);

  const Real duration = static_cast<Real>(substep.Duration);
  const Real softness = 1.0 / (duration * (state.Damping + duration * state.Stiffness));
  const Real along = errorX * axis.X + errorY * axis.Y;
  const Real across = errorY * axis.X - errorX * axis.Y;
  grip.Softness[kAxisAlong] = static_cast<float>(softness);
  grip.Bias[kAxisAlong] = static_cast<float>(along * duration * state.Stiffness * softness);
  grip.Bias[kAxisAcross] = static_cast<float>(kGripCorrection * across / duration);

  grip.ArmRate.Now[0] = state.ArmRate;
  if (state.IsMotorOn) {
    // the target of a substep is absolute, so that an error is corrected in the next one
    const Real target =
        state.MotorTarget - state.MotorRate * duration * (substep.Count - 1 - substep.Number);
    grip.MotorRate =
        static_cast<float>(std::remainder(target - state.Rotation, 2.0 * ARGOS_PI) / duration);
  }
  grip.MotorMost = state.MotorTorque * substep.Duration;
  grip.Impulse.Set({state.Along * substep.Duration, state.Across * substep.Duration,
                    std::clamp(state.Motor * substep.Duration, -grip.MotorMost, grip.MotorMost)});
  for (const UInt32 member : {grip.A, grip.B}) {
    RaiseFlag(m_isTouching[member]);
    RaiseFlag(m_isPushed[member]);
  }
}

void CCrowdSolver::ApplyImpulse(SGrip& grip, const SGripChange<float>& change) {
  ApplyGripChange(grip, change, [this](UInt32 member, float x, float y, float turn) {
    SCrowdDisc& disc = m_discs[member];
    disc.VX += disc.InverseMass * x;
    disc.VY += disc.InverseMass * y;
    disc.W += disc.InverseInertia * turn;
  });
}

void CCrowdSolver::WarmStartGrips(const SCrowdRange& range) {
  for (UInt32 i = range.First; i < range.End; ++i) {
    SGrip& grip = m_grips[i];
    const float* const impulse = grip.Impulse.Now;
    const SGripChange<float> change = {impulse[kAxisAlong], impulse[kAxisAcross],
                                       impulse[kAxisMotor]};
    grip.Impulse.Set({0.0F, 0.0F, 0.0F});
    ApplyImpulse(grip, change);
  }
}

float CCrowdSolver::SweepGrips(const SCrowdRange& range) {
  float greatest = 0.0F;
  for (UInt32 i = range.First; i < range.End; ++i) {
    SGrip& grip = m_grips[i];
    const SCrowdDisc& a = m_discs[grip.A];
    const SCrowdDisc& b = m_discs[grip.B];
    const SGripChange<float> change = SolveGrip(grip, MotionOf(a), MotionOf(b));
    ApplyImpulse(grip, change);
    const float changes[2] = {change.Along, change.Across};
    for (const int axis : {kAxisAlong, kAxisAcross}) {
      const float compliance = ComputeGripCompliance(grip, a.InverseMass + b.InverseMass,
                                                     a.InverseInertia, b.InverseInertia, axis);
      greatest = std::max(greatest, std::abs(changes[axis]) * compliance);
    }
  }
  return greatest;
}

// After all forces are known, and before anything moves. One thread.
void CCrowdSolver::TakeGrips(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const float perSecond = 1.0F / substep.Duration;
  for (UInt32 i = patch.Grips.First; i < patch.BorderGrips.End; ++i) {
    const SGrip& grip = m_grips[i];
    SCrowdGrip& state = (*m_gripStates)[m_clusters->GetGrips()[i].Number];
    state.Along = perSecond * grip.Impulse.Now[kAxisAlong];
    state.Across = perSecond * grip.Impulse.Now[kAxisAcross];
    state.Motor = perSecond * grip.Impulse.Now[kAxisMotor];
    state.ArmRate = grip.ArmRate.Now[0];
    if (grip.HasTurret()) {
      state.Rotation += static_cast<Real>((state.ArmRate - m_discs[grip.A].W) * substep.Duration);
    }
    m_isLoaded[grip.A] = m_isLoaded[grip.B] = 1;
  }
}

}  // namespace argos
