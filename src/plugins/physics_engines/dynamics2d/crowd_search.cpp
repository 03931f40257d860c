// Islands of bodies that press each other, and the nonsmooth nonlinear conjugate gradient method
// for each, whose steps are the solver's sweeps.

#include <argos3/plugins/simulator/physics_engines/dynamics2d/crowd_solver.h>

#include <argos3/plugins/simulator/physics_engines/dynamics2d/planar_limits.h>

#include <algorithm>

namespace argos {

namespace {

double Square(float value) {
  return static_cast<double>(value) * static_cast<double>(value);
}

template <typename SEARCH, typename CONTACT>
void Keep(SEARCH& search, const CONTACT& contact) {
  search.Normal = contact.Normal;
  search.Tangent = contact.Tangent;
}

template <typename SEARCH, typename CONTACT>
double Measure(const SEARCH& search, const CONTACT& contact, float mass, float tangentMass) {
  return Square(contact.Normal - search.Normal) / static_cast<double>(mass) +
         Square(contact.Tangent - search.Tangent) / static_cast<double>(tangentMass);
}

// Makes the change of a sweep the direction, and adds a share of the direction before. @return by
// which impulses along the normal and the tangent are to be changed.
template <typename SEARCH, typename CONTACT>
std::pair<float, float> Turn(SEARCH& search, CONTACT& contact, float share) {
  const float normal = share * search.StepNormal;
  const float tangent = share * search.StepTangent;
  search.StepNormal = normal + contact.Normal - search.Normal;
  search.StepTangent = tangent + contact.Tangent - search.Tangent;
  contact.Normal += normal;
  contact.Tangent += tangent;
  return {normal, tangent};
}

// @return the share of the last direction that the next one contains: 0, a restart of the method,
// if the energy of the change has grown.
float ComputeShare(double energy, double before) {
  constexpr double kGrowth = 1.02;
  return energy < kGrowth * before ? static_cast<float>(std::min(1.0, energy / before)) : 0.0F;
}

}  // namespace

bool CCrowdSolver::HasTouches(const SCrowdCluster& cluster) const {
  const auto& patches = m_clusters->GetPatches();
  return std::any_of(patches.begin() + cluster.FirstPatch, patches.begin() + cluster.EndPatch,
                     [](const SCrowdPatch& patch) {
                       return patch.Touches.GetSize() + patch.BorderTouches.GetSize() > 0;
                     });
}

/****************************************/
// islands
/****************************************/

// Calls visit(range of contacts, range of touches, range of walls) for those of each patch.
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
          rangeOf(patch.FirstWall, state.NumWalls));
    visit(rangeOf(patch.FirstBorder, state.NumBorder),
          rangeOf(2 * patch.BorderTouches.First, state.NumBorderTouches), SCrowdRange());
  }
}

UInt32 CCrowdSolver::FindIsland(UInt32 member) {
  while (m_islandParent[member] != member) {
    m_islandParent[member] = m_islandParent[m_islandParent[member]];
    member = m_islandParent[member];
  }
  return member;
}

void CCrowdSolver::UniteIslands(UInt32 a, UInt32 b) {
  const UInt32 rootA = FindIsland(a);
  const UInt32 rootB = FindIsland(b);
  m_islandParent[std::max(rootA, rootB)] = std::min(rootA, rootB);
}

