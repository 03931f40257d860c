// The contacts of a substep, and what the solver starts from.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

float LimitFriction(float tangent, float most) {
  return std::clamp(tangent, -most, most);
}

}  // namespace

void CCrowdSolver::FindContacts(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  state.Deepest = 0.0F;
  state.NumContacts = FindContacts(patch.FirstPair, patch.EndPair, substep, state);
  state.NumBorder = FindContacts(patch.FirstBorder, patch.EndBorder, substep, state);
  FindWalls(number, substep);
  state.NumTouches = FindTouches(patch.Touches, substep, state);
  state.NumBorderTouches = FindTouches(patch.BorderTouches, substep, state);
}

// @return the number of contacts, which begin at the number of the first pair.
UInt32 CCrowdSolver::FindContacts(UInt32 first, UInt32 end, const SSubstep& substep,
                                  SPatchState& state) {
  const Real duration = static_cast<Real>(substep.Duration);
  const Real mostApproach = 2.0 * m_tick.LongestPath / substep.Count;
  const Real touchingGap = kTouchingGap * m_tick.SmallestRadius;
  const Real mostCorrection = kMaxCrowdCorrection * m_tick.SmallestRadius;
  UInt32 next = first;
  for (UInt32 i = first; i < end; ++i) {
    const auto& pair = m_clusters->GetPairs()[i];
    const SCrowdPosition& a = m_positions[pair.A];
    const SCrowdPosition& b = m_positions[pair.B];
    const SCrowdDisc& discA = m_discs[pair.A];
    const SCrowdDisc& discB = m_discs[pair.B];
    const Real reach = static_cast<Real>(discA.Radius) + static_cast<Real>(discB.Radius);
    const SPlanarVector offset = {m_tick.Period.X.Shorten(b.X - a.X),
                                  m_tick.Period.Y.Shorten(b.Y - a.Y)};
    const Real farthest = reach + mostApproach;
    if (offset.X * offset.X + offset.Y * offset.Y > farthest * farthest) {
      m_pairForces[i] = SContactForce();
      continue;
    }
    const SPlanarVector relative = {static_cast<Real>(discB.VX - discA.VX) * duration,
                                    static_cast<Real>(discB.VY - discA.VY) * duration};
    const SSeparation separation = SeparateDiscs(offset, relative, reach);
    SContact& contact = m_contacts[next++];
    contact.A = pair.A;
    contact.B = pair.B;
    contact.Pair = i;
    contact.NX = static_cast<float>(separation.NormalX);
    contact.NY = static_cast<float>(separation.NormalY);
    Real room = separation.Gap;
    if (room < 0.0) {
      state.Deepest = std::max(state.Deepest, static_cast<float>(-room));
      room = std::clamp(kCrowdCorrection * (room + m_slop), -mostCorrection, 0.0) / substep.Count;
    }
    contact.Approach = static_cast<float>(room / duration);
    const float inverseMass = discA.InverseMass + discB.InverseMass;
    contact.Mass = 1.0F / inverseMass;
    contact.TangentMass = 1.0F / (inverseMass + discA.InverseInertia * discA.Radius * discA.Radius +
                                  discB.InverseInertia * discB.Radius * discB.Radius);
    contact.Normal = m_pairForces[i].Steady * substep.Duration;
    contact.Tangent =
        LimitFriction(m_pairForces[i].Tangent, kDiscFriction * m_pairForces[i].Steady) *
        substep.Duration;
    if (contact.Normal > 0.0F || separation.Gap < touchingGap) {
      RaiseFlag(m_isTouching[pair.A]);
      RaiseFlag(m_isTouching[pair.B]);
    }
  }
  return next - first;
}

SSeparation CCrowdSolver::SeparateFromWall(const CCrowdClusters::SWall& wall,
                                           const SPlanarVector& step) const {
  const SCrowdPosition& position = m_positions[wall.Disc];
  const Real radius = static_cast<Real>(m_discs[wall.Disc].Radius);
  if (wall.Obstacle < kFirstLine) {
    return SeparateFromFootprint(position.X, position.Y, radius, step,
                                 m_discPairs->GetObstacle(wall.Obstacle));
  }
  const SCrowdLine& line = (*m_lines)[wall.Obstacle - kFirstLine];
  SSeparation separation;
  separation.NormalX = line.NormalX;
  separation.NormalY = line.NormalY;
  separation.Gap =
      line.NormalX * (line.X - position.X) + line.NormalY * (line.Y - position.Y) - radius;
  return separation;
}

