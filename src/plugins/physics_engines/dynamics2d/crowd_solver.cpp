#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace argos {

namespace {

// small clusters that a thread solves in a run
constexpr size_t kClusterGrain = 64;
constexpr size_t kMemberGrain = 2048;
// Sweeps of a substep, at most.
constexpr UInt32 kMaxSweeps = 300;
// Velocities are solved when a sweep changes none by more than this share of a radius in the
// substep. This and the depths below hold for two substeps in a tick: more are more accurate.
constexpr Real kTolerance = 0.001;
// In a crowd the forces of drives add up. A tick has a substep for each such multiple of the force
// of a drive in the greatest force of a contact.
constexpr float kDrivesOfSubstep = 8.0F;
// Share of an overlap that is corrected in a tick, by the speed at which the discs must part, and
// the greatest correction as a share of the smallest radius. The speed does not depend on the
// number of substeps: what moves the discs apart in a short substep would hurl them.
constexpr Real kCorrection = 0.6;
constexpr Real kMaxCorrection = 0.25;
// Overlaps up to this share of the smallest radius are not corrected: at rest nothing moves.
constexpr Real kSlop = 0.002;
// At the end of a tick, overlaps deeper than this share of the smallest radius are reduced, in at
// most so many sweeps.
constexpr Real kDeepEnough = 0.005;
constexpr UInt32 kMaxPushes = 12;
// Gaps up to this share of the smallest radius count as touching.
constexpr Real kTouchingGap = 0.005;
// slightly more than the change of velocity takes, for rounding errors
constexpr float kAmple = 1.01F;

constexpr float kDiscFriction = static_cast<float>(kMovableFriction * kMovableFriction);
constexpr float kWallFriction = static_cast<float>(kMovableFriction * kImmovableFriction);

float LimitFriction(float tangent, float most) {
  return std::clamp(tangent, -most, most);
}

void RaiseFlag(UInt8& flag) {
  // several threads may do this at once
  std::atomic_ref<UInt8>(flag).store(1, std::memory_order_relaxed);
}

}  // namespace

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

void CCrowdSolver::Start(const SCrowdTick& tick, size_t discs) {
  m_tick = tick;
  const Real scale = tick.SmallestRadius * kDefaultSubsteps / tick.LeastSubsteps;
  m_tolerance = static_cast<float>(kTolerance * scale);
  m_slop = kSlop * scale;
  m_deepEnough = static_cast<float>(kDeepEnough * scale);
  m_discs.resize(discs);
  m_drives.resize(discs);
  m_positions.resize(discs);
  m_isTouching.assign(discs, 0);
  m_isPushed.assign(discs, 0);
}

void CCrowdSolver::Solve(CThreadPool& pool, const CCrowdClusters& clusters,
                         const CDiscPairs& filter, const std::vector<SCrowdLine>& lines,
                         const CContactMemory& pairMemory, const CContactMemory& wallMemory) {
  m_clusters = &clusters;
  m_filter = &filter;
  m_lines = &lines;
  const auto& members = clusters.GetMembers();
  const auto& pairs = clusters.GetPairs();
  m_pairForces.resize(pairs.size());
  m_contacts.resize(pairs.size());
  pool.ParallelFor(pairs.size(), kMemberGrain, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      const UInt32 a = members[pairs[i].A].Number;
      const UInt32 b = members[pairs[i].B].Number;
      m_pairForces[i] = pairMemory.Find(std::min(a, b), std::max(a, b));
    }
  });
  const auto& walls = clusters.GetWalls();
  m_wallForces.resize(walls.size());
  m_wallContacts.resize(walls.size());
  for (size_t i = 0; i < walls.size(); ++i) {
    m_wallForces[i] = wallMemory.Find(members[walls[i].Disc].Number, walls[i].Obstacle);
  }
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
    needed = std::max(
        {needed, std::sqrt(fastest) * tick / (static_cast<float>(kMaxStepShare) * disc.Radius),
         std::abs(drive.TargetW) * tick / static_cast<float>(kMaxStepTurn)});
    weakest = std::min(weakest, drive.InTick);
  }
  if (m_tick.RefineInCrowds) {
    float greatest = 0.0F;  // force, N
    for (UInt32 i = patch.FirstPair; i < patch.EndBorder; ++i) {
      greatest = std::max(greatest, m_pairForces[i].Normal);
    }
    needed = std::max(needed, greatest * tick / (kDrivesOfSubstep * weakest));
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
    StartDrives(number, substep);
    SPatchState& state = m_states[number];
    WarmStart(patch.FirstPair, state.NumContacts);
    WarmStartWalls(patch.FirstWall, state.NumWalls);
    const float tolerance = m_tolerance / substep.Duration;
    for (UInt32 sweep = 0; sweep < kMaxSweeps && SweepPatch(number, sweep) > tolerance; ++sweep) {
    }
    Finish(number, substep);
  }
  for (UInt32 push = 0; push < kMaxPushes; ++push) {
    PushApart(number);
    if (m_states[number].Deepest <= m_deepEnough) {
      break;
    }
  }
}

