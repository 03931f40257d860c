#ifndef ARGOS3_PLUGINS_MEDIA_POINT_CELLS_H
#define ARGOS3_PLUGINS_MEDIA_POINT_CELLS_H

#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/math/range.h>
#include <argos3/core/utility/math/vector3.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/core/utility/spatial/planar_grid.h>
#include <argos3/core/utility/spatial/rectangle.h>
#include <argos3/plugins/simulator/media/index_choice.h>

#include <vector>

namespace argos {

/**
 * Points sorted by cells of the ground plane, so that those near a place are adjacent; for the
 * sources of media.
 *
 * Cells only make queries fast: callers compare exact distances, so results do not depend on cells.
 * Does not allocate once it has held as many points.
 */
class CPointCells {
 public:
  /** @param arena limits of the arena, m; border cells hold the points outside of it. */
  void SetOptions(const SIndexChoice& options, const CRange<CVector3>& arena);

  /**
   * Sorts points, which must be finite.
   * @param x, y           of the points, m, world frame, (num).
   * @param typicalReach   of the queries to come, m.
   */
  void Sort(const Real* x, const Real* y, size_t num, Real typicalReach);

  /** Number of the point at a place: places 0, 1, ... are in the order of the cells. */
  UInt32 GetPoint(size_t place) const {
    ARGOS_ASSERT(place < m_order.size(),
                 "among " << m_order.size() << " points there is no place " << place);
    return m_order[place];
  }
  size_t GetNumPoints() const { return m_order.size(); }

  /**
   * Calls visit(size_t place) for every point within @p reach (m) of (@p x, @p y), seen from above,
   * and for others. Each point once. Safe on several threads at once.
   */
  template <typename VISIT>
  void ForPlacesNear(Real x, Real y, Real reach, VISIT&& visit) const {
    ForRangesNear(x, y, reach, [&visit](size_t begin, size_t end) {
      for (size_t place = begin; place < end; ++place) {
        visit(place);
      }
    });
  }
  /** The same with visit(size_t begin, size_t end) for ranges of places, of which few are empty. */
  template <typename VISIT>
  void ForRangesNear(Real x, Real y, Real reach, VISIT&& visit) const {
    if (m_hashed) {
      ForHashedPlacesNear(x, y, reach, [&visit](size_t place) { visit(place, place + 1); });
      return;
    }
    m_grid.ForRows(m_grid.CellsAround(x, y, reach), [&](UInt32 first, UInt32 last) {
      visit(size_t(m_sort.Begin(first)), size_t(m_sort.End(last)));
    });
  }

 private:
  // cells of the hash that are farther than this from the origin are one
  static constexpr SInt32 kFarCell = 1 << 30;

  // constants of the hash
  SInt32 HashI(Real x) const { return ClampToCells(x * m_inverseX, -kFarCell, kFarCell); }
  SInt32 HashJ(Real y) const { return ClampToCells(y * m_inverseY, -kFarCell, kFarCell); }
  UInt32 Bucket(SInt32 i, SInt32 j) const {
    const UInt64 key = (static_cast<UInt64>(static_cast<UInt32>(i)) << 32) | static_cast<UInt32>(j);
    return static_cast<UInt32>((key * 0x9e3779b97f4a7c15ULL) >> m_hashShift);
  }
  template <typename VISIT>
  void ForHashedPlacesNear(Real x, Real y, Real reach, VISIT&& visit) const {
    const SCellRange cells = {HashI(x - reach), HashI(x + reach), HashJ(y - reach),
                              HashJ(y + reach)};
    // compared as a real number: integers would overflow
    const Real numCells =
        (Real(cells.MaxI) - cells.MinI + 1.0) * (Real(cells.MaxJ) - cells.MinJ + 1.0);
    if (numCells > static_cast<Real>(m_order.size())) {
      for (size_t place = 0; place < m_order.size(); ++place) {
        visit(place);
      }
      return;
    }
    for (SInt32 j = cells.MinJ; j <= cells.MaxJ; ++j) {
      for (SInt32 i = cells.MinI; i <= cells.MaxI; ++i) {
        VisitBucket(i, j, visit);
      }
    }
  }
  template <typename VISIT>
  void VisitBucket(SInt32 i, SInt32 j, VISIT&& visit) const {
    const UInt32 bucket = Bucket(i, j);
    for (UInt32 place = m_sort.Begin(bucket); place < m_sort.End(bucket); ++place) {
      // other cells share the bucket
      if (m_cells[place].I == i && m_cells[place].J == j) {
        visit(place);
      }
    }
  }
  size_t ChooseCells(const Real* x, const Real* y, size_t num, Real typicalReach);
  void ChooseHash(size_t num, Real typicalReach);
  void ChooseGrid(const Real* x, const Real* y, size_t num, Real typicalReach);
  SPlanarVector ChooseSides(Real typicalReach) const;

  SIndexChoice m_options;
  CRange<CVector3> m_arena;  // m

  bool m_hashed = false;
  CPlanarGrid<> m_grid;  // is used if points are not hashed
  Real m_inverseX = 1.0, m_inverseY = 1.0;  // 1/m, of the sides of a hashed cell
  UInt32 m_hashShift = 63;
  CCountingSort m_sort;  // sorts the points by cell or bucket
  std::vector<UInt32> m_order;  // (points), by place
  std::vector<SPlanarCell> m_cells;  // (points), by place, if hashed
};

}  // namespace argos

#endif
