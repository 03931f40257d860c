// The steps of the robots that may touch something: the active discs.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/disc_swarm.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>
#include <argos3/plugins/simulator/physics_engines/planar/separation.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

// active discs in a chunk of work of a thread
constexpr size_t kActiveGrain = 128;
// ids of half planes: first the numbers of discs, then those of walls, of solids and of ghosts
constexpr UInt32 kFirstWall = 1U << 30;
constexpr UInt32 kFirstSolid = 2U << 30;
constexpr UInt32 kFirstGhost = 3U << 30;
// greatest distance to the target, as a share of the step, that is due to rounding
constexpr Real kArrived = 1e-12;
// smallest share of its path that a robot tries if there are too many obstacles near the whole path
constexpr Real kMinShare = 1e-3;
constexpr UInt8 kNoRound = 255;
static_assert(kMaxRounds < kNoRound);

bool IsWithinReach(const CCellLists& lists, UInt32 cell, Real x, Real y, Real reach) {
  if (lists.IsEmpty()) {
    return false;
  }
  for (const UInt32 number : lists.Get(cell)) {
    if (ComputeDistance(lists.GetFootprint(number), x, y) <= reach) {
      return true;
    }
  }
  return false;
}

// The part of a gap that one of two bodies may use, so that both together never exceed it. An
// unclaimed part goes to the other body.
Real ShareGap(Real gap, Real mine, Real other) {
  const Real both = mine + other;
  if (both <= gap) {
    return mine + 0.5 * (gap - both);
  }
  return gap * (mine / both);
}

}  // namespace

Real CDiscSwarm::ComputeGhostReach(Real tick, UInt32 substeps) const {
  Real farthest = 0.0;
  for (size_t slot = 0; slot < GetSize(); ++slot) {
    const Real radius = m_radius[slot];
    const Real speed = m_drives[slot].Read().ComputeSpeed();
    const Real planned = std::fmax(speed, ReadLastCommand(slot).ComputeSpeed()) * tick;
    // Plan() reports speeds that are not numbers
    const Real path = std::fmin(planned, substeps * kMaxStep * radius);
    farthest =
        std::max(farthest, radius + 2.0 * (path + m_allowance[slot] + (substeps - 1) * radius));
  }
  return farthest + 2.0 * substeps * kMaxRounding;
}

// Finds the discs that may come half-way to a ghost in this tick: in each substep a disc moves by
// at most its reach minus its radius, and after the first by up to a radius more if it overlaps.
void CDiscSwarm::FindGhosts(std::span<const SGhostDisc> ghosts, UInt32 substeps) {
  m_ghostLines.Clear(GetSize());
  const Real widest = static_cast<Real>(m_maxReach.load(std::memory_order_relaxed));
  for (UInt32 number = 0; number < ghosts.size(); ++number) {
    const SGhostDisc& ghost = ghosts[number];
    ForDiscsNear(
        ghost.X, ghost.Y, ghost.Radius + (2.0 * substeps - 1.0) * widest, [&](UInt32 slot) {
          const Real reach =
              ghost.Radius - m_radius[slot] + 2.0 * substeps * static_cast<Real>(m_reach[slot]);
          const Real dx = m_x[slot] - ghost.X;
          const Real dy = m_y[slot] - ghost.Y;
          if (dx * dx + dy * dy <= reach * reach) {
            m_ghostLines.Add(slot, m_x[slot], m_y[slot], m_radius[slot], number, ghost);
          }
        });
  }
  m_ghostLines.Sort();
}

void CDiscSwarm::Step(CThreadPool& pool, const CCellLists& walls, const CCellLists& solids) {
  if (GetSize() == 0) {
    return;
  }
  CheckPlaces();
  m_targets.resize(GetSize());
  m_done.resize(GetSize());
  m_next.resize(GetSize());
  for (std::vector<UInt8>& rounds : m_movedIn) {
    rounds.resize(GetSize());
  }
  ReserveActive(GetSize());
  if (m_period.IsOn()) {
    FindSeamPairs();
  }
  m_numActive.store(0, std::memory_order_relaxed);
  const UInt32 stride = m_grid.GetStride();
  // without the border of empty cells
  pool.ParallelFor(m_grid.GetNumCells() - 2 * stride, kCellGrain,
                   [&](size_t begin, size_t end, UInt32) {
                     FindActive(begin + stride, end + stride, walls, solids);
                   });
  // discs at their targets are moved behind the remaining ones
  size_t numLeft = m_numActive.load(std::memory_order_relaxed);
  bool hasProgress = true;
  for (UInt8 round = 0; round < kMaxRounds && numLeft > 0 && hasProgress; ++round) {
    hasProgress = StepRound(pool, round, numLeft, walls, solids);
    numLeft = DropArrived(numLeft);
  }
  pool.ParallelFor(numLeft, kActiveGrain, [this](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      Finish(m_activeDiscs[i]);
    }
  });
}

