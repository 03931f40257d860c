#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace argos {

namespace {

// small clusters that a thread solves in a chunk
constexpr size_t kClusterGrain = 64;
constexpr size_t kMemberGrain = 2048;

}  // namespace

void CCrowdSolver::RaiseFlag(UInt8& flag) {
  // several threads may do this at once
  std::atomic_ref<UInt8>(flag).store(1, std::memory_order_relaxed);
}

void CCrowdSolver::Reserve(size_t discs) {
  m_discs.reserve(discs);
  m_drives.reserve(discs);
  m_positions.reserve(discs);
  m_isTouching.reserve(discs);
  m_isPushed.reserve(discs);
  m_pairForces.reserve(2 * discs);
  m_contacts.reserve(2 * discs);
  m_wallForces.reserve(discs);
  m_wallContacts.reserve(discs);
  m_states.reserve(discs);
}

void CCrowdSolver::ReserveForSolids(size_t discs, size_t solids, size_t touches) {
  m_parts.reserve(2 * solids);
  m_touches.reserve(2 * touches);
  m_touchForces.reserve(2 * touches);
  m_islandContacts.reserve(3 * discs + 2 * touches);
  m_islandBodies.reserve(2 * (discs + solids));
  m_islandPlace.reserve(discs + solids);
  m_islandParent.reserve(discs + solids);
  m_islandOf.reserve(discs + solids);
  m_islands.reserve(discs + solids);
  m_memberOrder.reserve(discs + solids);
  m_contactOrder.reserve(2 * discs);
  m_wallOrder.reserve(discs);
  m_touchOrder.reserve(2 * touches);
  m_isLoaded.reserve(discs + solids);
}

void CCrowdSolver::Start(const SCrowdTick& tick, size_t discs) {
  m_tick = tick;
  const Real scale = tick.SmallestRadius * kDefaultSubsteps / tick.LeastSubsteps;
  m_tolerance = static_cast<float>(kCrowdTolerance * scale);
  m_slop = kCrowdSlop * scale;
  m_deepEnough = static_cast<float>(kDeepEnough * scale);
  m_discs.resize(discs);
  m_drives.resize(discs);
  m_positions.resize(discs);
  m_isTouching.assign(discs, 0);
  m_isPushed.assign(discs, 0);
}

// Finds the forces from which the tick starts.
void CCrowdSolver::LookUpForces(CThreadPool& pool, const SCrowdMemory& memory) {
  const auto& members = m_clusters->GetMembers();
  const auto& pairs = m_clusters->GetPairs();
  m_pairForces.resize(pairs.size());
  m_contacts.resize(pairs.size());
  pool.ParallelFor(pairs.size(), kMemberGrain, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      const UInt32 a = members[pairs[i].A].Number;
      const UInt32 b = members[pairs[i].B].Number;
      m_pairForces[i] = memory.Pairs.Find(std::min(a, b), std::max(a, b));
    }
  });
  const auto& walls = m_clusters->GetWalls();
  m_wallForces.resize(walls.size());
  m_wallContacts.resize(walls.size());
  for (size_t i = 0; i < walls.size(); ++i) {
    m_wallForces[i] = memory.Walls.Find(members[walls[i].Disc].Number, walls[i].Obstacle);
  }
  LookUpTouchForces(pool, memory.Touches);
  m_grips.resize(m_clusters->GetGrips().size());
  if (!m_solids->GetSolids().empty() || !m_grips.empty()) {
    m_gripOrder.resize(m_grips.size());
    m_islandGrips.resize(m_grips.size());
    m_islandContacts.resize(pairs.size() + walls.size() + m_touches.size());
    m_islandBodies.resize(2 * members.size());
    m_islandPlace.resize(members.size());
    m_islandParent.resize(members.size());
    m_islandOf.resize(members.size());
    m_islands.resize(members.size());
    m_memberOrder.resize(members.size());
    m_contactOrder.resize(pairs.size());
    m_wallOrder.resize(walls.size());
    m_touchOrder.resize(m_touches.size());
    m_isLoaded.assign(members.size(), 0);
  }
}

