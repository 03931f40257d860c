// Islands of bodies that press each other: which they are, and what they consist of.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>
#include <functional>

namespace argos {

bool CCrowdSolver::HasPatch(const SCrowdCluster& cluster,
                            bool (SCrowdPatch::*property)() const) const {
  const auto& patches = m_clusters->GetPatches();
  return std::any_of(patches.begin() + cluster.FirstPatch, patches.begin() + cluster.EndPatch,
                     std::mem_fn(property));
}

// Calls visit(ranges of contacts, touches, walls and grips) for those of each patch.
template <typename VISIT>
void CCrowdSolver::ForRanges(const SCrowdCluster& cluster, VISIT&& visit) const {
  for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
    const SCrowdPatch& patch = m_clusters->GetPatches()[number];
    const SPatchState& state = m_states[number];
    const auto rangeOf = [](UInt32 first, UInt32 count) {
      return SCrowdRange{first, first + count};
    };
    visit(rangeOf(patch.FirstPair, state.NumContacts),
          rangeOf(2 * patch.Touches.First, state.NumTouches),
          rangeOf(patch.FirstWall, state.NumWalls), patch.Grips);
    visit(rangeOf(patch.FirstBorder, state.NumBorder),
          rangeOf(2 * patch.BorderTouches.First, state.NumBorderTouches), SCrowdRange(),
          patch.BorderGrips);
  }
}

// Bodies are in one island if grips or contacts with a force connect them. The contacts of an
// island are those between its bodies, and with what does not move. @return the number of islands,
// which begin at the number of the first member.
UInt32 CCrowdSolver::BuildIslands(const SCrowdCluster& cluster) {
  const auto& patches = m_clusters->GetPatches();
  const UInt32 first = patches[cluster.FirstPatch].FirstDisc;
  const UInt32 end = patches[cluster.EndPatch - 1].EndDisc;
  for (UInt32 member = first; member < end; ++member) {
    m_islandParent[member] = member;
  }
  ForRanges(cluster, [this](const SCrowdRange& contacts, const SCrowdRange& touches,
                            const SCrowdRange&, const SCrowdRange& grips) {
    for (UInt32 i = grips.First; i < grips.End; ++i) {
      Connect(m_islandParent, m_grips[i].A, m_grips[i].B);
    }
    for (UInt32 i = contacts.First; i < contacts.End; ++i) {
      if (m_contacts[i].Normal > 0.0F) {
        Connect(m_islandParent, m_contacts[i].A, m_contacts[i].B);
      }
    }
    for (UInt32 i = touches.First; i < touches.End; ++i) {
      if (m_touches[i].Normal > 0.0F && m_touches[i].B != CCrowdSolids::kNone) {
        Connect(m_islandParent, m_touches[i].A, m_touches[i].B);
      }
    }
  });
  UInt32 next = first;
  for (UInt32 member = first; member < end; ++member) {
    const UInt32 root = FindRootOf(m_islandParent, member);
    m_islandOf[member] = root == member ? next++ : m_islandOf[root];
  }
  SortIntoIslands(cluster, first, next);
  return next - first;
}

// Lists what belongs to each island, in order.
void CCrowdSolver::SortIntoIslands(const SCrowdCluster& cluster, UInt32 first, UInt32 end) {
  std::fill(m_islands.begin() + first, m_islands.begin() + end, SIsland());
  const auto& patches = m_clusters->GetPatches();
  const auto islandOf = [this](UInt32 a, UInt32 b) {
    return b == CCrowdSolids::kNone || m_islandOf[a] == m_islandOf[b] ? &m_islands[m_islandOf[a]]
                                                                      : nullptr;
  };
  // visit(list of an island, list of all, number) for everything
  const auto forAll = [&](auto&& visit) {
    for (UInt32 i = patches[cluster.FirstPatch].FirstDisc;
         i < patches[cluster.EndPatch - 1].EndDisc; ++i) {
      visit(m_islands[m_islandOf[i]].Members, m_memberOrder, i);
    }
    ForRanges(cluster, [&](const SCrowdRange& contacts, const SCrowdRange& touches,
                           const SCrowdRange& walls, const SCrowdRange& grips) {
      for (UInt32 i = contacts.First; i < contacts.End; ++i) {
        if (SIsland* const island = islandOf(m_contacts[i].A, m_contacts[i].B)) {
          visit(island->Contacts, m_contactOrder, i);
        }
      }
      for (UInt32 i = touches.First; i < touches.End; ++i) {
        if (SIsland* const island = islandOf(m_touches[i].A, m_touches[i].B)) {
          visit(island->Touches, m_touchOrder, i);
        }
      }
      for (UInt32 i = walls.First; i < walls.End; ++i) {
        visit(m_islands[m_islandOf[m_wallContacts[i].Disc]].Walls, m_wallOrder, i);
      }
      for (UInt32 i = grips.First; i < grips.End; ++i) {
        visit(m_islands[m_islandOf[m_grips[i].A]].Grips, m_gripOrder, i);
      }
    });
  };
  forAll([](SCrowdRange& list, const std::vector<UInt32>&, UInt32) { ++list.End; });
  SIsland next = {{patches[cluster.FirstPatch].FirstDisc, 0},
                  {patches[cluster.FirstPatch].FirstPair, 0},
                  {2 * patches[cluster.FirstPatch].Touches.First, 0},
                  {patches[cluster.FirstPatch].FirstWall, 0},
                  patches[cluster.FirstPatch].Grips};
  for (UInt32 i = first; i < end; ++i) {
    for (SCrowdRange SIsland::*const list : {&SIsland::Members, &SIsland::Contacts,
                                             &SIsland::Touches, &SIsland::Walls, &SIsland::Grips}) {
      SCrowdRange& range = m_islands[i].*list;
      const UInt32 count = range.End;
      range.First = range.End = (next.*list).First;
      (next.*list).First += count;
    }
  }
  forAll([](SCrowdRange& list, std::vector<UInt32>& order, UInt32 number) {
    order[list.End++] = number;
  });
}

