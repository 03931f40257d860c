#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_CELL_GRID_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_KINEMATICS2D_CELL_GRID_H

#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <span>
#include <vector>

namespace argos {

/**
 * A grid of equal squares over a rectangle, row by row, in a frame of cells that stay empty.
 *
 * What is outside belongs to the cells at the border; the frame is for those who look at all eight
 * neighbours of a cell.
 */
class CCellGrid {
 public:
  /** A rectangle, m. */
  struct SArea {
    Real MinX = 0.0, MinY = 0.0, MaxX = 0.0, MaxY = 0.0;
  };

  /** About as many cells as this are good for a number of bodies. */
  static Real AimedCells(size_t bodies) { return 64.0 + 2.0 * static_cast<Real>(bodies); }
  /** No grid for so many bodies has more, whatever the shape of the area. */
  static size_t MaxCells(size_t bodies) { return 5 * static_cast<size_t>(AimedCells(bodies)) + 64; }

  /** Lays the squares. @param minEdge of a square, m, > 0. */
  void Lay(const SArea& area, Real minEdge, Real aimedCells);

  const SArea& GetArea() const { return m_area; }
  /** Of a square, m. */
  Real GetEdge() const { return m_edge; }
  /** Cells from one row to the next. */
  UInt32 GetStride() const { return m_stride; }
  /** With those of the frame. */
  size_t GetNumCells() const { return m_numCells; }
  /** Changes whenever the squares are laid. */
  UInt32 GetGeneration() const { return m_generation; }

  UInt32 CellAt(Real x, Real y) const {
    return (1 + Clamp((y - m_area.MinY) * m_inverseEdge, m_numJ)) * m_stride + 1 +
           Clamp((x - m_area.MinX) * m_inverseEdge, m_numI);
  }

 private:
  static UInt32 Clamp(Real cell, UInt32 count) {
    return cell > 0.0 ? (cell < count ? static_cast<UInt32>(cell) : count - 1) : 0;
  }

  SArea m_area;
  Real m_edge = 0.0, m_inverseEdge = 0.0;  // m, 1/m
  UInt32 m_numI = 1, m_numJ = 1, m_stride = 3;
  size_t m_numCells = 9;
  UInt32 m_generation = 0;
};

/** Footprints, listed in every cell from which they may be reached. */
class CCellLists {
 public:
  /**
   * Lists them anew.
   * @param footprints  must stay where they are.
   * @param reach       how far from a cell they still count, m.
   */
  void List(const CCellGrid& grid, std::span<const SFootprint> footprints, Real reach);
  /** Nothing is listed. */
  void Clear() { m_start.clear(); }
  bool IsEmpty() const { return m_start.empty(); }
  /** Numbers of the footprints that may be reached from a cell. */
  std::span<const UInt32> Get(UInt32 cell) const {
    return {m_items.data() + m_start[cell], m_items.data() + m_start[cell + 1]};
  }
  std::span<const SFootprint> GetFootprints() const { return m_footprints; }
  /**
   * Collects the numbers of the footprints listed in the cells around a point, in order, each once.
   * @param radius  m: all that come so near, but for the reach that they are listed with, are
   * found.
   */
  void Find(const CCellGrid& grid, Real x, Real y, Real radius, std::vector<UInt32>& numbers) const;

 private:
  std::span<const SFootprint> m_footprints;
  std::vector<UInt32> m_start;  // (cells + 1) into m_items; empty: nothing is listed
  std::vector<UInt32> m_items;  // in order of cells
};

}  // namespace argos

#endif