void CCrowdSolver::Solve(CThreadPool& pool, const CCrowdClusters& clusters,
                         const CDiscPairs& discPairs, const CCrowdSolids& solids,
                         const std::vector<SCrowdLine>& lines, const SCrowdMemory& memory,
                         std::vector<SCrowdGrip>& grips) {
  m_clusters = &clusters;
  m_discPairs = &discPairs;
  m_solids = &solids;
  m_lines = &lines;
  m_gripStates = &grips;
  LookUpForces(pool, memory);
  m_parts = solids.GetParts();
  m_states.assign(clusters.GetPatches().size(), SPatchState());
  pool.ParallelFor(clusters.GetNumSmall(), kClusterGrain, [this](size_t begin, size_t end, UInt32) {
    for (size_t patch = begin; patch < end; ++patch) {
      SolveSmall(static_cast<UInt32>(patch));
    }
  });
  for (const SCrowdCluster& cluster : clusters.GetLarge()) {
    SolveLarge(pool, cluster);
  }
  m_deepest = 0.0;
  for (const SPatchState& state : m_states) {
    m_deepest = std::max(m_deepest, static_cast<Real>(state.Deepest));
  }
}

// Substeps of a tick in which no disc moves or turns too far in one, and in which a force that
// lasts a substep too long moves none far.
UInt32 CCrowdSolver::CountSubsteps(const SCrowdPatch& patch) const {
  const float tick = static_cast<float>(m_tick.Duration);
  float needed = static_cast<float>(m_tick.LeastSubsteps);
  float weakest = HUGE_VALF;  // drive, N s in the tick
  for (UInt32 i = patch.FirstDisc; i < patch.EndDisc; ++i) {
    const SCrowdDrive& drive = m_drives[i];
    const SCrowdDisc& disc = m_discs[i];
    const float fastest = std::max(drive.TargetX * drive.TargetX + drive.TargetY * drive.TargetY,
                                   disc.VX * disc.VX + disc.VY * disc.VY);
    const float turn =
        IsSolid(i) ? std::max(std::abs(drive.TargetW), std::abs(disc.W)) : std::abs(drive.TargetW);
    needed = std::max(
        {needed, std::sqrt(fastest) * tick / (static_cast<float>(kMaxStepShare) * disc.Radius),
         turn * tick / static_cast<float>(kMaxStepTurn)});
    if (!drive.IsFriction) {
      weakest = std::min(weakest, drive.InTick);
    }
  }
  if (m_tick.RefineInCrowds) {
    float greatest = 0.0F;  // force, N
    for (UInt32 i = patch.FirstPair; i < patch.EndBorder; ++i) {
      greatest = std::max(greatest, m_pairForces[i].Normal);
    }
    needed = std::max(needed, greatest * tick / (kDrivesOfSubstep * weakest));
  }
  for (UInt32 i = patch.Grips.First; i < patch.BorderGrips.End; ++i) {
    needed = std::max(needed, (*m_gripStates)[m_clusters->GetGrips()[i].Number].NeededSubsteps);
  }
  const auto most = static_cast<float>(std::max(kMaxSubsteps, m_tick.LeastSubsteps));
  return static_cast<UInt32>(std::ceil(std::min(needed, most)));
}

void CCrowdSolver::SolveSmall(UInt32 number) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const UInt32 count = CountSubsteps(patch);
  SSubstep substep = {static_cast<float>(m_tick.Duration / count), 0, count};
  for (; substep.Number < count; ++substep.Number) {
    FindContacts(number, substep);
    FindGrips(patch.Grips, substep);
    StartDrives(number, substep);
    SPatchState& state = m_states[number];
    WarmStartGrips(patch.Grips);
    WarmStart(patch.FirstPair, state.NumContacts);
    WarmStartTouches(2 * patch.Touches.First, state.NumTouches);
    WarmStartWalls(patch.FirstWall, state.NumWalls);
    const float tolerance = m_tolerance / substep.Duration;
    if (patch.HasIslands()) {
      IterateSmall(number, kTouchTolerance * tolerance);
    } else {
      for (UInt32 sweep = 0; sweep < kMaxCrowdSweeps && SweepPatch(number, sweep) > tolerance;
           ++sweep) {
      }
    }
    TakeForces(number, substep);
    TakeGrips(number, substep);
    Move(number, substep);
  }
  for (UInt32 push = 0; push < kMaxPushes; ++push) {
    PushApart(number);
    if (m_states[number].Deepest <= m_deepEnough) {
      break;
    }
  }
}

