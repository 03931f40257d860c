#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_IMPL_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_IMPL_H

#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>

namespace argos {

template <class ENTITY>
CGrid<ENTITY>::CGrid(const CVector3& minCorner, const CVector3& maxCorner, SInt32 sizeI,
                     SInt32 sizeJ, SInt32 sizeK) {
  const SInt32 sizes[3] = {sizeI, sizeJ, sizeK};
  size_t numCells = 1;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (sizes[axis] < 1) {
      THROW_ARGOSEXCEPTION("a grid needs at least one cell along each axis; got "
                           << sizeI << "," << sizeJ << "," << sizeK);
    }
    const Real extent = maxCorner[axis] - minCorner[axis];
    if (!(extent > 0.0)) {
      THROW_ARGOSEXCEPTION("a grid needs a box with a volume; got the corners "
                           << minCorner << " and " << maxCorner);
    }
    m_lattice.Origin[axis] = minCorner[axis];
    m_lattice.CellSize[axis] = extent / sizes[axis];
    m_lattice.MinCell.Axis[axis] = 0;
    m_lattice.MaxCell.Axis[axis] = sizes[axis] - 1;
    numCells *= static_cast<size_t>(sizes[axis]);
  }
  m_cells.resize(numCells);
}

template <class ENTITY>
void CGrid<ENTITY>::RemoveEntity(ENTITY& entity) {
  m_pool.RemoveEntity(entity, [this](UInt32 cell) { --m_cells[cell].Entities.m_size; });
}

template <class ENTITY>
void CGrid<ENTITY>::Update() {
  // the cells are empty from here on
  ++m_timestamp;
  m_pool.Stamp = static_cast<UInt32>(m_timestamp);
  m_pool.Compact();
  m_pool.Clear();
  if (m_updateOperation == nullptr && m_pool.GetEntities().GetNumEntities() > 0) {
    THROW_ARGOSEXCEPTION("a grid with entities needs SetUpdateEntityOperation() before Update()");
  }
  m_pool.ListAll([this](ENTITY& entity) { (*m_updateOperation)(entity); });
}

template <class ENTITY>
void CGrid<ENTITY>::Reset() {
  if (m_updateOperation != nullptr) {
    Update();
  }
}

template <class ENTITY>
void CGrid<ENTITY>::UpdateCell(SInt32 i, SInt32 j, SInt32 k, ENTITY& entity) {
  ClampCoordinates(i, j, k);
  const size_t index = CellIndex(i, j, k);
  const UInt32 listing = m_pool.List(entity, static_cast<UInt32>(index));
  if (listing == kNone) {
    return;
  }
  SCell& cell = m_cells[index];
  CEntities& entities = cell.Entities;
  if (!entities.IsCurrent()) {
    cell.Timestamp = m_timestamp;
    entities.m_pool = &m_pool;
    entities.m_stamp = m_pool.Stamp;
    entities.m_first = listing;
    entities.m_size = 0;
  } else {
    // added at the end, so that the entities of a cell stay in order
    m_pool[entities.m_last].NextInCell = listing;
  }
  entities.m_last = listing;
  ++entities.m_size;
}

template <class ENTITY>
bool CGrid<ENTITY>::CEntities::exists(const ENTITY* entity) const {
  return std::find(begin(), end(), entity) != end();
}

template <class ENTITY>
void CGrid<ENTITY>::PositionToCell(SInt32& i, SInt32& j, SInt32& k,
                                   const CVector3& position) const {
  for (UInt32 axis = 0; axis < 3; ++axis) {
    const Real min = m_lattice.Origin[axis];
    const Real max = min + m_lattice.CellSize[axis] * (m_lattice.MaxCell.Axis[axis] + 1.0);
    if (!(position[axis] >= min && position[axis] <= max)) {
      THROW_ARGOSEXCEPTION("position " << position << " is outside the grid: component "
                                       << "xyz"[axis] << " must be in [" << min << ", " << max
                                       << "]");
    }
  }
  PositionToCellUnsafe(i, j, k, position);
}

template <class ENTITY>
void CGrid<ENTITY>::PositionToCellUnsafe(SInt32& i, SInt32& j, SInt32& k,
                                         const CVector3& position) const {
  m_lattice.CellOf(position).Get(i, j, k);
}

