#include <argos3/plugins/simulator/physics_engines/dynamics2d/encounters.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m; obstacles are not sorted finer
constexpr Real kMinObstacleCell = 0.25;

// about as many cells as this
Real AimedCells(size_t numDiscs) {
  return 64.0 + 2.0 * static_cast<Real>(numDiscs);
}

// a square has this many; a long strip has one row or column more for each cell
size_t MaxCells(size_t numDiscs) {
  return 3 * static_cast<size_t>(AimedCells(numDiscs));
}

/** Half the size of the axis-aligned box around an obstacle, m. */
void ComputeHalfExtents(const SFootprint& obstacle, Real& halfX, Real& halfY) {
  halfX = obstacle.Radius + std::abs(obstacle.Cos) * obstacle.HalfX +
          std::abs(obstacle.Sin) * obstacle.HalfY;
  halfY = obstacle.Radius + std::abs(obstacle.Sin) * obstacle.HalfX +
          std::abs(obstacle.Cos) * obstacle.HalfY;
}

// from the boundary to the point, m; 0 inside
Real ComputeDistance(const SFootprint& obstacle, Real x, Real y) {
  const Real dx = x - obstacle.X;
  const Real dy = y - obstacle.Y;
  const Real outX = std::max(0.0, std::abs(obstacle.Cos * dx + obstacle.Sin * dy) - obstacle.HalfX);
  const Real outY = std::max(0.0, std::abs(obstacle.Cos * dy - obstacle.Sin * dx) - obstacle.HalfY);
  return std::max(0.0, std::sqrt(outX * outX + outY * outY) - obstacle.Radius);
}

}  // namespace

void CEncounters::SGrid::Cover(Real minX, Real minY, Real maxX, Real maxY, Real minEdge,
                               Real maxCells) {
  MinX = minX;
  MinY = minY;
  const Real width = maxX - minX;
  const Real height = maxY - minY;
  Real edge = std::max(minEdge, std::sqrt(width * height / maxCells));
  edge = std::max(edge, std::max(width, height) / maxCells);
  InverseEdge = 1.0 / edge;
  NumI = static_cast<int>(width * InverseEdge) + 1;
  NumJ = static_cast<int>(height * InverseEdge) + 1;
}

void CEncounters::SetObstacles(const std::vector<SFootprint>& obstacles) {
  m_obstacles = obstacles;
  Real minX = HUGE_VAL, minY = HUGE_VAL, maxX = -HUGE_VAL, maxY = -HUGE_VAL;
  for (const SFootprint& obstacle : m_obstacles) {
    Real halfX, halfY;
    ComputeHalfExtents(obstacle, halfX, halfY);
    minX = std::min(minX, obstacle.X - halfX);
    maxX = std::max(maxX, obstacle.X + halfX);
    minY = std::min(minY, obstacle.Y - halfY);
    maxY = std::max(maxY, obstacle.Y + halfY);
  }
  if (m_obstacles.empty()) {
    return;
  }
  m_obstacleGrid.Cover(minX, minY, maxX, maxY, kMinObstacleCell,
                       65536.0 + 8.0 * static_cast<Real>(m_obstacles.size()));
  // counts, then sums, then fills
  m_obstacleStart.assign(m_obstacleGrid.NumCells() + 1, 0);
  const auto forCells = [this](const SFootprint& obstacle, auto&& visit) {
    Real halfX, halfY;
    ComputeHalfExtents(obstacle, halfX, halfY);
    const int maxI = m_obstacleGrid.CellI(obstacle.X + halfX);
    const int maxJ = m_obstacleGrid.CellJ(obstacle.Y + halfY);
    for (int j = m_obstacleGrid.CellJ(obstacle.Y - halfY); j <= maxJ; ++j) {
      for (int i = m_obstacleGrid.CellI(obstacle.X - halfX); i <= maxI; ++i) {
        visit(static_cast<size_t>(j) * static_cast<size_t>(m_obstacleGrid.NumI) +
              static_cast<size_t>(i));
      }
    }
  };
  for (const SFootprint& obstacle : m_obstacles) {
    forCells(obstacle, [this](size_t cell) { ++m_obstacleStart[cell + 1]; });
  }
  for (size_t cell = 0; cell < m_obstacleGrid.NumCells(); ++cell) {
    m_obstacleStart[cell + 1] += m_obstacleStart[cell];
  }
  m_obstacleItems.resize(m_obstacleStart.back());
  std::vector<UInt32> next(m_obstacleStart.begin(), m_obstacleStart.end() - 1);
  for (UInt32 number = 0; number < m_obstacles.size(); ++number) {
    forCells(m_obstacles[number], [&](size_t cell) { m_obstacleItems[next[cell]++] = number; });
  }
}

void CEncounters::Reserve(size_t numDiscs) {
  m_discs.reserve(numDiscs);
  m_marks.reserve(numDiscs);
  m_placeOf.reserve(numDiscs);
  m_cellOf.reserve(numDiscs);
  m_sorted.reserve(numDiscs);
  m_start.reserve(MaxCells(numDiscs) + 1);
}

void CEncounters::Clear(size_t numDiscs) {
  m_discs.clear();
  m_marks.assign(numDiscs, Alone);
  m_placeOf.resize(numDiscs);
}

void CEncounters::MarkAll() {
  Sort();
  MarkPairs();
  if (!m_obstacles.empty()) {
    for (const SDisc& disc : m_sorted) {
      MarkAtObstacles(disc);
    }
  }
}