void CCrowdSolver::SolveLarge(CThreadPool& pool, const SCrowdCluster& cluster) {
  UInt32 count = 0;
  for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
    count = std::max(count, CountSubsteps(m_clusters->GetPatches()[number]));
  }
  const bool usesIslands = HasPatch(cluster, &SCrowdPatch::HasIslands);
  SSubstep substep = {static_cast<float>(m_tick.Duration / count), 0, count};
  for (; substep.Number < count; ++substep.Number) {
    StartSubstep(pool, cluster, substep);
    const float tolerance = m_tolerance / substep.Duration;
    if (usesIslands) {
      IterateLarge(pool, cluster, kTouchTolerance * tolerance);
    } else {
      bool isDue = true;
      for (UInt32 sweep = 0; sweep < kMaxCrowdSweeps && isDue; ++sweep) {
        isDue = SweepLarge(pool, cluster, sweep, tolerance);
      }
    }
    ForPatches(pool, cluster, [&](UInt32 number) { TakeForces(number, substep); });
    for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
      TakeGrips(number, substep);
    }
    ForPatches(pool, cluster, [&](UInt32 number) { Move(number, substep); });
  }
  bool isDeep = true;
  for (UInt32 push = 0; push < kMaxPushes && isDeep; ++push) {
    isDeep = PushLargeApart(pool, cluster, push == 0);
  }
}

void CCrowdSolver::StartSubstep(CThreadPool& pool, const SCrowdCluster& cluster,
                                const SSubstep& substep) {
  const auto& patches = m_clusters->GetPatches();
  ForPatches(pool, cluster, [&](UInt32 number) {
    FindContacts(number, substep);
    FindGrips(patches[number].Grips, substep);
    FindGrips(patches[number].BorderGrips, substep);
  });
  ForPatches(pool, cluster, [&](UInt32 number) {
    StartDrives(number, substep);
    WarmStartGrips(patches[number].Grips);
    WarmStart(patches[number].FirstPair, m_states[number].NumContacts);
    WarmStartTouches(2 * patches[number].Touches.First, m_states[number].NumTouches);
    WarmStartWalls(patches[number].FirstWall, m_states[number].NumWalls);
    m_states[number].IsDue = true;
  });
  ForBorders(pool, cluster, [&](UInt32 number) {
    WarmStart(patches[number].FirstBorder, m_states[number].NumBorder);
    WarmStartTouches(2 * patches[number].BorderTouches.First, m_states[number].NumBorderTouches);
    WarmStartGrips(patches[number].BorderGrips);
  });
}

// @return true if another sweep is due.
bool CCrowdSolver::SweepLarge(CThreadPool& pool, const SCrowdCluster& cluster, UInt32 sweep,
                              float tolerance) {
  ForPatches(pool, cluster, [&](UInt32 number) {
    if (m_states[number].IsDue) {
      SweepPatch(number, sweep);
    }
  });
  ForBorders(pool, cluster, [&](UInt32 number) {
    SPatchState& state = m_states[number];
    if (state.IsDue || m_states[number + 1].IsDue) {
      const SCrowdPatch& patch = m_clusters->GetPatches()[number];
      const bool backwards = sweep % 2 != 0;
      state.BorderChange =
          std::max(SweepContacts(patch.FirstBorder, state.NumBorder, backwards),
                   SweepTouches(2 * patch.BorderTouches.First, state.NumBorderTouches, backwards));
      state.BorderChange = std::max(state.BorderChange, SweepGrips(patch.BorderGrips));
    }
  });
  bool isDue = false;
  float before = 0.0F;  // on the border with the patch before
  for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
    SPatchState& state = m_states[number];
    state.IsDue = std::max({before, state.BorderChange, state.Change}) > tolerance;
    before = state.BorderChange;
    isDue = isDue || state.IsDue;
  }
  return isDue;
}

