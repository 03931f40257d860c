#ifndef ARGOS3_PLUGINS_MEDIA_POINT_CELLS_H
#define ARGOS3_PLUGINS_MEDIA_POINT_CELLS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/plugins/simulator/media/index_choice.h>

#include <cmath>
#include <vector>

namespace argos {

/**
 * Points sorted by cells of the ground plane, so that those near a place lie side by side; for the
 * sources of media.
 *
 * Cells only make queries fast: who asks compares distances himself, so results do not depend on
 * them. Does not allocate once it has held as many points.
 */
class CPointCells {
 public:
  /** @param arena limits of the arena, m; points beyond belong to the cells at its border. */
  void SetOptions(const SIndexChoice& options, const CRange<CVector3>& arena);

  /**
   * Sorts points, which must be finite.
   * @param x, y           of the points, m, world frame, (num).
   * @param typicalReach   of the queries to come, m.
   */
  void Sort(const Real* x, const Real* y, size_t num, Real typicalReach);

  /** Number of the point at a place: places 0, 1, ... are in the order of the cells. */
  UInt32 GetPoint(size_t place) const { return m_order[place]; }
  size_t GetNumPoints() const { return m_order.size(); }

  /**
   * Calls visit(size_t place) for every point within @p reach (m) of (@p x, @p y), seen from above,
   * and for others. Each point once. Safe on several threads at once.
   */
  template <typename VISIT>
  void ForPlacesNear(Real x, Real y, Real reach, VISIT&& visit) const {
    const SInt32 minI = CellI(x - reach);
    const SInt32 maxI = CellI(x + reach);
    const SInt32 minJ = CellJ(y - reach);
    const SInt32 maxJ = CellJ(y + reach);
    const Real numCells = (Real(maxI) - minI + 1.0) * (Real(maxJ) - minJ + 1.0);
    if (!m_hashed) {
      for (SInt32 j = minJ; j <= maxJ; ++j) {
        const size_t row = static_cast<size_t>(j) * m_numI;
        const UInt32 end = m_start[row + maxI + 1];
        for (UInt32 place = m_start[row + minI]; place < end; ++place) {
          visit(place);
        }
      }
    } else if (numCells > static_cast<Real>(m_order.size())) {
      for (size_t place = 0; place < m_order.size(); ++place) {
        visit(place);
      }
    } else {
      for (SInt32 j = minJ; j <= maxJ; ++j) {
        for (SInt32 i = minI; i <= maxI; ++i) {
          VisitBucket(i, j, visit);
        }
      }
    }
  }

 private:
  struct SCell {
    SInt32 I, J;
  };

  // the comparisons in floating point keep far-away positions inside the table
  static SInt32 Clamp(Real cell, Real min, Real max) {
    return static_cast<SInt32>(cell > min ? (cell < max ? std::floor(cell) : max) : min);
  }
  SInt32 CellI(Real x) const { return Clamp((x - m_minX) * m_inverseX, m_lowest, m_highestI); }
  SInt32 CellJ(Real y) const { return Clamp((y - m_minY) * m_inverseY, m_lowest, m_highestJ); }
  size_t Bucket(SInt32 i, SInt32 j) const {
    const UInt64 key = (static_cast<UInt64>(static_cast<UInt32>(i)) << 32) | static_cast<UInt32>(j);
    return static_cast<size_t>((key * 0x9e3779b97f4a7c15ULL) >> m_hashShift);
  }
  template <typename VISIT>
  void VisitBucket(SInt32 i, SInt32 j, VISIT&& visit) const {
    const size_t bucket = Bucket(i, j);
    for (UInt32 place = m_start[bucket]; place < m_start[bucket + 1]; ++place) {
      // other cells share the bucket
      if (m_cells[place].I == i && m_cells[place].J == j) {
        visit(place);
      }
    }
  }
  void ChooseCells(const Real* x, const Real* y, size_t num, Real typicalReach);
  void ChooseSides(Real width, Real depth, size_t num, Real typicalReach);

  SIndexChoice m_options;
  CRange<CVector3> m_arena;  // m

  bool m_hashed = false;
  Real m_minX = 0.0, m_minY = 0.0;  // m
  Real m_inverseX = 1.0, m_inverseY = 1.0;  // 1/m, of the sides of a cell
  Real m_lowest = 0.0, m_highestI = 0.0, m_highestJ = 0.0;  // cells
  size_t m_numI = 1;  // cells in a row, if not hashed
  UInt32 m_hashShift = 63;
  std::vector<UInt32> m_start;  // (cells or buckets + 1), places
  std::vector<UInt32> m_cursor;  // (cells or buckets), scratch
  std::vector<UInt32> m_cellOf;  // (points), cell or bucket
  std::vector<UInt32> m_order;  // (points), by place
  std::vector<SCell> m_cells;  // (points), by place, if hashed
};

}  // namespace argos

#endif
