#include <argos3/plugins/simulator/physics_engines/planar/disc_pairs.h>

#include <argos3/core/utility/memory/huge_pages.h>
#include <argos3/core/utility/threads/thread_pool.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace argos {

namespace {

// m; least edge of the cells in which obstacles are listed
constexpr Real kMinObstacleCell = 0.25;
// discs in a chunk of a thread
constexpr size_t kDiscGrain = 1024;
// discs in a part, about; and most parts
constexpr size_t kDiscsOfPart = 1024;
constexpr size_t kMaxParts = 64;
// pairs for which a part has memory from the start, besides one for each of its discs
constexpr size_t kSparePairs = 256;

size_t CountParts(size_t discs) {
  return std::clamp<size_t>(discs / kDiscsOfPart, 1, kMaxParts);
}

}  // namespace

void CDiscPairs::SetObstacles(const std::vector<SFootprint>& obstacles) {
  m_obstacles = obstacles;
  AppendImages(m_period, m_obstacles);
  if (!m_obstacles.empty()) {
    SPlanarArea area = SPlanarArea::Empty();
    for (const SFootprint& obstacle : m_obstacles) {
      const SPlanarVector half = ComputeHalfBounds(obstacle);
      area.Include(obstacle.X, obstacle.Y, half.X + obstacle.Radius, half.Y + obstacle.Radius);
    }
    m_obstacleGrid.Cover(area, kMinObstacleCell,
                         65536.0 + 8.0 * static_cast<Real>(m_obstacles.size()));
  }
  m_obstacleCells.List(m_obstacleGrid, m_obstacles, 0.0);
}

void CDiscPairs::Reserve(size_t numDiscs) {
  m_discs.reserve(numDiscs);
  m_extents.reserve(numDiscs / kDiscGrain + 1);
  m_sort.Reserve(numDiscs, CFramedGrid::MaxCells(numDiscs));
  AdviseHugePages(m_sort.GetStartAddress(0), m_sort.GetKeyCapacity() * sizeof(UInt32));
  ReserveInHugePages(m_sorted, numDiscs);
  m_isNear.reserve(numDiscs);
  m_parts.resize(CountParts(numDiscs) + 1);
  m_firstCell.reserve(kMaxParts + 1);
  for (SPart& part : m_parts) {
    const size_t pairs = numDiscs / m_parts.size() + kSparePairs;
    part.Pairs.reserve(pairs);
    part.ObstaclePairs.reserve(pairs);
  }
}

void CDiscPairs::Start(size_t count) {
  m_discs.resize(count);
}

void CDiscPairs::Find(CThreadPool& pool, Real reach) {
  m_reach = reach;
  CoverDiscs(pool);
  Sort(pool);
  Divide();
  m_isNear.assign(m_sorted.size(), 0);
  pool.ParallelFor(m_parts.size() - 1, 1, [this](size_t begin, size_t end, UInt32) {
    for (size_t part = begin; part < end; ++part) {
      FindPairs(part);
    }
  });
  if (m_period.IsOn()) {
    FindPairsAcrossSeams();
  }
}

// Each pair once. They are few, and in the order of places for any number of threads.
void CDiscPairs::FindPairsAcrossSeams() {
  for (UInt32 place = 0; place < m_sorted.size(); ++place) {
    const SDisc& disc = m_sorted[place];
    const Real radius = disc.Radius + m_reach;
    ForImages(disc.X, disc.Y, radius, [&](Real dx, Real dy) {
      if (dx == 0.0 && dy == 0.0) {
        return;
      }
      ForNearHere(disc.X + dx, disc.Y + dy, radius, [&](UInt32 other) {
        if (place < other) {
          m_parts.back().Pairs.push_back({place, other});
          m_isNear[place] = m_isNear[other] = 1;
        }
      });
    });
  }
}

void CDiscPairs::CoverDiscs(CThreadPool& pool) {
  const size_t numChunks = (m_discs.size() + kDiscGrain - 1) / kDiscGrain;
  m_extents.resize(numChunks);
  pool.ParallelFor(numChunks, 1, [this](size_t begin, size_t end, UInt32) {
    for (size_t chunk = begin; chunk < end; ++chunk) {
      SExtent extent = {SPlanarArea::Empty(), 0.0};
      const size_t last = std::min(m_discs.size(), (chunk + 1) * kDiscGrain);
      for (size_t i = chunk * kDiscGrain; i < last; ++i) {
        if (m_discs[i].Radius != kLeftOut) {
          extent.Area.Include(m_discs[i].X, m_discs[i].Y);
          extent.MaxRadius = std::max(extent.MaxRadius, m_discs[i].Radius);
        }
      }
      m_extents[chunk] = extent;
    }
  });
  SPlanarArea area = SPlanarArea::Empty();
  m_maxRadius = 0.0;
  for (const SExtent& extent : m_extents) {
    area = {std::min(area.MinX, extent.Area.MinX), std::min(area.MinY, extent.Area.MinY),
            std::max(area.MaxX, extent.Area.MaxX), std::max(area.MaxY, extent.Area.MaxY)};
    m_maxRadius = std::max(m_maxRadius, extent.MaxRadius);
  }
  if (area.MinX > area.MaxX) {
    area = SPlanarArea();
  }
  m_grid.Cover(area, std::max(2.0 * (m_maxRadius + m_reach), 1e-6),
               CFramedGrid::AimedCells(m_discs.size()));
}