// @return true if an overlap that is too deep may be left.
bool CCrowdSolver::PushLargeApart(CThreadPool& pool, const SCrowdCluster& cluster, bool isFirst) {
  float before = 0.0F;  // on the border with the patch before
  for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
    SPatchState& state = m_states[number];
    state.IsDue = isFirst || std::max({before, state.Deepest, state.BorderDeepest}) > m_deepEnough;
    before = state.BorderDeepest;
  }
  ForPatches(pool, cluster, [&](UInt32 number) {
    if (m_states[number].IsDue) {
      PushApart(number);
    }
  });
  ForBorders(pool, cluster, [&](UInt32 number) {
    SPatchState& state = m_states[number];
    if (state.IsDue || m_states[number + 1].IsDue) {
      const SCrowdPatch& patch = m_clusters->GetPatches()[number];
      state.BorderDeepest = std::max(PushContactsApart(patch.FirstBorder, state.NumBorder),
                                     PushTouchesApart(patch.BorderTouches));
    }
  });
  return std::any_of(m_states.begin() + cluster.FirstPatch, m_states.begin() + cluster.EndPatch,
                     [this](const SPatchState& state) {
                       return std::max(state.Deepest, state.BorderDeepest) > m_deepEnough;
                     });
}

float CCrowdSolver::SweepPatch(UInt32 number, UInt32 sweep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  float change = SweepDrives(patch.FirstDisc, patch.EndDisc);
  const bool backwards = sweep % 2 != 0;
  change = std::max(change, SweepContacts(patch.FirstPair, state.NumContacts, backwards));
  change = std::max(change, SweepTouches(2 * patch.Touches.First, state.NumTouches, backwards));
  if (patch.Grips.GetSize() > 0) {
    change = std::max(change, SweepGrips(patch.Grips));
  }
  change = std::max(change, SweepWalls(patch.FirstWall, state.NumWalls));
  state.Change = change;
  return change;
}

// Each sweep returns the greatest change of a velocity, m/s.
float CCrowdSolver::SweepDrives(UInt32 first, UInt32 end) {
  float greatest = 0.0F;
  for (UInt32 i = first; i < end; ++i) {
    SCrowdDrive& drive = m_drives[i];
    SCrowdDisc& disc = m_discs[i];
    float x = drive.X + (drive.TargetX - disc.VX) / disc.InverseMass;
    float y = drive.Y + (drive.TargetY - disc.VY) / disc.InverseMass;
    const float squared = x * x + y * y;
    if (squared > drive.Most * drive.Most) {
      const float scale = drive.Most / std::sqrt(squared);
      x *= scale;
      y *= scale;
    }
    const float changeX = disc.InverseMass * (x - drive.X);
    const float changeY = disc.InverseMass * (y - drive.Y);
    disc.VX += changeX;
    disc.VY += changeY;
    drive.X = x;
    drive.Y = y;
    const float angular = std::clamp(drive.Angular + (drive.TargetW - disc.W) / disc.InverseInertia,
                                     -drive.AngularMost, drive.AngularMost);
    disc.W += disc.InverseInertia * (angular - drive.Angular);
    drive.Angular = angular;
    greatest = std::max({greatest, std::abs(changeX), std::abs(changeY)});
  }
  return greatest;
}

void CCrowdSolver::ApplyImpulse(const SContact& contact, float normal, float tangent) {
  const float x = normal * contact.NX - tangent * contact.NY;
  const float y = normal * contact.NY + tangent * contact.NX;
  m_discs[contact.A].ApplyImpulse(-x, -y, -tangent);
  m_discs[contact.B].ApplyImpulse(x, y, -tangent);
}

void CCrowdSolver::ApplyImpulse(const SWallContact& contact, float normal, float tangent) {
  m_discs[contact.Disc].ApplyImpulse(-(normal * contact.NX - tangent * contact.NY),
                                     -(normal * contact.NY + tangent * contact.NX), -tangent);
}

float CCrowdSolver::SolveContact(SContact& contact) {
  const SCrowdDisc& a = m_discs[contact.A];
  const SCrowdDisc& b = m_discs[contact.B];
  const float x = b.VX - a.VX;
  const float y = b.VY - a.VY;
  const float approach = -(x * contact.NX + y * contact.NY);
  const float normal =
      std::max(0.0F, contact.Normal + (approach - contact.Approach) * contact.Mass);
  const float changeN = normal - contact.Normal;
  contact.Normal = normal;
  if (normal == 0.0F && contact.Tangent == 0.0F && changeN == 0.0F) {
    return 0.0F;
  }
  // of b's surface past a's, along the tangent
  const float slip = y * contact.NX - x * contact.NY - a.Radius * a.W - b.Radius * b.W;
  const float most = kDiscFriction * normal;
  const float tangent = std::clamp(contact.Tangent - slip * contact.TangentMass, -most, most);
  const float changeT = tangent - contact.Tangent;
  contact.Tangent = tangent;
  ApplyImpulse(contact, changeN, changeT);
  return std::abs(changeN) / contact.Mass;
}

