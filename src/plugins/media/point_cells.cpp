#include <argos3/plugins/simulator/media/point_cells.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace argos {

namespace {

constexpr Real kMinSide = 1e-3;  // m
constexpr Real kCellsPerPoint = 2.0;  // is the upper limit: more would be empty
constexpr Real kMinCells = 64.0;
constexpr Real kMaxUserCells = 1 << 18;

}  // namespace

void CPointCells::SetOptions(const SIndexChoice& options, const CRange<CVector3>& arena) {
  m_options = options;
  m_arena = arena;
}

// sides of the cells that suit the queries, or that the user has chosen, m
SPlanarVector CPointCells::ChooseSides(Real typicalReach) const {
  if (m_options.GridSize[0] > 0) {
    const CVector3 size = m_arena.GetMax() - m_arena.GetMin();
    return {std::max(kMinSide, size.GetX() / m_options.GridSize[0]),
            std::max(kMinSide, size.GetY() / m_options.GridSize[1])};
  }
  const Real side = std::max(kMinSide, 0.5 * typicalReach);
  return {side, side};
}

void CPointCells::ChooseHash(size_t num, Real typicalReach) {
  const SPlanarVector side = ChooseSides(typicalReach);
  m_inverseX = 1.0 / side.X;
  m_inverseY = 1.0 / side.Y;
  m_hashShift = 64 - static_cast<UInt32>(std::countr_zero(std::bit_ceil(std::max<size_t>(2, num))));
}

// The grid covers the points, but nothing beyond the arena: a stray point must not make cells
// large.
void CPointCells::ChooseGrid(const Real* x, const Real* y, size_t num, Real typicalReach) {
  const auto bounds = [num](const Real* values, Real arenaMin, Real arenaMax) {
    const auto [low, high] = std::minmax_element(values, values + num);
    const Real min = std::clamp(*low, arenaMin, arenaMax);
    return std::pair(min, std::clamp(*high, min, arenaMax) - min);
  };
  const auto [minX, width] = bounds(x, m_arena.GetMin().GetX(), m_arena.GetMax().GetX());
  const auto [minY, depth] = bounds(y, m_arena.GetMin().GetY(), m_arena.GetMax().GetY());
  const Real mostCells = m_options.GridSize[0] > 0
                             ? kMaxUserCells
                             : std::max(kMinCells, kCellsPerPoint * static_cast<Real>(num));
  // the most that there can be, so that a swarm that spreads costs no allocation
  m_sort.Reserve(num, static_cast<size_t>(mostCells));
  const auto count = [](Real length, Real side) { return std::floor(length / side) + 1.0; };
  SPlanarVector side = ChooseSides(typicalReach);
  while (count(width, side.X) * count(depth, side.Y) > mostCells) {
    side.X *= 1.5;
    side.Y *= 1.5;
  }
  m_grid.Lay({minX, side.X, static_cast<SInt32>(count(width, side.X))},
             {minY, side.Y, static_cast<SInt32>(count(depth, side.Y))});
}

// @return number of cells or buckets
size_t CPointCells::ChooseCells(const Real* x, const Real* y, size_t num, Real typicalReach) {
  m_hashed = num > 0 && m_options.Kind == SIndexChoice::EKind::Hash;
  if (m_hashed) {
    ChooseHash(num, typicalReach);
    return size_t(1) << (64 - m_hashShift);
  }
  if (num > 0 && m_options.Kind == SIndexChoice::EKind::Grid) {
    ChooseGrid(x, y, num, typicalReach);
  } else {
    m_grid.Lay(SGridAxis(), SGridAxis());
  }
  return m_grid.GetNumCells();
}

void CPointCells::Sort(const Real* x, const Real* y, size_t num, Real typicalReach) {
  m_sort.Start(num, ChooseCells(x, y, num, typicalReach));
  for (size_t point = 0; point < num; ++point) {
    m_sort.SetKey(point, m_hashed ? Bucket(HashI(x[point]), HashJ(y[point]))
                                  : m_grid.CellAt(x[point], y[point]));
  }
  m_order.resize(m_sort.Finish());
  for (size_t point = 0; point < num; ++point) {
    m_order[m_sort.GetPlace(point)] = static_cast<UInt32>(point);
  }
  if (m_hashed) {
    m_cells.resize(num);
    for (size_t place = 0; place < num; ++place) {
      m_cells[place] = {HashI(x[m_order[place]]), HashJ(y[m_order[place]])};
    }
  }
}

}  // namespace argos
