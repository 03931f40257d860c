#include <argos3/plugins/simulator/physics_engines/planar/proximity_filter.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// m; least edge of the cells in which obstacles are listed
constexpr Real kMinObstacleCell = 0.25;

}  // namespace

void CProximityFilter::SetObstacles(const std::vector<SFootprint>& obstacles) {
  m_obstacles = obstacles;
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

void CProximityFilter::Reserve(size_t numDiscs) {
  m_discs.reserve(numDiscs);
  m_marks.reserve(numDiscs);
  m_placeOf.reserve(numDiscs);
  m_sort.Reserve(numDiscs, CFramedGrid::MaxCells(numDiscs));
  m_sorted.reserve(numDiscs);
}

void CProximityFilter::Clear(size_t numDiscs) {
  m_discs.clear();
  m_marks.assign(numDiscs, Free);
  m_placeOf.resize(numDiscs);
}

void CProximityFilter::MarkAll() {
  Sort();
  MarkPairs();
  if (!m_obstacles.empty()) {
    for (const SDisc& disc : m_sorted) {
      MarkAtObstacles(disc);
    }
  }
}

void CProximityFilter::Sort() {
  SPlanarArea area = m_discs.empty() ? SPlanarArea() : SPlanarArea::Empty();
  m_maxReach = 0.0;
  for (const SDisc& disc : m_discs) {
    area.Include(disc.X, disc.Y);
    m_maxReach = std::max(m_maxReach, disc.Reach);
  }
  const size_t numDiscs = m_discs.size();
  m_grid.Cover(area, 2.0 * m_maxReach + m_margin, CFramedGrid::AimedCells(numDiscs));
  m_sort.Start(numDiscs, m_grid.GetNumCells());
  for (size_t i = 0; i < numDiscs; ++i) {
    m_sort.SetKey(i, m_grid.CellAt(m_discs[i].X, m_discs[i].Y));
  }
  m_sorted.resize(m_sort.Finish());
  for (size_t i = 0; i < numDiscs; ++i) {
    m_sorted[m_sort.GetPlace(i)] = m_discs[i];
  }
}

// Each pair once: a disc, and those after it in its row's cells or in the three cells of the next
// row. The cells of the frame are empty.
void CProximityFilter::MarkPairs() {
  const SGridAxis& x = m_grid.GetX();
  const SGridAxis& y = m_grid.GetY();
  m_grid.ForCells({0, x.Count - 1, 0, y.Count - 1}, [this](UInt32 cell) {
    const UInt32 end = m_sort.End(cell);
    const UInt32 rowEnd = m_sort.End(cell + 1);
    const UInt32 next = cell + m_grid.GetStride();
    for (UInt32 a = m_sort.Begin(cell); a < end; ++a) {
      for (UInt32 b = a + 1; b < rowEnd; ++b) {
        MarkPair(m_sorted[a], m_sorted[b]);
      }
      const UInt32 nextEnd = m_sort.End(next + 1);
      for (UInt32 b = m_sort.Begin(next - 1); b < nextEnd; ++b) {
        MarkPair(m_sorted[a], m_sorted[b]);
      }
    }
  });
}

void CProximityFilter::MarkPair(const SDisc& a, const SDisc& b) {
  const Real dx = b.X - a.X;
  const Real dy = b.Y - a.Y;
  const Real squared = dx * dx + dy * dy;
  const Real near = a.Reach + b.Reach;
  const Real guarded = near + m_margin;
  if (squared <= guarded * guarded) {
    const EMark mark = squared <= near * near ? Active : Guarded;
    Raise(a.Number, mark);
    Raise(b.Number, mark);
  }
}

void CProximityFilter::MarkAtObstacles(const SDisc& disc) {
  const Real reach = disc.Reach + m_margin;
  m_obstacleCells.ForNear(m_obstacleGrid, disc.X, disc.Y, reach, [&](UInt32 number) {
    if (GetMark(disc.Number) == Active) {
      return;
    }
    const Real distance = ComputeDistance(m_obstacles[number], disc.X, disc.Y);
    if (distance <= reach) {
      Raise(disc.Number, distance <= disc.Reach ? Active : Guarded);
    }
  });
}

void CProximityFilter::MarkNear(Real x, Real y, Real reach, std::vector<UInt32>* met) {
  const Real widest = reach + m_maxReach + m_margin;
  m_grid.ForRows(m_grid.CellsAround(x, y, widest), [&](UInt32 first, UInt32 last) {
    const UInt32 end = m_sort.End(last);
    for (UInt32 k = m_sort.Begin(first); k < end; ++k) {
      const SDisc& disc = m_sorted[k];
      const Real dx = disc.X - x;
      const Real dy = disc.Y - y;
      const Real squared = dx * dx + dy * dy;
      const Real near = reach + disc.Reach;
      if (squared <= near * near) {
        Raise(disc.Number, Active);
        if (met != nullptr) {
          met->push_back(disc.Number);
        }
      } else if (squared <= (near + m_margin) * (near + m_margin)) {
        Raise(disc.Number, Guarded);
      }
    }
  });
}

}  // namespace argos
