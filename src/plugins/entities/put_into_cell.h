#ifndef ARGOS3_PLUGINS_ENTITIES_PUT_INTO_CELL_H
#define ARGOS3_PLUGINS_ENTITIES_PUT_INTO_CELL_H

#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/simulator/space/positional_indices/space_hash.h>

namespace argos {

/** Puts an entity into the grid cell that contains its position. */
template <class ENTITY>
void PutIntoCell(CGrid<ENTITY>& grid, ENTITY& entity) {
  SInt32 i = 0;
  SInt32 j = 0;
  SInt32 k = 0;
  grid.PositionToCellUnsafe(i, j, k, entity.GetPosition());
  grid.UpdateCell(i, j, k, entity);
}

/** Puts an entity into the cell of a space hash that contains its position. */
template <class ENTITY>
void PutIntoCell(CAbstractSpaceHash<ENTITY>& hash, ENTITY& entity) {
  SInt32 i = 0;
  SInt32 j = 0;
  SInt32 k = 0;
  hash.SpaceToHashTable(i, j, k, entity.GetPosition());
  hash.UpdateCell(i, j, k, entity);
}

}  // namespace argos

#endif
