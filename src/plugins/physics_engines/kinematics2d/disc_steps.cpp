// What is in the robots' way: who may meet something, and how far these get.

#include <argos3/plugins/simulator/physics_engines/kinematics2d/disc_swarm.h>

#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/kinematic_limits.h>
#include <argos3/plugins/simulator/physics_engines/kinematics2d/separation.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace argos {

namespace {

// robots in each other's way that a thread works on in a row
constexpr size_t kMoverGrain = 128;
// the numbers of discs come first among half planes, then those of walls, of solids and of ghosts
constexpr UInt32 kFirstWall = 1U << 30;
constexpr UInt32 kFirstSolid = 2U << 30;
constexpr UInt32 kFirstGhost = 3U << 30;
// what is missing to where a robot wants to be, in shares of its step, if only roundings are
constexpr Real kArrived = 1e-12;
// of its way, that a robot tries to go if too much is in reach of more of it
constexpr Real kLeastShare = 1e-3;

Real SquaredLength(const SStep& step) {
  return step.X * step.X + step.Y * step.Y;
}

bool IsWithinReach(const CCellLists& lists, UInt32 cell, Real x, Real y, Real reach) {
  if (lists.IsEmpty()) {
    return false;
  }
  for (const UInt32 number : lists.Get(cell)) {
    if (ComputeDistance(lists.GetFootprints()[number], x, y) <= reach) {
      return true;
    }
  }
  return false;
}

// The share of a gap that one of two may use up, so that both together never use more than there
// is. Who wants nothing of it leaves it to the other.
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
    const Real wanted = std::abs(0.5 * (m_wheels[slot][0] + m_wheels[slot][1]) * tick);
    // of speeds that are no numbers Plan() complains
    const Real path = std::fmin(wanted, substeps * kMaxStep * radius);
    farthest =
        std::max(farthest, radius + 2.0 * (path + m_allowance[slot] + (substeps - 1) * radius));
  }
  return farthest + 2.0 * substeps * kMaxRounding;
}

// Finds out which discs may come half-way to a ghost in this tick: in each substep one goes as far
// as it reaches beyond its radius, and after the first by up to a radius more if it overlaps.
void CDiscSwarm::MeetGhosts(std::span<const SGhostDisc> ghosts, UInt32 substeps) {
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
  m_wishes.resize(GetSize());
  m_done.resize(GetSize());
  m_next.resize(GetSize());
  m_movers.resize(GetSize());
  m_numMovers.store(0, std::memory_order_relaxed);
  const UInt32 stride = m_grid.GetStride();
  // without the frame of empty cells
  pool.ParallelFor(m_grid.GetNumCells() - 2 * stride, kCellGrain,
                   [&](size_t begin, size_t end, UInt32) {
                     FindMovers(begin + stride, end + stride, walls, solids);
                   });
  // those who are where they want to be are done; they come behind the others
  size_t numLeft = m_numMovers.load(std::memory_order_relaxed);
  bool isAnyActive = true;
  for (UInt32 round = 0; round < kMaxRounds && numLeft > 0 && isAnyActive; ++round) {
    isAnyActive = TakeRound(pool, numLeft, walls, solids);
    numLeft = DropArrived(numLeft);
  }
  pool.ParallelFor(numLeft, kMoverGrain, [this](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      Finish(m_movers[i]);
    }
  });
}

// Lets the first so many movers take a step. Returns whether anybody got ahead.
bool CDiscSwarm::TakeRound(CThreadPool& pool, size_t numLeft, const CCellLists& walls,
                           const CCellLists& solids) {
  std::atomic<bool> isAnyActive{false};
  pool.ParallelFor(numLeft, kMoverGrain, [&](size_t begin, size_t end, UInt32) {
    bool isActive = false;
    for (size_t i = begin; i < end; ++i) {
      isActive = StepOne(m_movers[i], walls, solids, m_done, m_next) || isActive;
    }
    if (isActive) {
      isAnyActive.store(true, std::memory_order_relaxed);
    }
  });
  m_done.swap(m_next);
  return isAnyActive.load(std::memory_order_relaxed);
}

// Puts those of the first so many movers that have arrived behind the others. Returns how many
// these are.
size_t CDiscSwarm::DropArrived(size_t numLeft) {
  for (size_t i = 0; i < numLeft;) {
    const UInt32 place = m_movers[i].Place;
    const SWish& wish = m_wishes[place];
    const SStep missing = {wish.X - m_done[place].X, wish.Y - m_done[place].Y};
    if (wish.Depth == 0.0 &&
        SquaredLength(missing) <= kArrived * kArrived * (wish.X * wish.X + wish.Y * wish.Y)) {
      m_next[place] = m_done[place];
      std::swap(m_movers[i], m_movers[--numLeft]);
    } else {
      ++i;
    }
  }
  return numLeft;
}

