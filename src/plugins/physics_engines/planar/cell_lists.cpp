#include <argos3/plugins/simulator/physics_engines/planar/cell_lists.h>

#include <algorithm>

namespace argos {

void CCellLists::List(const CFramedGrid& grid, std::span<const SFootprint> footprints, Real reach) {
  m_footprints = footprints;
  if (footprints.empty()) {
    Clear();
    return;
  }
  m_items.ReserveCells(grid.GetNumCells());
  m_items.List(footprints.size(), grid.GetNumCells(), [&](UInt32 number, auto&& list) {
    const SFootprint& footprint = footprints[number];
    const SPlanarVector half = ComputeHalfBounds(footprint);
    const Real margin = reach + footprint.Radius;
    grid.ForCells(grid.CellsAround(footprint.X, footprint.Y, margin + half.X, margin + half.Y),
                  list);
  });
}

namespace {

void KeepEachOnce(std::vector<UInt32>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

}  // namespace

void CCellLists::Find(const CFramedGrid& grid, Real x, Real y, Real radius,
                      std::vector<UInt32>& numbers) const {
  numbers.clear();
  ForNear(grid, x, y, radius, [&numbers](UInt32 number) { numbers.push_back(number); });
  KeepEachOnce(numbers);
}

void CCellLists::FindImages(const CFramedGrid& grid, const SPeriodicity& period, Real x, Real y,
                            Real radius, Real reach, std::vector<UInt32>& numbers) const {
  Find(grid, x, y, radius, numbers);
  if (!period.IsOn()) {
    return;
  }
  period.ForDisplacements({x - reach, y - reach, x + reach, y + reach}, [&](Real dx, Real dy) {
    if (dx != 0.0 || dy != 0.0) {
      ForNear(grid, x + dx, y + dy, radius,
              [&numbers](UInt32 number) { numbers.push_back(number); });
    }
  });
  KeepEachOnce(numbers);
}

}  // namespace argos