std::span<CCrowdSolver::SBody> CCrowdSolver::CopyBodies(UInt32 number) {
  const SCrowdRange& members = m_islands[number].Members;
  // behind those of the islands before, each of which has something immovable as well
  SBody* const bodies = m_islandBodies.data() + members.First + number;
  for (UInt32 i = members.First; i < members.End; ++i) {
    const UInt32 member = m_memberOrder[i];
    const SCrowdDisc& disc = m_discs[member];
    const SCrowdDrive& drive = m_drives[member];
    SBody& body = bodies[i - members.First] = SBody();
    m_islandPlace[member] = i - members.First;
    body.Velocity.Set({disc.VX, disc.VY, disc.W});
    body.Impulse.Set({drive.X, drive.Y, drive.Angular});
    body.Target[kAxisX] = drive.TargetX;
    body.Target[kAxisY] = drive.TargetY;
    body.Target[kAxisTurn] = drive.TargetW;
    body.Most = drive.Most;
    body.AngularMost = drive.AngularMost;
    body.InverseMass = disc.InverseMass;
    body.InverseInertia = disc.InverseInertia;
    body.Mass = 1.0F / disc.InverseMass;
    body.Inertia = 1.0F / disc.InverseInertia;
  }
  bodies[members.GetSize()] = SBody();
  return {bodies, members.GetSize() + 1};
}

// Calls visit(contact of the solver, contact of the island) for all, in order.
template <typename VISIT>
std::span<CCrowdSolver::SCopy> CCrowdSolver::ForContacts(const SIsland& island, VISIT&& visit) {
  SCopy* const first =
      m_islandContacts.data() + island.Contacts.First + island.Touches.First + island.Walls.First;
  SCopy* next = first;
  const auto forAll = [&](const SCrowdRange& range, const std::vector<UInt32>& order,
                          auto& contacts) {
    for (UInt32 i = range.First; i < range.End; ++i) {
      visit(contacts[order[i]], *next++);
    }
  };
  forAll(island.Contacts, m_contactOrder, m_contacts);
  forAll(island.Touches, m_touchOrder, m_touches);
  forAll(island.Walls, m_wallOrder, m_wallContacts);
  return {first, next};
}

void CCrowdSolver::CopyContact(const SContact& contact, SCopy& copy) const {
  copy.A = m_islandPlace[contact.A];
  copy.B = m_islandPlace[contact.B];
  copy.TangentLeverA = m_discs[contact.A].Radius;
  copy.TangentLeverB = -m_discs[contact.B].Radius;
  copy.Mass = contact.Mass;
  copy.TangentMass = contact.TangentMass;
  copy.Friction = kDiscFriction;
}

void CCrowdSolver::CopyContact(const STouch& contact, SCopy& copy) const {
  copy.A = m_islandPlace[contact.A];
  copy.B = contact.B != CCrowdSolids::kNone ? m_islandPlace[contact.B] : kNoPlace;
  copy.NormalLeverA = contact.NormalLeverA;
  copy.TangentLeverA = contact.TangentLeverA;
  copy.NormalLeverB = contact.NormalLeverB;
  copy.TangentLeverB = contact.TangentLeverB;
  copy.Mass = contact.Mass;
  copy.TangentMass = contact.TangentMass;
  copy.Friction = contact.Friction;
}