float CCrowdSolver::SweepContacts(UInt32 first, UInt32 count, bool backwards) {
  float greatest = 0.0F;
  for (UInt32 i = 0; i < count; ++i) {
    greatest =
        std::max(greatest, SolveContact(m_contacts[first + (backwards ? count - 1 - i : i)]));
  }
  return greatest;
}

float CCrowdSolver::SweepWalls(UInt32 first, UInt32 count) {
  float greatest = 0.0F;
  for (UInt32 i = first; i < first + count; ++i) {
    SWallContact& contact = m_wallContacts[i];
    const SCrowdDisc& disc = m_discs[contact.Disc];
    const float mass = 1.0F / disc.InverseMass;
    const float approach = disc.VX * contact.NX + disc.VY * contact.NY;
    const float normal = std::max(0.0F, contact.Normal + (approach - contact.Approach) * mass);
    const float changeN = normal - contact.Normal;
    contact.Normal = normal;
    // of the wall past the disc
    const float slip = disc.VX * contact.NY - disc.VY * contact.NX - disc.Radius * disc.W;
    const float tangentMass =
        1.0F / (disc.InverseMass + disc.InverseInertia * disc.Radius * disc.Radius);
    const float most = contact.Friction * normal;
    const float tangent = std::clamp(contact.Tangent - slip * tangentMass, -most, most);
    const float changeT = tangent - contact.Tangent;
    contact.Tangent = tangent;
    ApplyImpulse(contact, changeN, changeT);
    greatest = std::max(greatest, std::abs(changeN) * disc.InverseMass);
  }
  return greatest;
}

void CCrowdSolver::TakeForces(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  // no disc enters a wall because of what is not solved
  SweepWalls(patch.FirstWall, state.NumWalls);
  const float perSecond = 1.0F / substep.Duration;
  for (const auto& [first, count] : {std::pair(patch.FirstPair, state.NumContacts),
                                     std::pair(patch.FirstBorder, state.NumBorder)}) {
    for (UInt32 i = first; i < first + count; ++i) {
      const SContact& contact = m_contacts[i];
      m_pairForces[contact.Pair].Take(contact.Normal * perSecond, contact.Tangent * perSecond);
      if (contact.Normal > 0.0F) {
        RaiseFlag(m_isPushed[contact.A]);
        RaiseFlag(m_isPushed[contact.B]);
      }
    }
  }
  for (UInt32 i = patch.FirstWall; i < patch.FirstWall + state.NumWalls; ++i) {
    const SWallContact& contact = m_wallContacts[i];
    m_wallForces[contact.Wall].Take(contact.Normal * perSecond, contact.Tangent * perSecond);
    if (contact.Normal > 0.0F) {
      RaiseFlag(m_isPushed[contact.Disc]);
    }
  }
  TakeTouchForces(2 * patch.Touches.First, state.NumTouches, perSecond);
  TakeTouchForces(2 * patch.BorderTouches.First, state.NumBorderTouches, perSecond);
}

void CCrowdSolver::Move(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const Real duration = static_cast<Real>(substep.Duration);
  const float fastest = static_cast<float>(m_tick.LongestPath / m_tick.Duration);
  for (UInt32 i = patch.FirstDisc; i < patch.EndDisc; ++i) {
    SCrowdDisc& disc = m_discs[i];
    const float squared = disc.VX * disc.VX + disc.VY * disc.VY;
    if (squared > fastest * fastest) {
      const float scale = fastest / std::sqrt(squared);
      disc.VX *= scale;
      disc.VY *= scale;
    }
    if (IsSolid(i)) {
      MoveSolid(i, substep);
    } else {
      SCrowdPosition& position = m_positions[i];
      position.X += static_cast<Real>(disc.VX) * duration;
      position.Y += static_cast<Real>(disc.VY) * duration;
      position.Turn += static_cast<Real>(disc.W) * duration;
    }
    SCrowdDrive& drive = m_drives[i];
    drive.Spent += std::sqrt(drive.X * drive.X + drive.Y * drive.Y);
    drive.AngularSpent += std::abs(drive.Angular);
  }
}