void CDiscPairs::Sort(CThreadPool& pool) {
  const size_t count = m_discs.size();
  const bool alone = pool.GetNumThreads() == 1;
  m_sort.Start(count, m_grid.GetNumCells());
  pool.ParallelFor(count, kDiscGrain, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      const SDisc& disc = m_discs[i];
      if (disc.Radius == kLeftOut) {
        m_sort.LeaveOut(i);
      } else if (alone) {
        m_sort.SetKey(i, m_grid.CellAt(disc.X, disc.Y));
      } else {
        m_sort.SetKeyOnThread(i, m_grid.CellAt(disc.X, disc.Y));
      }
    }
  });
  m_sorted.resize(m_sort.Finish());
  pool.ParallelFor(count, kDiscGrain, [this](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      if (!m_sort.IsLeftOut(i)) {
        m_sorted[m_sort.GetPlace(i)] = m_discs[i];
      }
    }
  });
  if (!alone) {
    m_sort.SortRanges(pool, m_sorted, [](const SDisc& disc) { return disc.Number; });
  }
}

// The discs of a cell are in the order of their numbers: threads leave them in any other one.
UInt32 CDiscPairs::GetPlace(UInt32 number) const {
  CheckNumber(number);
  const UInt32 cell = m_grid.CellAt(m_discs[number].X, m_discs[number].Y);
  const auto end = m_sorted.begin() + m_sort.End(cell);
  const auto found =
      std::lower_bound(m_sorted.begin() + m_sort.Begin(cell), end, number,
                       [](const SDisc& disc, UInt32 wanted) { return disc.Number < wanted; });
  ARGOS_ASSERT(found != end && found->Number == number, "the disc " << number << " is left out");
  return static_cast<UInt32>(found - m_sorted.begin());
}

// Gives each part cells with about as many discs.
void CDiscPairs::Divide() {
  const size_t count = CountParts(m_discs.size());
  m_parts.resize(count + 1);
  // before it shrank, it may have been the part of some cells
  m_parts.back().Pairs.clear();
  m_parts.back().ObstaclePairs.clear();
  m_firstCell.resize(count + 1);
  const UInt32 numCells = static_cast<UInt32>(m_grid.GetNumCells());
  const UInt32 lastCell = numCells - m_grid.GetStride();  // of the frame from here on
  UInt32 cell = m_grid.GetStride();
  for (size_t part = 0; part < count; ++part) {
    m_firstCell[part] = cell;
    const size_t before = (part + 1) * m_sorted.size() / count;
    while (cell < lastCell && m_sort.End(cell) <= before) {
      ++cell;
    }
  }
  m_firstCell[count] = lastCell;
}

void CDiscPairs::MarkNear(UInt32 place) {
  // several threads may do this at once
  std::atomic_ref<UInt8>(m_isNear[place]).store(1, std::memory_order_relaxed);
}

// Each pair once: a disc, and those after it in its row's cells or in the three cells of the next
// row. The cells of the frame are empty.
void CDiscPairs::FindPairs(size_t number) {
  SPart& part = m_parts[number];
  part.Pairs.clear();
  part.ObstaclePairs.clear();
  const auto check = [&](UInt32 a, UInt32 b) {
    const Real dx = m_sorted[b].X - m_sorted[a].X;
    const Real dy = m_sorted[b].Y - m_sorted[a].Y;
    const Real near = m_sorted[a].Radius + m_sorted[b].Radius + 2.0 * m_reach;
    if (dx * dx + dy * dy <= near * near) {
      part.Pairs.push_back({a, b});
      MarkNear(a);
      MarkNear(b);
    }
  };
  for (UInt32 cell = m_firstCell[number]; cell < m_firstCell[number + 1]; ++cell) {
    const UInt32 begin = m_sort.Begin(cell);
    const UInt32 end = m_sort.End(cell);
    if (begin == end) {
      continue;
    }
    const UInt32 rowEnd = m_sort.End(cell + 1);
    const UInt32 next = cell + m_grid.GetStride();
    const UInt32 nextBegin = m_sort.Begin(next - 1);
    const UInt32 nextEnd = m_sort.End(next + 1);
    for (UInt32 a = begin; a < end; ++a) {
      for (UInt32 b = a + 1; b < rowEnd; ++b) {
        check(a, b);
      }
      for (UInt32 b = nextBegin; b < nextEnd; ++b) {
        check(a, b);
      }
      FindObstacles(a, part);
    }
  }
}

void CDiscPairs::FindObstacles(UInt32 place, SPart& part) {
  const SDisc& disc = m_sorted[place];
  const Real reach = disc.Radius + m_reach;
  const size_t first = part.ObstaclePairs.size();
  m_obstacleCells.ForNear(m_obstacleGrid, disc.X, disc.Y, reach, [&](UInt32 number) {
    const auto isSame = [number](const SObstaclePair& pair) { return pair.Obstacle == number; };
    if (std::none_of(part.ObstaclePairs.begin() + first, part.ObstaclePairs.end(), isSame) &&
        ComputeDistance(m_obstacles[number], disc.X, disc.Y) <= reach) {
      part.ObstaclePairs.push_back({place, number});
      MarkNear(place);
    }
  });
}

}  // namespace argos
