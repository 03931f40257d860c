#ifndef ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_CELL_LISTS_H
#define ARGOS3_PLUGINS_PHYSICS_ENGINES_PLANAR_CELL_LISTS_H

#include <argos3/core/simulator/geometry/periodicity.h>
#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/spatial/cell_items.h>
#include <argos3/core/utility/spatial/planar_grid.h>
#include <argos3/plugins/simulator/physics_engines/planar/footprints.h>

#include <span>
#include <vector>

namespace argos {

/** Footprints, listed in every cell from which a body may reach them. */
class CCellLists {
 public:
  /**
   * Replaces the lists.
   * @param footprints  must stay valid while they are listed.
   * @param reach       how far from a cell they are still listed in it, m.
   */
  void List(const CFramedGrid& grid, std::span<const SFootprint> footprints, Real reach);
  /** Removes all lists. */
  void Clear() { m_items.Clear(); }
  bool IsEmpty() const { return m_items.GetNumCells() == 0; }
  /** Numbers of the footprints that may be reached from a cell. */
  CCellItems::CRange Get(UInt32 cell) const { return m_items.Get(cell); }
  const SFootprint& GetFootprint(UInt32 number) const {
    ARGOS_ASSERT(number < m_footprints.size(), "there is no footprint with the number " << number);
    return m_footprints[number];
  }
  /**
   * Calls visit(UInt32 number) for the footprints listed in the cells around a point; perhaps
   * repeatedly.
   * @param radius  m: footprints up to this far away are found, and farther by the reach of List().
   */
  template <typename VISIT>
  void ForNear(const CFramedGrid& grid, Real x, Real y, Real radius, VISIT&& visit) const {
    if (IsEmpty()) {
      return;
    }
    grid.ForRows(grid.CellsAround(x, y, radius), [&](UInt32 first, UInt32 last) {
      for (const UInt32 number : m_items.Get(first, last)) {
        visit(number);
      }
    });
  }
  /** Collects the numbers of the same footprints in ascending order, each once. */
  void Find(const CFramedGrid& grid, Real x, Real y, Real radius,
            std::vector<UInt32>& numbers) const;
  /**
   * The same for all images of the point in a periodic space.
   * @param reach  m: how far from the point footprints may be listed.
   */
  void FindImages(const CFramedGrid& grid, const SPeriodicity& period, Real x, Real y, Real radius,
                  Real reach, std::vector<UInt32>& numbers) const;

 private:
  std::span<const SFootprint> m_footprints;
  CCellItems m_items;
};

}  // namespace argos

#endif