// Calls visit(place) for those in a cell and around it until it returns true; returns whether it
// did.
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

bool CDiscSwarm::MayMeetSomething(UInt32 place, UInt32 cell, const CCellLists& walls,
                                  const CCellLists& solids) const {
  const SPlace& disc = m_places[place];
  const Real reach = static_cast<Real>(disc.Reach);
  const bool meetsDisc = ForPlacesAround(cell, [&](UInt32 other) {
    const SPlace& neighbour = m_places[other];
    const Real dx = neighbour.X - disc.X;
    const Real dy = neighbour.Y - disc.Y;
    const Real near = reach + static_cast<Real>(neighbour.Reach);
    return dx * dx + dy * dy <= near * near && other != place;
  });
  return meetsDisc || m_ghostLines.Has(disc.Slot) ||
         IsWithinReach(walls, cell, disc.X, disc.Y, reach) ||
         IsWithinReach(solids, cell, disc.X, disc.Y, reach);
}

void CDiscSwarm::FindMovers(size_t beginCell, size_t endCell, const CCellLists& walls,
                            const CCellLists& solids) {
  std::array<SMover, 64> found;
  UInt32 numFound = 0;
  const auto flush = [&] {
    const UInt32 first = m_numMovers.fetch_add(numFound, std::memory_order_relaxed);
    std::copy_n(found.begin(), numFound, m_movers.begin() + first);
    numFound = 0;
  };
  for (size_t i = beginCell; i < endCell; ++i) {
    const UInt32 cell = static_cast<UInt32>(i);
    for (UInt32 place = m_sort.Begin(cell); place < m_sort.End(cell); ++place) {
      if (!MayMeetSomething(place, cell, walls, solids)) {
        continue;
      }
      const SPlace& disc = m_places[place];
      const UInt32 slot = disc.Slot;
      m_wishes[place] = {m_stepX[slot], m_stepY[slot], m_radius[slot],
                         static_cast<Real>(disc.Reach) - m_radius[slot], 0.0};
      m_done[place] = SStep();
      found[numFound++] = {place, cell};
      if (numFound == found.size()) {
        flush();
      }
    }
  }
  flush();
}

// Takes one round's step of a robot. Returns whether it has got ahead.
bool CDiscSwarm::StepOne(const SMover& mover, const CCellLists& walls, const CCellLists& solids,
                         const std::vector<SStep>& done, std::vector<SStep>& next) {
  SWish& wish = m_wishes[mover.Place];
  const SStep& here = done[mover.Place];
  const SStep missing = {wish.X - here.X, wish.Y - here.Y};
  const Real length = std::sqrt(SquaredLength(missing));
  const bool mayBePushed = wish.Path > std::sqrt(wish.X * wish.X + wish.Y * wish.Y) + 1e-6;
  CHalfPlanes planes;
  SStep goal;
  Real share = 1.0;
  // what does not limit the way is left out; should there be too many, it goes only part of the way
  for (bool fits = false; !fits && share > kLeastShare; share *= 0.25) {
    const Real bound = share * (length + (mayBePushed ? wish.Path : 0.0));
    planes.Clear();
    wish.Depth = 0.0;
    fits = LimitByDiscs(mover, done, bound, planes) &&
           LimitByFootprints(mover, walls, kFirstWall, here, bound, planes) &&
           LimitByFootprints(mover, solids, kFirstSolid, here, bound, planes) &&
           LimitByGhosts(mover, here, bound, planes);
    // sums round, so the order must not be that in which threads have sorted the discs
    planes.Sort();
    const SStep push = planes.SumPushes();
    goal = {share * missing.X + push.X, share * missing.Y + push.Y};
    const Real goalLength = std::sqrt(SquaredLength(goal));
    if (!fits || goalLength > bound) {
      const Real scale = fits && goalLength > 0.0 ? bound / goalLength : 0.0;
      goal = {goal.X * scale, goal.Y * scale};
    }
  }
  SStep step = planes.FindNearest(goal);
  // nobody looks farther ahead than the path
  const Real room = wish.Path - std::sqrt(SquaredLength(here));
  const Real stepLength = std::sqrt(SquaredLength(step));
  const SStep there = {here.X + step.X, here.Y + step.Y};
  if (SquaredLength(there) > wish.Path * wish.Path && stepLength > 0.0) {
    const Real scale = std::max(0.0, room / stepLength);
    step = {step.X * scale, step.Y * scale};
  }
  next[mover.Place] = {here.X + step.X, here.Y + step.Y};
  return stepLength > kNegligibleStep * wish.Radius;
}

