#ifndef ARGOS3_CORE_UTILITY_SPATIAL_PLANAR_GRID_H
#define ARGOS3_CORE_UTILITY_SPATIAL_PLANAR_GRID_H

#include <argos3/core/utility/spatial/grid_axis.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace argos {

/** A rectangle with sides along x and y, m. */
struct SPlanarArea {
  Real MinX = 0.0, MinY = 0.0, MaxX = 0.0, MaxY = 0.0;

  /** What Include() starts from. */
  static SPlanarArea Empty() { return {HUGE_VAL, HUGE_VAL, -HUGE_VAL, -HUGE_VAL}; }
  /** Extends the area to a rectangle around a point. @param halfX, halfY  half its sides, m. */
  void Include(Real x, Real y, Real halfX = 0.0, Real halfY = 0.0) {
    MinX = std::min(MinX, x - halfX);
    MinY = std::min(MinY, y - halfY);
    MaxX = std::max(MaxX, x + halfX);
    MaxY = std::max(MaxY, y + halfY);
  }
};

/** A cell of a planar grid: number along x, number along y. */
struct SPlanarCell {
  SInt32 I = 0, J = 0;
};

/** A rectangle of cells, ends included. */
struct SCellRange {
  SInt32 MinI, MaxI, MinJ, MaxJ;

  SPlanarCell GetFirst() const { return {MinI, MinJ}; }
};

/**
 * Geometry of a grid of equal cells over a rectangle of the ground plane; owns no lists.
 *
 * Cells are numbered row by row, so the cells of a row are one range of numbers. Everything outside
 * the rectangle belongs to the border cells, see ClampToCells().
 *
 * @tparam FRAME  width of a frame of additional cells around the grid to which nothing belongs.
 * With a frame of 1, loops over the eight neighbours of a cell need no test for the border.
 */
template <UInt32 FRAME = 0>
class CPlanarGrid {
 public:
  /** A number of cells that suits a number of items: at most about two cells an item. */
  static Real AimedCells(size_t items) { return 64.0 + 2.0 * static_cast<Real>(items); }
  /** Upper bound of GetNumCells() after Cover() with AimedCells(items), for any area. */
  static size_t MaxCells(size_t items) {
    return (1 + kExtra) * (static_cast<size_t>(AimedCells(items)) + kExtra + 1);
  }

  void Lay(const SGridAxis& x, const SGridAxis& y) {
    m_x = x;
    m_y = y;
    m_stride = static_cast<UInt32>(x.Count) + 2 * FRAME;
    ++m_generation;
  }
  /**
   * Covers an area with squares.
   * @param minEdge  least edge of a square, m, > 0.
   * @param aimedCells  the squares are so large that there are few more cells than these.
   */
  void Cover(const SPlanarArea& area, Real minEdge, Real aimedCells) {
    const Real width = area.MaxX - area.MinX;
    const Real height = area.MaxY - area.MinY;
    const Real edge = std::max(
        {minEdge, std::sqrt(width * height / aimedCells), std::max(width, height) / aimedCells});
    const Real inverse = 1.0 / edge;
    Lay({area.MinX, edge, static_cast<SInt32>(width * inverse) + 1},
        {area.MinY, edge, static_cast<SInt32>(height * inverse) + 1});
  }

  const SGridAxis& GetX() const { return m_x; }
  const SGridAxis& GetY() const { return m_y; }
  /** Difference between the numbers of cells that adjoin along y. */
  UInt32 GetStride() const { return m_stride; }
  /** Includes the frame. */
  size_t GetNumCells() const { return size_t(m_stride) * (size_t(m_y.Count) + 2 * FRAME); }
  /** Changes whenever the grid is laid. */
  UInt32 GetGeneration() const { return m_generation; }