void CEncounters::Sort() {
  Real minX = HUGE_VAL, minY = HUGE_VAL, maxX = -HUGE_VAL, maxY = -HUGE_VAL;
  m_maxReach = 0.0;
  for (const SDisc& disc : m_discs) {
    minX = std::min(minX, disc.X);
    maxX = std::max(maxX, disc.X);
    minY = std::min(minY, disc.Y);
    maxY = std::max(maxY, disc.Y);
    m_maxReach = std::max(m_maxReach, disc.Reach);
  }
  m_sorted.resize(m_discs.size());
  if (m_discs.empty()) {
    minX = minY = maxX = maxY = 0.0;
  }
  m_grid.Cover(minX, minY, maxX, maxY, 2.0 * m_maxReach + m_margin, AimedCells(m_discs.size()));

  m_cellOf.resize(m_discs.size());
  m_start.assign(m_grid.NumCells() + 1, 0);
  for (size_t i = 0; i < m_discs.size(); ++i) {
    const UInt32 cell =
        static_cast<UInt32>(m_grid.CellJ(m_discs[i].Y) * m_grid.NumI + m_grid.CellI(m_discs[i].X));
    m_cellOf[i] = cell;
    ++m_start[cell];
  }
  UInt32 sum = 0;
  for (UInt32& start : m_start) {
    sum += start;
    start = sum;
  }
  // backwards: each start ends where its cell begins, and discs of a cell keep their order
  for (size_t i = m_discs.size(); i-- > 0;) {
    m_sorted[--m_start[m_cellOf[i]]] = m_discs[i];
  }
}

// Each pair once: a disc, and those after it in its row's cells or in the three cells of the next
// row.
void CEncounters::MarkPairs() {
  const int lastI = m_grid.NumI - 1;
  for (int j = 0; j < m_grid.NumJ; ++j) {
    const size_t row = static_cast<size_t>(j) * static_cast<size_t>(m_grid.NumI);
    for (int i = 0; i < m_grid.NumI; ++i) {
      const size_t cell = row + static_cast<size_t>(i);
      const UInt32 begin = m_start[cell];
      const UInt32 end = m_start[cell + 1];
      if (begin == end) {
        continue;
      }
      const UInt32 rowEnd = m_start[cell + (i < lastI ? 2 : 1)];
      UInt32 below = 0;
      UInt32 belowEnd = 0;
      if (j + 1 < m_grid.NumJ) {
        const size_t next = cell + static_cast<size_t>(m_grid.NumI);
        below = m_start[i > 0 ? next - 1 : next];
        belowEnd = m_start[next + (i < lastI ? 2 : 1)];
      }
      for (UInt32 a = begin; a < end; ++a) {
        for (UInt32 b = a + 1; b < rowEnd; ++b) {
          MarkPair(m_sorted[a], m_sorted[b]);
        }
        for (UInt32 b = below; b < belowEnd; ++b) {
          MarkPair(m_sorted[a], m_sorted[b]);
        }
      }
    }
  }
}

void CEncounters::MarkPair(const SDisc& a, const SDisc& b) {
  const Real dx = b.X - a.X;
  const Real dy = b.Y - a.Y;
  const Real squared = dx * dx + dy * dy;
  const Real near = a.Reach + b.Reach;
  const Real around = near + m_margin;
  if (squared <= around * around) {
    const EMark mark = squared <= near * near ? Near : Around;
    Raise(a.Number, mark);
    Raise(b.Number, mark);
  }
}

void CEncounters::MarkAtObstacles(const SDisc& disc) {
  const Real reach = disc.Reach + m_margin;
  const int minI = m_obstacleGrid.CellI(disc.X - reach);
  const int maxI = m_obstacleGrid.CellI(disc.X + reach);
  const int maxJ = m_obstacleGrid.CellJ(disc.Y + reach);
  for (int j = m_obstacleGrid.CellJ(disc.Y - reach); j <= maxJ; ++j) {
    const size_t row = static_cast<size_t>(j) * static_cast<size_t>(m_obstacleGrid.NumI);
    const UInt32 end = m_obstacleStart[row + static_cast<size_t>(maxI) + 1];
    for (UInt32 item = m_obstacleStart[row + static_cast<size_t>(minI)]; item < end; ++item) {
      const Real distance = ComputeDistance(m_obstacles[m_obstacleItems[item]], disc.X, disc.Y);
      if (distance <= disc.Reach) {
        Raise(disc.Number, Near);
        return;
      }
      if (distance <= reach) {
        Raise(disc.Number, Around);
      }
    }
  }
}

void CEncounters::MarkNear(Real x, Real y, Real reach, std::vector<UInt32>* met) {
  const Real widest = reach + m_maxReach + m_margin;
  const int minI = m_grid.CellI(x - widest);
  const int maxI = m_grid.CellI(x + widest);
  const int maxJ = m_grid.CellJ(y + widest);
  for (int j = m_grid.CellJ(y - widest); j <= maxJ; ++j) {
    const size_t row = static_cast<size_t>(j) * static_cast<size_t>(m_grid.NumI);
    const UInt32 end = m_start[row + static_cast<size_t>(maxI) + 1];
    for (UInt32 k = m_start[row + static_cast<size_t>(minI)]; k < end; ++k) {
      const SDisc& disc = m_sorted[k];
      const Real dx = disc.X - x;
      const Real dy = disc.Y - y;
      const Real squared = dx * dx + dy * dy;
      const Real near = reach + disc.Reach;
      if (squared <= near * near) {
        Raise(disc.Number, Near);
        if (met != nullptr) {
          met->push_back(disc.Number);
        }
      } else if (squared <= (near + m_margin) * (near + m_margin)) {
        Raise(disc.Number, Around);
      }
    }
  }
}

}  // namespace argos