// One sweep over a patch, walls last.
void CCrowdSolver::PushApart(UInt32 number) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  state.Deepest = PushContactsApart(patch.FirstPair, state.NumContacts);
  state.Deepest = std::max(state.Deepest, PushTouchesApart(patch.Touches));
  state.Deepest = std::max(state.Deepest, PushOutOfWalls(patch.FirstWall, state.NumWalls));
}

// @return the depth of the deepest overlap that was found, m.
float CCrowdSolver::PushContactsApart(UInt32 first, UInt32 count) {
  float deepest = 0.0F;
  for (UInt32 i = first; i < first + count; ++i) {
    const SContact& contact = m_contacts[i];
    const SCrowdPosition& a = m_positions[contact.A];
    const SCrowdPosition& b = m_positions[contact.B];
    const SCrowdDisc& discA = m_discs[contact.A];
    const SCrowdDisc& discB = m_discs[contact.B];
    const Real reach = static_cast<Real>(discA.Radius) + static_cast<Real>(discB.Radius);
    const Real limit = reach - static_cast<Real>(m_tolerance);
    const Real x = m_tick.Period.X.Shorten(b.X - a.X);
    const Real y = m_tick.Period.Y.Shorten(b.Y - a.Y);
    const Real squared = x * x + y * y;
    if (squared >= limit * limit || squared == 0.0) {
      continue;
    }
    const Real distance = std::sqrt(squared);
    const Real depth = reach - distance;
    deepest = std::max(deepest, static_cast<float>(depth));
    const Real share = std::min(depth, kMaxCrowdCorrection * m_tick.SmallestRadius) /
                       (distance * static_cast<Real>(discA.InverseMass + discB.InverseMass));
    const Real shareA = share * static_cast<Real>(discA.InverseMass);
    const Real shareB = share * static_cast<Real>(discB.InverseMass);
    Push(contact.A, -shareA * x, -shareA * y);
    Push(contact.B, shareB * x, shareB * y);
  }
  return deepest;
}

float CCrowdSolver::PushOutOfWalls(UInt32 first, UInt32 count) {
  float deepest = 0.0F;
  for (UInt32 i = first; i < first + count; ++i) {
    const auto& wall = m_clusters->GetWalls()[m_wallContacts[i].Wall];
    const SSeparation separation = SeparateFromWall(wall, SPlanarVector());
    if (separation.Gap < -static_cast<Real>(m_tolerance)) {
      deepest = std::max(deepest, static_cast<float>(-separation.Gap));
      const Real push = std::max(separation.Gap, -kMaxCrowdCorrection * m_tick.SmallestRadius);
      Push(wall.Disc, push * separation.NormalX, push * separation.NormalY);
    }
  }
  return deepest;
}

void CCrowdSolver::Push(UInt32 disc, Real x, Real y) {
  m_positions[disc].X += x;
  m_positions[disc].Y += y;
  RaiseFlag(m_isPushed[disc]);
}

void CCrowdSolver::Remember(size_t slots, SCrowdMemory& memory) const {
  const CCrowdClusters& clusters = *m_clusters;
  CContactMemory& pairMemory = memory.Pairs;
  CContactMemory& wallMemory = memory.Walls;
  const auto& members = clusters.GetMembers();
  pairMemory.StartCollecting();
  for (size_t i = 0; i < m_pairForces.size(); ++i) {
    if (m_pairForces[i].Normal > 0.0F) {
      const auto& pair = clusters.GetPairs()[i];
      const UInt32 a = members[pair.A].Number;
      const UInt32 b = members[pair.B].Number;
      pairMemory.Collect({std::min(a, b), std::max(a, b), m_pairForces[i]});
    }
  }
  pairMemory.FinishCollecting(slots);
  wallMemory.StartCollecting();
  for (size_t i = 0; i < m_wallForces.size(); ++i) {
    const auto& wall = clusters.GetWalls()[i];
    if (m_wallForces[i].Normal > 0.0F && wall.Obstacle < kFirstLine) {
      wallMemory.Collect({members[wall.Disc].Number, wall.Obstacle, m_wallForces[i]});
    }
  }
  wallMemory.FinishCollecting(slots);
  RememberTouches(memory.Touches);
}

}  // namespace argos