void CCrowdSolver::CopyContact(const SWallContact& contact, SCopy& copy) const {
  const SCrowdDisc& disc = m_discs[contact.Disc];
  copy.A = m_islandPlace[contact.Disc];
  copy.B = kNoPlace;
  copy.TangentLeverA = disc.Radius;
  copy.Mass = 1.0F / disc.InverseMass;
  copy.TangentMass = 1.0F / (disc.InverseMass + disc.InverseInertia * disc.Radius * disc.Radius);
  copy.Friction = contact.Friction;
}

void CCrowdSolver::SolveIsland(UInt32 number, float tolerance) {
  const SIsland& island = m_islands[number];
  const UInt32 numGrips = island.Grips.GetSize();
  if (island.Contacts.GetSize() + island.Touches.GetSize() + island.Walls.GetSize() + numGrips ==
      0) {
    return;
  }
  const std::span<SBody> bodies = CopyBodies(number);
  const auto contacts = ForContacts(island, [&](const auto& contact, SCopy& copy) {
    copy = SCopy();
    CopyContact(contact, copy);
    copy.B = std::min<UInt32>(copy.B, island.Members.GetSize());
    copy.NX = contact.NX;
    copy.NY = contact.NY;
    copy.Approach = contact.Approach;
    copy.InverseMass = 1.0F / copy.Mass;
    copy.InverseTangentMass = 1.0F / copy.TangentMass;
    copy.Impulse.Set({contact.Normal, contact.Tangent});
  });
  const std::span<SGrip> grips(m_islandGrips.data() + island.Grips.First, numGrips);
  for (UInt32 i = 0; i < numGrips; ++i) {
    grips[i] = m_grips[m_gripOrder[island.Grips.First + i]];
    grips[i].A = m_islandPlace[grips[i].A];
    grips[i].B = m_islandPlace[grips[i].B];
  }
  CContactIsland(bodies, contacts, grips)
      .Solve(numGrips > 0 ? kGripTolerance * tolerance : tolerance, kMaxTouchSweeps);
  for (UInt32 i = 0; i < numGrips; ++i) {
    SGrip& grip = m_grips[m_gripOrder[island.Grips.First + i]];
    grip.Impulse = grips[i].Impulse;
    grip.ArmRate = grips[i].ArmRate;
  }
  for (UInt32 i = 0; i < island.Members.GetSize(); ++i) {
    const UInt32 member = m_memberOrder[island.Members.First + i];
    SCrowdDisc& disc = m_discs[member];
    SCrowdDrive& drive = m_drives[member];
    const float* const velocity = bodies[i].Velocity.Now;
    const float* const impulse = bodies[i].Impulse.Now;
    disc.VX = velocity[kAxisX];
    disc.VY = velocity[kAxisY];
    disc.W = velocity[kAxisTurn];
    drive.X = impulse[kAxisX];
    drive.Y = impulse[kAxisY];
    drive.Angular = impulse[kAxisTurn];
  }
  ForContacts(island, [](auto& contact, const SCopy& copy) {
    contact.Normal = copy.Impulse.Now[kAxisNormal];
    contact.Tangent = copy.Impulse.Now[kAxisTangent];
  });
}

// Sweeps over everything find which contacts have a force, and that nothing is left to solve. Grips
// have a tolerance of their own, so that their islands are solved in any case.
void CCrowdSolver::IterateSmall(UInt32 number, float tolerance) {
  const bool hasGrips = m_clusters->GetPatches()[number].HasGrips();
  for (UInt32 round = 0; round < kMaxIslandRounds; ++round) {
    const bool isSolved = SweepPatch(number, 0) <= tolerance;
    if (isSolved && (round > 0 || !hasGrips)) {
      break;
    }
    const UInt32 first = m_clusters->GetPatches()[number].FirstDisc;
    const UInt32 count = BuildIslands({number, number + 1});
    for (UInt32 i = first; i < first + count; ++i) {
      SolveIsland(i, 0.5F * tolerance);
    }
  }
}

void CCrowdSolver::IterateLarge(CThreadPool& pool, const SCrowdCluster& cluster, float tolerance) {
  const UInt32 first = m_clusters->GetPatches()[cluster.FirstPatch].FirstDisc;
  const bool hasGrips = HasPatch(cluster, &SCrowdPatch::HasGrips);
  for (UInt32 round = 0; round < kMaxIslandRounds; ++round) {
    const bool isSolved = !SweepLarge(pool, cluster, 0, tolerance);
    if (isSolved && (round > 0 || !hasGrips)) {
      break;
    }
    const UInt32 count = BuildIslands(cluster);
    pool.ParallelFor(count, kIslandGrain, [&](size_t begin, size_t end, UInt32) {
      for (size_t i = first + begin; i < first + end; ++i) {
        SolveIsland(static_cast<UInt32>(i), 0.5F * tolerance);
      }
    });
    for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
      m_states[number].IsDue = true;
    }
  }
}

}  // namespace argos