template <class ENTITY>
void CGrid<ENTITY>::ClampCoordinates(SInt32& i, SInt32& j, SInt32& k) const {
  i = std::clamp(i, SInt32(0), m_lattice.MaxCell.Axis[0]);
  j = std::clamp(j, SInt32(0), m_lattice.MaxCell.Axis[1]);
  k = std::clamp(k, SInt32(0), m_lattice.MaxCell.Axis[2]);
}

template <class ENTITY>
bool CGrid<ENTITY>::VisitEntities(const SCell& cell, COperation& operation) const {
  for (ENTITY* entity : cell.Entities) {
    if (!operation(*entity)) {
      return false;
    }
  }
  return true;
}

template <class ENTITY>
template <typename VISIT>
void CGrid<ENTITY>::VisitCells(const CVector3& minCorner, const CVector3& maxCorner,
                               VISIT&& visit) {
  ForCellsInBox(m_lattice.CellOf(minCorner), m_lattice.CellOf(maxCorner),
                [&](SInt32 i, SInt32 j, SInt32 k) { return visit(i, j, k, GetCellAt(i, j, k)); });
}

template <class ENTITY>
void CGrid<ENTITY>::GetEntitiesAt(CSet<ENTITY*, SEntityComparator>& entities,
                                  const CVector3& position) const {
  entities.clear();
  const SCellNumber number = m_lattice.CellOf(position);
  const SCell& cell = GetCellAt(number.Axis[0], number.Axis[1], number.Axis[2]);
  for (ENTITY* entity : cell.Entities) {
    entities.insert(entity);
  }
}

template <class ENTITY>
void CGrid<ENTITY>::ForAllEntities(COperation& operation) {
  m_pool.GetEntities().ForAll(operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForEntitiesInBoxRange(const CVector3& center, const CVector3& halfSize,
                                          COperation& operation) {
  VisitCells(center - halfSize, center + halfSize,
             [&](SInt32, SInt32, SInt32, SCell& cell) { return VisitEntities(cell, operation); });
}

template <class ENTITY>
void CGrid<ENTITY>::ForEntitiesAlongRay(const CRay3& ray, COperation& operation,
                                        bool stopAtClosestMatch) {
  WalkLattice(m_lattice, ray, [&](const SCellNumber& number) {
    const SCell& cell = GetCellAt(number.Axis[0], number.Axis[1], number.Axis[2]);
    if (!stopAtClosestMatch) {
      return VisitEntities(cell, operation);
    }
    bool goOn = true;
    for (ENTITY* entity : cell.Entities) {
      goOn = operation(*entity) && goOn;
    }
    return goOn;
  });
}

template <class ENTITY>
void CGrid<ENTITY>::ForAllCells(CCellOperation& operation) {
  VisitCells(CVector3(-HUGE_VAL, -HUGE_VAL, -HUGE_VAL), CVector3(HUGE_VAL, HUGE_VAL, HUGE_VAL),
             operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForCellsInBoxRange(const CVector3& center, const CVector3& halfSize,
                                       CCellOperation& operation) {
  VisitCells(center - halfSize, center + halfSize, operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForCellsInSphereRange(const CVector3& center, Real radius,
                                          CCellOperation& operation) {
  ForCellsInBoxRange(center, CVector3(radius, radius, radius), operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForCellsInCircleRange(const CVector3& center, Real radius,
                                          CCellOperation& operation) {
  ForCellsInBoxRange(center, CVector3(radius, radius, 0.0), operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForCellsInRectangleRange(const CVector3& center, const CVector2& halfSize,
                                             CCellOperation& operation) {
  ForCellsInBoxRange(center, CVector3(halfSize.GetX(), halfSize.GetY(), 0.0), operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForCellsAlongRay(const CRay3& ray, CCellOperation& operation) {
  WalkLattice(m_lattice, ray, [&](const SCellNumber& number) {
    return operation(number.Axis[0], number.Axis[1], number.Axis[2],
                     GetCellAt(number.Axis[0], number.Axis[1], number.Axis[2]));
  });
}

}  // namespace argos

#endif