void CCrowdSolver::SolveLarge(CThreadPool& pool, const SCrowdCluster& cluster) {
  const auto& patches = m_clusters->GetPatches();
  const UInt32 numPatches = cluster.EndPatch - cluster.FirstPatch;
  const auto forPatches = [&](auto&& visit) {
    pool.ParallelFor(numPatches, 1, [&](size_t begin, size_t end, UInt32) {
      for (size_t i = begin; i < end; ++i) {
        visit(cluster.FirstPatch + static_cast<UInt32>(i));
      }
    });
  };
  // the borders after patches 0, 2, ..., then after 1, 3, ...: no two have a patch in common
  const auto forBorders = [&](auto&& visit) {
    for (UInt32 parity = 0; parity < 2; ++parity) {
      pool.ParallelFor((numPatches - parity) / 2, 1, [&](size_t begin, size_t end, UInt32) {
        for (size_t i = begin; i < end; ++i) {
          visit(cluster.FirstPatch + parity + 2 * static_cast<UInt32>(i));
        }
      });
    }
  };
  UInt32 count = 0;
  for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
    count = std::max(count, CountSubsteps(patches[number]));
  }
  SSubstep substep = {static_cast<float>(m_tick.Duration / count), 0, count};
  const float tolerance = m_tolerance / substep.Duration;
  for (; substep.Number < count; ++substep.Number) {
    forPatches([&](UInt32 number) { FindContacts(number, substep); });
    forPatches([&](UInt32 number) {
      StartDrives(number, substep);
      WarmStart(patches[number].FirstPair, m_states[number].NumContacts);
      WarmStartWalls(patches[number].FirstWall, m_states[number].NumWalls);
      m_states[number].IsDue = true;
    });
    forBorders(
        [&](UInt32 number) { WarmStart(patches[number].FirstBorder, m_states[number].NumBorder); });
    bool isDue = true;
    for (UInt32 sweep = 0; sweep < kMaxSweeps && isDue; ++sweep) {
      forPatches([&](UInt32 number) {
        if (m_states[number].IsDue) {
          SweepPatch(number, sweep);
        }
      });
      forBorders([&](UInt32 number) {
        SPatchState& state = m_states[number];
        if (state.IsDue || m_states[number + 1].IsDue) {
          state.BorderChange =
              SweepContacts(patches[number].FirstBorder, state.NumBorder, sweep % 2 != 0);
        }
      });
      isDue = false;
      float before = 0.0F;  // of the border with the patch before
      for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
        SPatchState& state = m_states[number];
        state.IsDue = std::max({before, state.BorderChange, state.Change}) > tolerance;
        before = state.BorderChange;
        isDue = isDue || state.IsDue;
      }
    }
    forPatches([&](UInt32 number) { Finish(number, substep); });
  }
  bool isDeep = true;
  for (UInt32 push = 0; push < kMaxPushes && isDeep; ++push) {
    float before = 0.0F;  // on the border with the patch before
    for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
      SPatchState& state = m_states[number];
      state.IsDue =
          push == 0 || std::max({before, state.Deepest, state.BorderDeepest}) > m_deepEnough;
      before = state.BorderDeepest;
    }
    forPatches([&](UInt32 number) {
      if (m_states[number].IsDue) {
        PushApart(number);
      }
    });
    forBorders([&](UInt32 number) {
      SPatchState& state = m_states[number];
      if (state.IsDue || m_states[number + 1].IsDue) {
        state.BorderDeepest = PushContactsApart(patches[number].FirstBorder, state.NumBorder);
      }
    });
    isDeep = std::any_of(m_states.begin() + cluster.FirstPatch, m_states.begin() + cluster.EndPatch,
                         [this](const SPatchState& state) {
                           return std::max(state.Deepest, state.BorderDeepest) > m_deepEnough;
                         });
  }
}

float CCrowdSolver::SweepPatch(UInt32 number, UInt32 sweep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  float change = SweepDrives(patch.FirstDisc, patch.EndDisc);
  change = std::max(change, SweepContacts(patch.FirstPair, state.NumContacts, sweep % 2 != 0));
  change = std::max(change, SweepWalls(patch.FirstWall, state.NumWalls));
  state.Change = change;
  return change;
}

/****************************************/
// start of a substep
/****************************************/

