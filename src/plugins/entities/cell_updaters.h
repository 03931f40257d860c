#ifndef ARGOS3_PLUGINS_ENTITIES_CELL_UPDATERS_H
#define ARGOS3_PLUGINS_ENTITIES_CELL_UPDATERS_H

#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/space_hash.h>

namespace argos {

/** Puts an entity into the cell of a grid that contains its position, if it IsInCells(). */
template <class ENTITY>
class CCellGridUpdater : public CGrid<ENTITY>::COperation {
 public:
  explicit CCellGridUpdater(CGrid<ENTITY>& grid) : m_grid(grid) {}
  bool operator()(ENTITY& entity) override {
    if (entity.IsInCells()) {
      SInt32 cell[3];
      m_grid.PositionToCellUnsafe(cell[0], cell[1], cell[2], entity.GetPosition());
      m_grid.UpdateCell(cell[0], cell[1], cell[2], entity);
    }
    return true;
  }

 private:
  CGrid<ENTITY>& m_grid;
};

/** The same for the cells of a space hash. */
template <class ENTITY>
class CCellHashUpdater : public CSpaceHashUpdater<ENTITY> {
 public:
  void operator()(CAbstractSpaceHash<ENTITY>& hash, ENTITY& entity) override {
    if (entity.IsInCells()) {
      SInt32 cell[3];
      hash.SpaceToHashTable(cell[0], cell[1], cell[2], entity.GetPosition());
      hash.UpdateCell(cell[0], cell[1], cell[2], entity);
    }
  }
};

}  // namespace argos

#endif