// Bodies are in one island if contacts with a force connect them. The contacts of an island are
// those between its bodies, and with what does not move. @return the number of islands, which begin
// at the number of the first member.
UInt32 CCrowdSolver::BuildIslands(const SCrowdCluster& cluster) {
  const auto& patches = m_clusters->GetPatches();
  const UInt32 first = patches[cluster.FirstPatch].FirstDisc;
  const UInt32 end = patches[cluster.EndPatch - 1].EndDisc;
  for (UInt32 member = first; member < end; ++member) {
    m_islandParent[member] = member;
  }
  ForRanges(cluster,
            [this](const SCrowdRange& contacts, const SCrowdRange& touches, const SCrowdRange&) {
              for (UInt32 i = contacts.First; i < contacts.End; ++i) {
                if (m_contacts[i].Normal > 0.0F) {
                  UniteIslands(m_contacts[i].A, m_contacts[i].B);
                }
              }
              for (UInt32 i = touches.First; i < touches.End; ++i) {
                if (m_touches[i].Normal > 0.0F && m_touches[i].B != CCrowdSolids::kNone) {
                  UniteIslands(m_touches[i].A, m_touches[i].B);
                }
              }
            });
  UInt32 next = first;
  for (UInt32 member = first; member < end; ++member) {
    const UInt32 root = FindIsland(member);
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
                           const SCrowdRange& walls) {
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
    });
  };
  forAll([](SCrowdRange& list, const std::vector<UInt32>&, UInt32) { ++list.End; });
  SIsland next = {{patches[cluster.FirstPatch].FirstDisc, 0},
                  {patches[cluster.FirstPatch].FirstPair, 0},
                  {2 * patches[cluster.FirstPatch].Touches.First, 0},
                  {patches[cluster.FirstPatch].FirstWall, 0}};
  for (UInt32 i = first; i < end; ++i) {
    for (SCrowdRange SIsland::*const list :
         {&SIsland::Members, &SIsland::Contacts, &SIsland::Touches, &SIsland::Walls}) {
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

/****************************************/
// the method
/****************************************/

float CCrowdSolver::SweepIsland(const SIsland& island) {
  float change = 0.0F;
  for (UInt32 i = island.Members.First; i < island.Members.End; ++i) {
    change = std::max(change, SweepDrives(m_memberOrder[i], m_memberOrder[i] + 1));
  }
  for (UInt32 i = island.Contacts.First; i < island.Contacts.End; ++i) {
    change = std::max(change, SolveContact(m_contacts[m_contactOrder[i]]));
  }
  for (UInt32 i = island.Touches.First; i < island.Touches.End; ++i) {
    change = std::max(change, SolveTouch(m_touches[m_touchOrder[i]]));
  }
  for (UInt32 i = island.Walls.First; i < island.Walls.End; ++i) {
    change = std::max(change, SweepWalls(m_wallOrder[i], 1));
  }
  return change;
}

void CCrowdSolver::KeepImpulses(const SIsland& island) {
  for (UInt32 i = island.Members.First; i < island.Members.End; ++i) {
    const SCrowdDrive& drive = m_drives[m_memberOrder[i]];
    SDriveSearch& search = m_driveSearches[i];
    search.X = drive.X;
    search.Y = drive.Y;
    search.Angular = drive.Angular;
  }
  for (UInt32 i = island.Contacts.First; i < island.Contacts.End; ++i) {
    Keep(m_contactSearches[i], m_contacts[m_contactOrder[i]]);
  }
  for (UInt32 i = island.Touches.First; i < island.Touches.End; ++i) {
    Keep(m_touchSearches[i], m_touches[m_touchOrder[i]]);
  }
  for (UInt32 i = island.Walls.First; i < island.Walls.End; ++i) {
    Keep(m_wallSearches[i], m_wallContacts[m_wallOrder[i]]);
  }
}

// @return the sum of the squared changes of impulses, each over the mass that resists: an energy,
// so that forces and torques of light and heavy bodies can be added.
double CCrowdSolver::MeasureChange(const SIsland& island) const {
  double energy = 0.0;
  for (UInt32 i = island.Members.First; i < island.Members.End; ++i) {
    const SCrowdDrive& drive = m_drives[m_memberOrder[i]];
    const SCrowdDisc& disc = m_discs[m_memberOrder[i]];
    const SDriveSearch& search = m_driveSearches[i];
    energy += static_cast<double>(disc.InverseMass) *
                  (Square(drive.X - search.X) + Square(drive.Y - search.Y)) +
              static_cast<double>(disc.InverseInertia) * Square(drive.Angular - search.Angular);
  }
  for (UInt32 i = island.Contacts.First; i < island.Contacts.End; ++i) {
    const SContact& contact = m_contacts[m_contactOrder[i]];
    energy += Measure(m_contactSearches[i], contact, contact.Mass, contact.TangentMass);
  }
  for (UInt32 i = island.Touches.First; i < island.Touches.End; ++i) {
    const STouch& touch = m_touches[m_touchOrder[i]];
    energy += Measure(m_touchSearches[i], touch, touch.Mass, touch.TangentMass);
  }
  for (UInt32 i = island.Walls.First; i < island.Walls.End; ++i) {
    const SWallContact& wall = m_wallContacts[m_wallOrder[i]];
    const float mass = 1.0F / m_discs[wall.Disc].InverseMass;
    energy += Measure(m_wallSearches[i], wall, mass, mass);
  }
  return energy;
}

void CCrowdSolver::StepOn(const SIsland& island, float share) {
  for (UInt32 i = island.Members.First; i < island.Members.End; ++i) {
    SCrowdDrive& drive = m_drives[m_memberOrder[i]];
    SCrowdDisc& disc = m_discs[m_memberOrder[i]];
    SDriveSearch& search = m_driveSearches[i];
    const float x = share * search.StepX;
    const float y = share * search.StepY;
    const float angular = share * search.StepAngular;
    search.StepX = x + drive.X - search.X;
    search.StepY = y + drive.Y - search.Y;
    search.StepAngular = angular + drive.Angular - search.Angular;
    drive.X += x;
    drive.Y += y;
    drive.Angular += angular;
    disc.VX += disc.InverseMass * x;
    disc.VY += disc.InverseMass * y;
    disc.W += disc.InverseInertia * angular;
  }
  const auto stepOn = [&](auto& searches, auto& contacts, const std::vector<UInt32>& order,
                          const SCrowdRange& range) {
    for (UInt32 i = range.First; i < range.End; ++i) {
      auto& contact = contacts[order[i]];
      const auto [normal, tangent] = Turn(searches[i], contact, share);
      ApplyImpulse(contact, normal, tangent);
    }
  };
  stepOn(m_contactSearches, m_contacts, m_contactOrder, island.Contacts);
  stepOn(m_touchSearches, m_touches, m_touchOrder, island.Touches);
  stepOn(m_wallSearches, m_wallContacts, m_wallOrder, island.Walls);
}

// The last thing is a sweep, so that no impulse exceeds its bounds.
void CCrowdSolver::IterateIsland(const SIsland& island, float tolerance) {
  const UInt32 contacts =
      island.Contacts.GetSize() + island.Touches.GetSize() + island.Walls.GetSize();
  if (contacts == 0) {
    return;
  }
  double before = 0.0;
  for (UInt32 sweep = 0; sweep < kMaxTouchSweeps; ++sweep) {
    KeepImpulses(island);
    if (SweepIsland(island) <= tolerance) {
      break;
    }
    const double energy = MeasureChange(island);
    if (sweep + 1 < kMaxTouchSweeps) {
      StepOn(island, ComputeShare(energy, before));
    }
    before = energy;
  }
}

// Sweeps over everything find which contacts have a force, and that nothing is left to solve.
void CCrowdSolver::IterateSmall(UInt32 number, float tolerance) {
  for (UInt32 round = 0; round < kMaxIslandRounds && SweepPatch(number, 0) > tolerance; ++round) {
    const UInt32 first = m_clusters->GetPatches()[number].FirstDisc;
    const UInt32 count = BuildIslands({number, number + 1});
    for (UInt32 i = first; i < first + count; ++i) {
      IterateIsland(m_islands[i], 0.5F * tolerance);
    }
  }
}

void CCrowdSolver::IterateLarge(CThreadPool& pool, const SCrowdCluster& cluster, float tolerance) {
  const UInt32 first = m_clusters->GetPatches()[cluster.FirstPatch].FirstDisc;
  for (UInt32 round = 0; round < kMaxIslandRounds && SweepLarge(pool, cluster, 0, tolerance);
       ++round) {
    const UInt32 count = BuildIslands(cluster);
    pool.ParallelFor(count, kIslandGrain, [&](size_t begin, size_t end, UInt32) {
      for (size_t i = first + begin; i < first + end; ++i) {
        IterateIsland(m_islands[i], 0.5F * tolerance);
      }
    });
    for (UInt32 number = cluster.FirstPatch; number < cluster.EndPatch; ++number) {
      m_states[number].IsDue = true;
    }
  }
}

}  // namespace argos
