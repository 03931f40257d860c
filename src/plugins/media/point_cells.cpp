#include <argos3/plugins/simulator/media/point_cells.h>

#include <algorithm>
#include <bit>

namespace argos {

namespace {

constexpr Real kMinSide = 1e-3;  // m
constexpr Real kCellsPerPoint = 2.0;  // at most: more would be empty
constexpr Real kMinCells = 64.0;
constexpr Real kMaxUserCells = 1 << 18;
constexpr Real kFarCell = 1 << 30;  // of a hash: what is farther away shares a cell

}  // namespace

void CPointCells::SetOptions(const SIndexChoice& options, const CRange<CVector3>& arena) {
  m_options = options;
  m_arena = arena;
}

// decides sides of cells, and their number for a table
void CPointCells::ChooseSides(Real width, Real depth, size_t num, Real typicalReach) {
  Real sideX = std::max(kMinSide, 0.5 * typicalReach);
  Real sideY = sideX;
  if (m_options.GridSize[0] > 0) {
    const CVector3 size = m_arena.GetMax() - m_arena.GetMin();
    sideX = std::max(kMinSide, size.GetX() / m_options.GridSize[0]);
    sideY = std::max(kMinSide, size.GetY() / m_options.GridSize[1]);
  }
  if (!m_hashed) {
    const Real mostCells = m_options.GridSize[0] > 0
                               ? kMaxUserCells
                               : std::max(kMinCells, kCellsPerPoint * static_cast<Real>(num));
    // as much as there can be, so that a swarm that spreads costs no allocation
    m_start.reserve(static_cast<size_t>(mostCells) + 1);
    m_cursor.reserve(static_cast<size_t>(mostCells));
    const auto count = [](Real length, Real side) { return std::floor(length / side) + 1.0; };
    while (count(width, sideX) * count(depth, sideY) > mostCells) {
      sideX *= 1.5;
      sideY *= 1.5;
    }
    m_numI = static_cast<size_t>(count(width, sideX));
    m_highestI = static_cast<Real>(m_numI) - 1.0;
    m_highestJ = count(depth, sideY) - 1.0;
  }
  m_inverseX = 1.0 / sideX;
  m_inverseY = 1.0 / sideY;
}

void CPointCells::ChooseCells(const Real* x, const Real* y, size_t num, Real typicalReach) {
  m_hashed = m_options.Kind == SIndexChoice::EKind::Hash;
  m_minX = m_minY = 0.0;
  m_lowest = m_highestI = m_highestJ = 0.0;
  m_numI = 1;
  m_inverseX = m_inverseY = 1.0;
  size_t numCells = 1;
  if (num > 0 && m_hashed) {
    m_lowest = -kFarCell;
    m_highestI = m_highestJ = kFarCell;
    ChooseSides(0.0, 0.0, num, typicalReach);
    numCells = std::bit_ceil(std::max<size_t>(2, num));
    m_hashShift = 64 - static_cast<UInt32>(std::countr_zero(numCells));
  } else if (num > 0 && m_options.Kind == SIndexChoice::EKind::Grid) {
    // where the points are, but not beyond the arena: a stray one must not make cells large
    const auto bounds = [num](const Real* values, Real arenaMin, Real arenaMax) {
      const auto [low, high] = std::minmax_element(values, values + num);
      const Real min = std::clamp(*low, arenaMin, arenaMax);
      return std::pair(min, std::clamp(*high, min, arenaMax) - min);
    };
    const auto [minX, width] = bounds(x, m_arena.GetMin().GetX(), m_arena.GetMax().GetX());
    const auto [minY, depth] = bounds(y, m_arena.GetMin().GetY(), m_arena.GetMax().GetY());
    m_minX = minX;
    m_minY = minY;
    ChooseSides(width, depth, num, typicalReach);
    numCells = m_numI * (static_cast<size_t>(m_highestJ) + 1);
  }
  m_start.assign(numCells + 1, 0);
  m_cursor.resize(numCells);
}

void CPointCells::Sort(const Real* x, const Real* y, size_t num, Real typicalReach) {
  ChooseCells(x, y, num, typicalReach);
  m_cellOf.resize(num);
  m_order.resize(num);
  for (size_t point = 0; point < num; ++point) {
    const SInt32 i = CellI(x[point]);
    const SInt32 j = CellJ(y[point]);
    m_cellOf[point] = static_cast<UInt32>(
        m_hashed ? Bucket(i, j) : static_cast<size_t>(j) * m_numI + static_cast<size_t>(i));
    ++m_start[m_cellOf[point] + 1];
  }
  for (size_t cell = 0; cell + 1 < m_start.size(); ++cell) {
    m_start[cell + 1] += m_start[cell];
    m_cursor[cell] = m_start[cell];
  }
  for (size_t point = 0; point < num; ++point) {
    m_order[m_cursor[m_cellOf[point]]++] = static_cast<UInt32>(point);
  }
  if (m_hashed) {
    m_cells.resize(num);
    for (size_t place = 0; place < num; ++place) {
      m_cells[place] = {CellI(x[m_order[place]]), CellJ(y[m_order[place]])};
    }
  }
}

}  // namespace argos