bool CDiscSwarm::LimitByDiscs(const SMover& mover, const std::vector<SStep>& done, Real bound,
                              CHalfPlanes& planes) {
  SWish& wish = m_wishes[mover.Place];
  const SPlace& disc = m_places[mover.Place];
  const SStep& here = done[mover.Place];
  const SStep missing = {wish.X - here.X, wish.Y - here.Y};
  return !ForPlacesAround(mover.Cell, [&](UInt32 other) {
    const SPlace& neighbour = m_places[other];
    const Real dx = neighbour.X - disc.X;
    const Real dy = neighbour.Y - disc.Y;
    const Real near = static_cast<Real>(disc.Reach) + static_cast<Real>(neighbour.Reach);
    if (other == mover.Place || dx * dx + dy * dy > near * near) {
      return false;
    }
    const SWish& wishThere = m_wishes[other];
    const SStep& there = done[other];
    const SStep missingThere = {wishThere.X - there.X, wishThere.Y - there.Y};
    const SStep offset = {dx + (there.X - here.X), dy + (there.Y - here.Y)};
    const SStep relative = {missingThere.X - missing.X, missingThere.Y - missing.Y};
    SSeparation separation = SeparateDiscs(offset, relative, wish.Radius + wishThere.Radius);
    if (offset.X == 0.0 && offset.Y == 0.0 && disc.Slot > neighbour.Slot) {
      separation.NormalX = -separation.NormalX;
    }
    Real push = 0.0;
    if (separation.Gap < -kMaxRounding) {
      push = -0.5 * separation.Gap;
      wish.Depth = std::max(wish.Depth, -separation.Gap);
    }
    const Real mine =
        std::max(0.0, separation.NormalX * missing.X + separation.NormalY * missing.Y);
    const Real theirs =
        std::max(0.0, -separation.NormalX * missingThere.X - separation.NormalY * missingThere.Y);
    const Real limit = ShareGap(std::max(0.0, separation.Gap), mine, theirs);
    return limit < bound &&
           !planes.Add({separation.NormalX, separation.NormalY, limit, neighbour.Slot, push});
  });
}

bool CDiscSwarm::LimitByFootprints(const SMover& mover, const CCellLists& lists, UInt32 firstId,
                                   const SStep& done, Real bound, CHalfPlanes& planes) {
  if (lists.IsEmpty()) {
    return true;
  }
  SWish& wish = m_wishes[mover.Place];
  const SPlace& disc = m_places[mover.Place];
  const Real x = disc.X + done.X;
  const Real y = disc.Y + done.Y;
  const SStep missing = {wish.X - done.X, wish.Y - done.Y};
  for (const UInt32 number : lists.Get(mover.Cell)) {
    const SFootprint& footprint = lists.GetFootprints()[number];
    if (ComputeDistance(footprint, x, y) - wish.Radius >= bound) {
      continue;
    }
    const SSeparation separation = SeparateFromFootprint(x, y, wish.Radius, missing, footprint);
    Real push = 0.0;
    if (separation.Gap < -kMaxRounding) {
      push = -separation.Gap;
      wish.Depth = std::max(wish.Depth, -separation.Gap);
    }
    const Real limit = std::max(0.0, separation.Gap);
    if (limit < bound &&
        !planes.Add({separation.NormalX, separation.NormalY, limit, firstId + number, push})) {
      return false;
    }
  }
  return true;
}

bool CDiscSwarm::LimitByGhosts(const SMover& mover, const SStep& done, Real bound,
                               CHalfPlanes& planes) {
  SWish& wish = m_wishes[mover.Place];
  const SPlace& disc = m_places[mover.Place];
  for (const SGhostLine& line : m_ghostLines.Get(disc.Slot)) {
    const Real room = line.Room - line.NormalX * (disc.X - line.StartX + done.X) -
                      line.NormalY * (disc.Y - line.StartY + done.Y);
    Real push = 0.0;
    if (room < -kMaxRounding) {
      push = -room;
      wish.Depth = std::max(wish.Depth, -room);
    }
    const Real limit = std::max(0.0, room);
    if (limit < bound &&
        !planes.Add({line.NormalX, line.NormalY, limit, kFirstGhost + line.Ghost, push})) {
      return false;
    }
  }
  return true;
}

// Of one that is not where its wheels want it.
void CDiscSwarm::Finish(const SMover& mover) {
  const SWish& wish = m_wishes[mover.Place];
  const SPlace& disc = m_places[mover.Place];
  const SStep& done = m_done[mover.Place];
  m_nextX[disc.Slot] = disc.X + done.X;
  m_nextY[disc.Slot] = disc.Y + done.Y;
  m_allowance[disc.Slot] = std::min(wish.Depth, wish.Radius);
}

}  // namespace argos