void CCrowdSolver::FindWalls(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  const Real duration = static_cast<Real>(substep.Duration);
  const Real touchingGap = kTouchingGap * m_tick.SmallestRadius;
  const Real mostCorrection = kMaxCrowdCorrection * m_tick.SmallestRadius;
  UInt32 next = patch.FirstWall;
  for (UInt32 i = patch.FirstWall; i < patch.EndWall; ++i) {
    const auto& wall = m_clusters->GetWalls()[i];
    const SCrowdDisc& disc = m_discs[wall.Disc];
    const SPlanarVector step = {static_cast<Real>(disc.VX) * duration,
                                static_cast<Real>(disc.VY) * duration};
    const SSeparation separation = SeparateFromWall(wall, step);
    Real room = separation.Gap;
    if (room > m_tick.LongestPath / substep.Count) {
      m_wallForces[i] = SContactForce();
      continue;
    }
    if (room < 0.0) {
      state.Deepest = std::max(state.Deepest, static_cast<float>(-room));
      room = std::clamp(kCrowdCorrection * (room + m_slop), -mostCorrection, 0.0) / substep.Count;
    }
    SWallContact& contact = m_wallContacts[next++];
    contact.Disc = wall.Disc;
    contact.Wall = i;
    contact.NX = static_cast<float>(separation.NormalX);
    contact.NY = static_cast<float>(separation.NormalY);
    contact.Approach = static_cast<float>(room / duration);
    contact.Friction = wall.Obstacle < kFirstLine ? kWallFriction : 0.0F;
    contact.Normal = m_wallForces[i].Steady * substep.Duration;
    contact.Tangent =
        LimitFriction(m_wallForces[i].Tangent, contact.Friction * m_wallForces[i].Steady) *
        substep.Duration;
    if (contact.Normal > 0.0F || separation.Gap < touchingGap) {
      RaiseFlag(m_isTouching[wall.Disc]);
    }
  }
  state.NumWalls = next - patch.FirstWall;
}

void CCrowdSolver::StartDrives(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  for (UInt32 i = patch.FirstDisc; i < patch.EndDisc; ++i) {
    StartDrive(i, substep);
    m_isTouching[i] = 0;
  }
}

// A force acts in each substep, up to its bound. But a robot that touches nothing may use as much
// of the bound of the tick as it takes to reach its speed at the start of the tick: this makes its
// path an exact arc. What it has used in advance it does not have later; what it has not used is
// not saved for later.
void CCrowdSolver::StartDrive(UInt32 member, const SSubstep& substep) {
  SCrowdDrive& drive = m_drives[member];
  const SCrowdDisc& disc = m_discs[member];
  const float count = static_cast<float>(substep.Count);
  const float elapsed = static_cast<float>(substep.Number + 1) / count;
  drive.Most = drive.InTick / count;
  drive.AngularMost = drive.AngularInTick / count;
  if (!drive.IsFriction) {
    drive.Most = std::min(drive.Most, elapsed * drive.InTick - drive.Spent);
    drive.AngularMost =
        std::min(drive.AngularMost, elapsed * drive.AngularInTick - drive.AngularSpent);
    if (m_isTouching[member] == 0) {
      const float x = drive.TargetX - disc.VX;
      const float y = drive.TargetY - disc.VY;
      const float change = std::sqrt(x * x + y * y);
      const float turn = std::abs(drive.TargetW - disc.W);
      drive.Most = std::clamp(kAmpleImpulse * change / disc.InverseMass, drive.Most,
                              std::max(drive.Most, drive.InTick - drive.Spent));
      drive.AngularMost =
          std::clamp(kAmpleImpulse * turn / disc.InverseInertia, drive.AngularMost,
                     std::max(drive.AngularMost, drive.AngularInTick - drive.AngularSpent));
    }
  }
  drive.Most = std::max(drive.Most, 0.0F);
  drive.AngularMost = std::max(drive.AngularMost, 0.0F);
  drive.X = drive.Y = drive.Angular = 0.0F;
}

void CCrowdSolver::WarmStart(UInt32 first, UInt32 count) {
  for (UInt32 i = first; i < first + count; ++i) {
    if (m_contacts[i].Normal > 0.0F) {
      ApplyImpulse(m_contacts[i], m_contacts[i].Normal, m_contacts[i].Tangent);
    }
  }
}

void CCrowdSolver::WarmStartWalls(UInt32 first, UInt32 count) {
  for (UInt32 i = first; i < first + count; ++i) {
    ApplyImpulse(m_wallContacts[i], m_wallContacts[i].Normal, m_wallContacts[i].Tangent);
  }
}

}  // namespace argos