  UInt32 GetNumber(SInt32 i, SInt32 j) const {
    return (static_cast<UInt32>(j) + FRAME) * m_stride + static_cast<UInt32>(i) + FRAME;
  }
  /** Number of the cell that holds a point, m. */
  UInt32 CellAt(Real x, Real y) const { return GetNumber(m_x.CellOf(x), m_y.CellOf(y)); }
  /** The cells that an axis-aligned rectangle touches. @param reachX, reachY half its sides, m. */
  [[gnu::always_inline]] SCellRange CellsAround(Real x, Real y, Real reachX, Real reachY) const {
    return {m_x.CellOf(x - reachX), m_x.CellOf(x + reachX), m_y.CellOf(y - reachY),
            m_y.CellOf(y + reachY)};
  }
  [[gnu::always_inline]] SCellRange CellsAround(Real x, Real y, Real reach) const {
    return CellsAround(x, y, reach, reach);
  }

  /** Calls visit(UInt32 first, UInt32 last) with the ends of each row of a range, by number. */
  template <typename VISIT>
  void ForRows(const SCellRange& cells, VISIT&& visit) const {
    UInt32 first = GetNumber(cells.MinI, cells.MinJ);
    const UInt32 width = static_cast<UInt32>(cells.MaxI - cells.MinI);
    for (SInt32 j = cells.MinJ; j <= cells.MaxJ; ++j, first += m_stride) {
      visit(first, first + width);
    }
  }
  /** Calls visit(UInt32 cell) for each cell of a range, by number. */
  template <typename VISIT>
  void ForCells(const SCellRange& cells, VISIT&& visit) const {
    ForRows(cells, [&visit](UInt32 first, UInt32 last) {
      for (UInt32 cell = first; cell <= last; ++cell) {
        visit(cell);
      }
    });
  }
  /**
   * An item that is listed in all cells of a range counts, in a query for another range, in the
   * first cell that the two have in common: so it is visited once.
   * @param cell    of the query, in which the item is listed.
   * @param listed  first cell in which the item is listed.
   */
  bool IsFirstCommon(UInt32 cell, const SPlanarCell& listed, const SCellRange& query) const {
    return cell == GetNumber(std::max(listed.I, query.MinI), std::max(listed.J, query.MinJ));
  }

  /**
   * Calls visit(const SCellRange& row) for each row of which a segment crosses a part, with the
   * cells of that part.
   * @param x, y    start of the segment, m.
   * @param dx, dy  from its start to its end, m.
   * @param margin  cells that are no farther than this from the segment are included, m.
   * @param isDone  bool(): called before each row; true ends the query.
   */
  template <typename VISIT, typename DONE>
  void ForRowsAlongSegment(Real x, Real y, Real dx, Real dy, Real margin, VISIT&& visit,
                           DONE&& isDone) const {
    const SInt32 minJ = m_y.CellOf(std::min(y, y + dy) - margin);
    const SInt32 maxJ = m_y.CellOf(std::max(y, y + dy) + margin);
    for (SInt32 j = minJ; j <= maxJ && !isDone(); ++j) {
      // fractions of the segment between which it is over the row, widened by the margin
      Real first = 0.0;
      Real last = 1.0;
      if (dy != 0.0) {
        const Real atLow = (m_y.GetLow(j) - margin - y) / dy;
        const Real atHigh = (m_y.GetHigh(j) + margin - y) / dy;
        first = std::max(first, std::min(atLow, atHigh));
        last = std::min(last, std::max(atLow, atHigh));
      }
      if (first > last) {
        continue;
      }
      const Real xa = x + first * dx;
      const Real xb = x + last * dx;
      visit(SCellRange{m_x.CellOf(std::min(xa, xb) - margin), m_x.CellOf(std::max(xa, xb) + margin),
                       j, j});
    }
  }

 private:
  // cells along an axis beyond the quotient of the area's side and the cell's edge
  static constexpr size_t kExtra = 1 + 2 * FRAME;

  SGridAxis m_x, m_y;
  UInt32 m_stride = 1 + 2 * FRAME;
  UInt32 m_generation = 0;
};

/** A grid for loops over the eight neighbours of a cell. */
using CFramedGrid = CPlanarGrid<1>;

}  // namespace argos

#endif
