#include <argos3/plugins/simulator/physics_engines/kinematics2d/cell_grid.h>

#include <algorithm>
#include <cmath>

namespace argos {

namespace {

// calls visit(cell) for every cell that comes within reach of a footprint
template <typename VISIT>
void ForCells(const CCellGrid& grid, const SFootprint& footprint, Real reach, VISIT&& visit) {
  const Real halfX = reach + footprint.Radius + std::abs(footprint.Cos) * footprint.HalfX +
                     std::abs(footprint.Sin) * footprint.HalfY;
  const Real halfY = reach + footprint.Radius + std::abs(footprint.Sin) * footprint.HalfX +
                     std::abs(footprint.Cos) * footprint.HalfY;
  const UInt32 stride = grid.GetStride();
  const UInt32 first = grid.CellAt(footprint.X - halfX, footprint.Y - halfY);
  const UInt32 last = grid.CellAt(footprint.X + halfX, footprint.Y + halfY);
  const UInt32 width = last % stride - first % stride;
  for (UInt32 row = first; row <= last; row += stride) {
    for (UInt32 cell = row; cell <= row + width; ++cell) {
      visit(cell);
    }
  }
}

}  // namespace

void CCellGrid::Lay(const SArea& area, Real minEdge, Real aimedCells) {
  m_area = area;
  const Real width = area.MaxX - area.MinX;
  const Real height = area.MaxY - area.MinY;
  m_edge = std::max(
      {minEdge, std::sqrt(width * height / aimedCells), std::max(width, height) / aimedCells});
  m_inverseEdge = 1.0 / m_edge;
  m_numI = static_cast<UInt32>(width * m_inverseEdge) + 1;
  m_numJ = static_cast<UInt32>(height * m_inverseEdge) + 1;
  m_stride = m_numI + 2;
  m_numCells = static_cast<size_t>(m_stride) * (m_numJ + 2);
  ++m_generation;
}

void CCellLists::List(const CCellGrid& grid, std::span<const SFootprint> footprints, Real reach) {
  m_footprints = footprints;
  if (footprints.empty()) {
    Clear();
    return;
  }
  // counts, then sums, then fills backwards: each start ends where its cell begins
  if (m_start.capacity() <= grid.GetNumCells()) {
    m_start.reserve(2 * grid.GetNumCells());
  }
  m_start.assign(grid.GetNumCells() + 1, 0);
  for (const SFootprint& footprint : footprints) {
    ForCells(grid, footprint, reach, [this](UInt32 cell) { ++m_start[cell]; });
  }
  UInt32 sum = 0;
  for (UInt32& start : m_start) {
    sum += start;
    start = sum;
  }
  if (m_items.capacity() < sum) {
    // what moves is not always in as many cells
    m_items.reserve(2 * static_cast<size_t>(sum));
  }
  m_items.resize(sum);
  for (size_t i = footprints.size(); i-- > 0;) {
    ForCells(grid, footprints[i], reach,
             [this, i](UInt32 cell) { m_items[--m_start[cell]] = static_cast<UInt32>(i); });
  }
}

void CCellLists::Find(const CCellGrid& grid, Real x, Real y, Real radius,
                      std::vector<UInt32>& numbers) const {
  numbers.clear();
  if (IsEmpty()) {
    return;
  }
  SFootprint circle = {x, y, 1.0, 0.0, 0.0, 0.0, 0.0};
  ForCells(grid, circle, radius, [&](UInt32 cell) {
    const std::span<const UInt32> listed = Get(cell);
    numbers.insert(numbers.end(), listed.begin(), listed.end());
  });
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace argos