void CCrowdSolver::FindContacts(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  state.Deepest = 0.0F;
  state.NumContacts = FindContacts(patch.FirstPair, patch.EndPair, substep, state);
  state.NumBorder = FindContacts(patch.FirstBorder, patch.EndBorder, substep, state);
  FindWalls(number, substep);
}

// @return the number of contacts, which begin at the number of the first pair.
UInt32 CCrowdSolver::FindContacts(UInt32 first, UInt32 end, const SSubstep& substep,
                                  SPatchState& state) {
  const Real duration = static_cast<Real>(substep.Duration);
  const Real mostApproach = 2.0 * m_tick.LongestPath / substep.Count;
  const Real touchingGap = kTouchingGap * m_tick.SmallestRadius;
  const Real mostCorrection = kMaxCorrection * m_tick.SmallestRadius;
  UInt32 next = first;
  for (UInt32 i = first; i < end; ++i) {
    const auto& pair = m_clusters->GetPairs()[i];
    const SCrowdPosition& a = m_positions[pair.A];
    const SCrowdPosition& b = m_positions[pair.B];
    const SCrowdDisc& discA = m_discs[pair.A];
    const SCrowdDisc& discB = m_discs[pair.B];
    const Real reach = static_cast<Real>(discA.Radius) + static_cast<Real>(discB.Radius);
    const SStep offset = {b.X - a.X, b.Y - a.Y};
    const Real farthest = reach + mostApproach;
    if (offset.X * offset.X + offset.Y * offset.Y > farthest * farthest) {
      m_pairForces[i] = SContactForce();
      continue;
    }
    const SStep relative = {static_cast<Real>(discB.VX - discA.VX) * duration,
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
      room = std::clamp(kCorrection * (room + m_slop), -mostCorrection, 0.0) / substep.Count;
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
                                           const SStep& step) const {
  const SCrowdPosition& position = m_positions[wall.Disc];
  const Real radius = static_cast<Real>(m_discs[wall.Disc].Radius);
  if (wall.Obstacle < kFirstLine) {
    return SeparateFromFootprint(position.X, position.Y, radius, step,
                                 m_filter->GetObstacle(wall.Obstacle));
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
  const Real mostCorrection = kMaxCorrection * m_tick.SmallestRadius;
  UInt32 next = patch.FirstWall;
  for (UInt32 i = patch.FirstWall; i < patch.EndWall; ++i) {
    const auto& wall = m_clusters->GetWalls()[i];
    const SCrowdDisc& disc = m_discs[wall.Disc];
    const SStep step = {static_cast<Real>(disc.VX) * duration,
                        static_cast<Real>(disc.VY) * duration};
    const SSeparation separation = SeparateFromWall(wall, step);
    Real room = separation.Gap;
    if (room > m_tick.LongestPath / substep.Count) {
      m_wallForces[i] = SContactForce();
      continue;
    }
    if (room < 0.0) {
      state.Deepest = std::max(state.Deepest, static_cast<float>(-room));
      room = std::clamp(kCorrection * (room + m_slop), -mostCorrection, 0.0) / substep.Count;
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

// The drive bounds the impulse in the tick. It exerts an equal share in each substep. But a robot
// that touches nothing may use as much of the bound as it takes to reach its speed at the start of
// the tick: this makes its path an exact arc.
void CCrowdSolver::StartDrives(UInt32 number, const SSubstep& substep) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  const float elapsed = static_cast<float>(substep.Number + 1) / static_cast<float>(substep.Count);
  for (UInt32 i = patch.FirstDisc; i < patch.EndDisc; ++i) {
    SCrowdDrive& drive = m_drives[i];
    const SCrowdDisc& disc = m_discs[i];
    drive.Most = elapsed * drive.InTick - drive.Spent;
    drive.AngularMost = elapsed * drive.AngularInTick - drive.AngularSpent;
    if (m_isTouching[i] == 0) {
      const float x = drive.TargetX - disc.VX;
      const float y = drive.TargetY - disc.VY;
      const float change = std::sqrt(x * x + y * y);
      const float turn = std::abs(drive.TargetW - disc.W);
      drive.Most = std::clamp(kAmple * change / disc.InverseMass, drive.Most,
                              std::max(drive.Most, drive.InTick - drive.Spent));
      drive.AngularMost =
          std::clamp(kAmple * turn / disc.InverseInertia, drive.AngularMost,
                     std::max(drive.AngularMost, drive.AngularInTick - drive.AngularSpent));
    }
    drive.Most = std::max(drive.Most, 0.0F);
    drive.AngularMost = std::max(drive.AngularMost, 0.0F);
    drive.X = drive.Y = drive.Angular = 0.0F;
    m_isTouching[i] = 0;
  }
}

void CCrowdSolver::WarmStart(UInt32 first, UInt32 count) {
  for (UInt32 i = first; i < first + count; ++i) {
    const SContact& contact = m_contacts[i];
    if (contact.Normal == 0.0F) {
      continue;
    }
    SCrowdDisc& a = m_discs[contact.A];
    SCrowdDisc& b = m_discs[contact.B];
    const float x = contact.Normal * contact.NX - contact.Tangent * contact.NY;
    const float y = contact.Normal * contact.NY + contact.Tangent * contact.NX;
    a.VX -= a.InverseMass * x;
    a.VY -= a.InverseMass * y;
    a.W -= a.InverseInertia * a.Radius * contact.Tangent;
    b.VX += b.InverseMass * x;
    b.VY += b.InverseMass * y;
    b.W -= b.InverseInertia * b.Radius * contact.Tangent;
  }
}

void CCrowdSolver::WarmStartWalls(UInt32 first, UInt32 count) {
  for (UInt32 i = first; i < first + count; ++i) {
    const SWallContact& contact = m_wallContacts[i];
    SCrowdDisc& disc = m_discs[contact.Disc];
    disc.VX -= disc.InverseMass * (contact.Normal * contact.NX - contact.Tangent * contact.NY);
    disc.VY -= disc.InverseMass * (contact.Normal * contact.NY + contact.Tangent * contact.NX);
    disc.W -= disc.InverseInertia * disc.Radius * contact.Tangent;
  }
}

/****************************************/
// sweeps; each returns the greatest change of a velocity, m/s
/****************************************/

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

float CCrowdSolver::SolveContact(SContact& contact) {
  SCrowdDisc& a = m_discs[contact.A];
  SCrowdDisc& b = m_discs[contact.B];
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
  const float impulseX = changeN * contact.NX - changeT * contact.NY;
  const float impulseY = changeN * contact.NY + changeT * contact.NX;
  a.VX -= a.InverseMass * impulseX;
  a.VY -= a.InverseMass * impulseY;
  a.W -= a.InverseInertia * a.Radius * changeT;
  b.VX += b.InverseMass * impulseX;
  b.VY += b.InverseMass * impulseY;
  b.W -= b.InverseInertia * b.Radius * changeT;
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
    SCrowdDisc& disc = m_discs[contact.Disc];
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
    disc.VX -= disc.InverseMass * (changeN * contact.NX - changeT * contact.NY);
    disc.VY -= disc.InverseMass * (changeN * contact.NY + changeT * contact.NX);
    disc.W -= disc.InverseInertia * disc.Radius * changeT;
    greatest = std::max(greatest, std::abs(changeN) * disc.InverseMass);
  }
  return greatest;
}

/****************************************/
// end of a substep
/****************************************/

void CCrowdSolver::Finish(UInt32 number, const SSubstep& substep) {
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
    SCrowdPosition& position = m_positions[i];
    position.X += static_cast<Real>(disc.VX) * duration;
    position.Y += static_cast<Real>(disc.VY) * duration;
    position.Turn += static_cast<Real>(disc.W) * duration;
    SCrowdDrive& drive = m_drives[i];
    drive.Spent += std::sqrt(drive.X * drive.X + drive.Y * drive.Y);
    drive.AngularSpent += std::abs(drive.Angular);
  }
}

/****************************************/
// end of the tick: positions only
/****************************************/

// One sweep over a patch, walls last.
void CCrowdSolver::PushApart(UInt32 number) {
  const SCrowdPatch& patch = m_clusters->GetPatches()[number];
  SPatchState& state = m_states[number];
  state.Deepest = PushContactsApart(patch.FirstPair, state.NumContacts);
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
    const Real x = b.X - a.X;
    const Real y = b.Y - a.Y;
    const Real squared = x * x + y * y;
    if (squared >= limit * limit || squared == 0.0) {
      continue;
    }
    const Real distance = std::sqrt(squared);
    const Real depth = reach - distance;
    deepest = std::max(deepest, static_cast<float>(depth));
    const Real share = std::min(depth, kMaxCorrection * m_tick.SmallestRadius) /
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
    const SSeparation separation = SeparateFromWall(wall, SStep());
    if (separation.Gap < -static_cast<Real>(m_tolerance)) {
      deepest = std::max(deepest, static_cast<float>(-separation.Gap));
      const Real push = std::max(separation.Gap, -kMaxCorrection * m_tick.SmallestRadius);
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

void CCrowdSolver::Remember(const CCrowdClusters& clusters, size_t slots,
                            CContactMemory& pairMemory, CContactMemory& wallMemory) const {
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
}

}  // namespace argos
