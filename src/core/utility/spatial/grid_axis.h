#ifndef ARGOS3_CORE_UTILITY_SPATIAL_GRID_AXIS_H
#define ARGOS3_CORE_UTILITY_SPATIAL_GRID_AXIS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cmath>

namespace argos {

/**
 * Number of the cell that holds a place on an axis.
 *
 * The first and the last cell have no outer edge: they hold everything beyond them, infinities
 * included. NaN belongs to the first cell. The comparisons are made in floating point because a
 * place may be beyond what an integer holds.
 * @param place        distance from the lower edge of cell 0, in cells.
 * @param first, last  lowest and highest number of a cell.
 */
inline SInt32 ClampToCells(Real place, SInt32 first, SInt32 last) {
  return place > first ? (place < last ? static_cast<SInt32>(std::floor(place)) : last) : first;
}

/** The same for the cells 0 to @p count - 1. */
inline SInt32 ClampToCells(Real place, SInt32 count) {
  // positive places are rounded down by the conversion, which is faster than std::floor()
  return place > 0.0 ? (place < count ? static_cast<SInt32>(place) : count - 1) : 0;
}

/** An axis divided into cells of equal length, numbered from 0. */
struct SGridAxis {
  Real Min = 0.0; /**< lower edge of cell 0, m */
  Real Edge = 1.0; /**< length of a cell, m, > 0 */
  Real InverseEdge = 1.0; /**< 1/m */
  SInt32 Count = 1; /**< number of cells, >= 1 */

  SGridAxis() = default;
  SGridAxis(Real min, Real edge, SInt32 count)
      : Min(min), Edge(edge), InverseEdge(1.0 / edge), Count(count) {}

  /** Number of the cell that holds a coordinate, m. */
  SInt32 CellOf(Real coordinate) const {
    return ClampToCells((coordinate - Min) * InverseEdge, Count);
  }
  /** Lower end of a cell, m: of the first cell, minus infinity. */
  Real GetLow(SInt32 cell) const { return cell == 0 ? -HUGE_VAL : Min + cell * Edge; }
  /** Upper end of a cell, m: of the last cell, infinity. */
  Real GetHigh(SInt32 cell) const { return cell == Count - 1 ? HUGE_VAL : Min + (cell + 1) * Edge; }
};

}  // namespace argos

#endif