// Each pair once. Discs near a seam are few.
void CDiscSwarm::FindSeamPairs() {
  m_seamPairs.Clear(m_places.size());
  for (UInt32 place = 0; place < m_places.size(); ++place) {
    const SPlace& disc = m_places[place];
    const Real reach = static_cast<Real>(disc.Reach);
    ForImages(disc.X, disc.Y, reach, [&](Real dx, Real dy) {
      if (dx == 0.0 && dy == 0.0) {
        return;
      }
      ForPlacesHere(disc.X + dx, disc.Y + dy, reach, [&](UInt32 other) {
        if (place < other) {
          m_seamPairs.Add(place, other);
        }
      });
    });
  }
  m_seamPairs.Sort();
}

// Advances active discs [0, numLeft). @return true if any of them moved.
bool CDiscSwarm::StepRound(CThreadPool& pool, UInt8 round, size_t numLeft, const CCellLists& walls,
                           const CCellLists& solids) {
  std::atomic<bool> hasProgress{false};
  pool.ParallelFor(numLeft, kActiveGrain, [&](size_t begin, size_t end, UInt32) {
    bool moved = false;
    for (size_t i = begin; i < end; ++i) {
      SActiveDisc& active = m_activeDiscs[i];
      if (!MayMove(active, round)) {
        m_next[active.Place] = m_done[active.Place];
      } else if (StepOne(active, walls, solids, m_done, m_next)) {
        m_movedIn[round % 2][active.Place] = round;
        moved = true;
      }
    }
    if (moved) {
      hasProgress.store(true, std::memory_order_relaxed);
    }
  });
  m_done.swap(m_next);
  return hasProgress.load(std::memory_order_relaxed);
}

// Moves the discs of [0, numLeft) that are at their targets behind the others. @return the number
// of the others.
size_t CDiscSwarm::DropArrived(size_t numLeft) {
  for (size_t i = 0; i < numLeft;) {
    SActiveDisc& active = m_activeDiscs[i];
    if (active.HasArrived) {
      m_next[active.Place] = m_done[active.Place];
      std::swap(active, m_activeDiscs[--numLeft]);
    } else {
      ++i;
    }
  }
  return numLeft;
}

// A disc that did not move in the last round, like all discs that it may touch, would not move now.
bool CDiscSwarm::MayMove(const SActiveDisc& active, UInt8 round) const {
  if (round == 0) {
    return true;
  }
  const UInt8 last = round - 1;
  const std::vector<UInt8>& movedIn = m_movedIn[last % 2];
  return movedIn[active.Place] == last ||
         ForPlacesNear(active, [&](UInt32 other) { return movedIn[other] == last; });
}

// Calls visit(place) for the discs in a cell and its neighbours until it returns true. @return true
// if it did.
template <typename VISIT>
bool CDiscSwarm::ForPlacesAround(UInt32 cell, VISIT&& visit) const {
  const UInt32 stride = m_grid.GetStride();
  for (UInt32 row = cell - stride; row <= cell + stride; row += stride) {
    const UInt32 end = m_sort.End(row + 1);
    for (UInt32 place = m_sort.Begin(row - 1); place < end; ++place) {
      if (visit(place)) {
        return true;
      }
    }
  }
  return false;
}

// The same for the discs that an active one may touch in this tick, without itself.
template <typename VISIT>
bool CDiscSwarm::ForPlacesNear(const SActiveDisc& active, VISIT&& visit) const {
  if (m_seamPairs.ForPartners(active.Place, visit)) {
    return true;
  }
  if (active.NumNear <= SActiveDisc::kMaxNear) {
    return std::any_of(active.Near, active.Near + active.NumNear, visit);
  }
  const SPlace& disc = PlaceOf(active);
  return ForPlacesAround(active.Cell, [&](UInt32 other) {
    return other != active.Place && MayTouch(disc, m_places[other]) && visit(other);
  });
}

void CDiscSwarm::FindNear(SActiveDisc& active) const {
  const SPlace& disc = m_places[active.Place];
  active.NumNear = 0;
  ForPlacesAround(active.Cell, [&](UInt32 other) {
    if (MayTouch(disc, m_places[other]) && other != active.Place) {
      if (active.NumNear == SActiveDisc::kMaxNear) {
        ++active.NumNear;
        return true;
      }
      active.Near[active.NumNear++] = other;
    }
    return false;
  });
}

bool CDiscSwarm::MayTouchAny(const SActiveDisc& active, const CCellLists& walls,
                             const CCellLists& solids) const {
  const SPlace& disc = m_places[active.Place];
  const Real reach = static_cast<Real>(disc.Reach);
  return active.NumNear > 0 || m_ghostLines.Has(disc.Slot) || m_seamPairs.Has(active.Place) ||
         IsWithinReach(walls, active.Cell, disc.X, disc.Y, reach) ||
         IsWithinReach(solids, active.Cell, disc.X, disc.Y, reach);
}

void CDiscSwarm::FindActive(size_t beginCell, size_t endCell, const CCellLists& walls,
                            const CCellLists& solids) {
  std::array<SActiveDisc, 64> found;
  UInt32 numFound = 0;
  const auto flush = [&] {
    const UInt32 first = m_numActive.fetch_add(numFound, std::memory_order_relaxed);
    std::copy_n(found.begin(), numFound, m_activeDiscs.get() + first);
    numFound = 0;
  };
  for (size_t i = beginCell; i < endCell; ++i) {
    const UInt32 cell = static_cast<UInt32>(i);
    for (UInt32 place = m_sort.Begin(cell); place < m_sort.End(cell); ++place) {
      SActiveDisc& active = found[numFound];
      active.Place = place;
      active.Cell = cell;
      active.HasArrived = false;
      FindNear(active);
      if (!MayTouchAny(active, walls, solids)) {
        continue;
      }
      const SPlace& disc = m_places[place];
      const UInt32 slot = disc.Slot;
      m_targets[place] = {{m_stepX[slot], m_stepY[slot]}, m_radius[slot], 0.0};
      m_done[place] = SPlanarVector{};
      m_movedIn[0][place] = m_movedIn[1][place] = kNoRound;
      if (++numFound == found.size()) {
        flush();
      }
    }
  }
  flush();
}

// Computes one round's step of a robot. @return true if it moves.
bool CDiscSwarm::StepOne(SActiveDisc& active, const CCellLists& walls, const CCellLists& solids,
                         const std::vector<SPlanarVector>& done, std::vector<SPlanarVector>& next) {
  STarget& target = m_targets[active.Place];
  const SPlanarVector& here = done[active.Place];
  const SPlanarVector missing = target.Step - here;
  const Real length = std::sqrt(SquareLength(missing));
  const Real path = PathOf(PlaceOf(active), target);
  const bool mayBePushed = path > std::sqrt(SquareLength(target.Step)) + 1e-6;
  CHalfPlanes planes;
  SPlanarVector goal = {};
  Real share = 1.0;
  // obstacles beyond the path are left out; if there are too many, the path is shortened
  for (bool fits = false; !fits && share > kMinShare; share *= 0.25) {
    const Real bound = share * (length + (mayBePushed ? path : 0.0));
    planes.Clear();
    target.Depth = 0.0;
    fits = LimitByDiscs(active, done, bound, planes) &&
           LimitByFootprints(active, walls, kFirstWall, here, bound, planes) &&
           LimitByFootprints(active, solids, kFirstSolid, here, bound, planes) &&
           LimitByGhosts(active, here, bound, planes);
    // sums depend on the order because of rounding, and the order of the discs on threads
    planes.Sort();
    const SPlanarVector push = planes.SumPushes();
    goal = share * missing + push;
    const Real goalLength = std::sqrt(SquareLength(goal));
    if (!fits || goalLength > bound) {
      const Real scale = fits && goalLength > 0.0 ? bound / goalLength : 0.0;
      goal = scale * goal;
    }
  }
  SPlanarVector step = planes.FindNearest(goal);
  // obstacles were only considered within the path
  const Real room = path - std::sqrt(SquareLength(here));
  const Real stepLength = std::sqrt(SquareLength(step));
  if (SquareLength(here + step) > path * path && stepLength > 0.0) {
    const Real scale = std::max(0.0, room / stepLength);
    step = scale * step;
  }
  next[active.Place] = here + step;
  const SPlanarVector left = target.Step - next[active.Place];
  active.HasArrived =
      target.Depth == 0.0 && SquareLength(left) <= kArrived * kArrived * SquareLength(target.Step);
  return stepLength > kNegligibleStep * target.Radius;
}

bool CDiscSwarm::LimitByDiscs(const SActiveDisc& active, const std::vector<SPlanarVector>& done,
                              Real bound, CHalfPlanes& planes) {
  STarget& target = m_targets[active.Place];
  const SPlace& disc = PlaceOf(active);
  const SPlanarVector& here = done[active.Place];
  const SPlanarVector missing = target.Step - here;
  return !ForPlacesNear(active, [&](UInt32 other) {
    const SPlace& neighbour = m_places[other];
    const SPlanarVector start = {m_period.X.Shorten(neighbour.X - disc.X),
                                 m_period.Y.Shorten(neighbour.Y - disc.Y)};
    const STarget& otherTarget = m_targets[other];
    const SPlanarVector& there = done[other];
    const SPlanarVector missingThere = otherTarget.Step - there;
    const SPlanarVector offset = start + (there - here);
    SSeparation separation =
        SeparateDiscs(offset, missingThere - missing, target.Radius + otherTarget.Radius);
    if (offset.X == 0.0 && offset.Y == 0.0 && disc.Slot > neighbour.Slot) {
      separation.NormalX = -separation.NormalX;
    }
    const Real mine = std::max(0.0, Dot(separation.GetNormal(), missing));
    const Real theirs = std::max(0.0, -Dot(separation.GetNormal(), missingThere));
    Real push = 0.0;
    if (separation.Gap < -kMaxRounding) {
      // also what the robot drives into the other: they would stay in each other by that much
      push = mine - 0.5 * separation.Gap;
      target.Depth = std::max(target.Depth, -separation.Gap);
    }
    const Real limit = ShareGap(std::max(0.0, separation.Gap), mine, theirs);
    return limit < bound && !planes.Add({separation.GetNormal(), limit, neighbour.Slot, push});
  });
}

bool CDiscSwarm::LimitByFootprints(const SActiveDisc& active, const CCellLists& lists,
                                   UInt32 firstId, const SPlanarVector& done, Real bound,
                                   CHalfPlanes& planes) {
  if (lists.IsEmpty()) {
    return true;
  }
  STarget& target = m_targets[active.Place];
  const SPlace& disc = PlaceOf(active);
  const Real x = disc.X + done.X;
  const Real y = disc.Y + done.Y;
  const SPlanarVector missing = target.Step - done;
  for (const UInt32 number : lists.Get(active.Cell)) {
    const SFootprint& footprint = lists.GetFootprint(number);
    if (ComputeDistance(footprint, x, y) - target.Radius >= bound) {
      continue;
    }
    const SSeparation separation = SeparateFromFootprint(x, y, target.Radius, missing, footprint);
    Real push = 0.0;
    if (separation.Gap < -kMaxRounding) {
      // a wall undoes what the robot drives into it, too: it would stay inside by that much
      const Real ahead = firstId != kFirstWall ? 0.0 : Dot(separation.GetNormal(), missing);
      push = -separation.Gap + std::max(0.0, ahead);
      target.Depth = std::max(target.Depth, -separation.Gap);
    }
    const Real limit = std::max(0.0, separation.Gap);
    if (limit < bound && !planes.Add({separation.GetNormal(), limit, firstId + number, push})) {
      return false;
    }
  }
  return true;
}

bool CDiscSwarm::LimitByGhosts(const SActiveDisc& active, const SPlanarVector& done, Real bound,
                               CHalfPlanes& planes) {
  STarget& target = m_targets[active.Place];
  const SPlace& disc = PlaceOf(active);
  for (const SGhostLine& line : m_ghostLines.Get(disc.Slot)) {
    const SPlanarVector moved = SPlanarVector{disc.X, disc.Y} - line.Start + done;
    const Real room = line.Room - line.Normal.X * moved.X - line.Normal.Y * moved.Y;
    Real push = 0.0;
    if (room < -kMaxRounding) {
      push = -room;
      target.Depth = std::max(target.Depth, -room);
    }
    const Real limit = std::max(0.0, room);
    if (limit < bound && !planes.Add({line.Normal, limit, kFirstGhost + line.Ghost, push})) {
      return false;
    }
  }
  return true;
}

// Writes the result of a disc that has not reached its target.
void CDiscSwarm::Finish(const SActiveDisc& active) {
  const STarget& target = m_targets[active.Place];
  const SPlace& disc = PlaceOf(active);
  const SPlanarVector& done = m_done[active.Place];
  m_nextX[disc.Slot] = disc.X + done.X;
  m_nextY[disc.Slot] = disc.Y + done.Y;
  m_allowance[disc.Slot] = std::min(target.Depth, target.Radius);
}

}  // namespace argos
