#ifndef ARGOS3_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_IMPL_H
#define ARGOS3_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_IMPL_H

#include <argos3/core/simulator/space/positional_indices/grid.h>
#include <argos3/core/utility/configuration/argos_exception.h>

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
  const UInt32 slot = m_entities.Remove(entity);
  if (slot == kNone || slot >= m_firstListing.size()) {
    return;
  }
  for (UInt32 number = m_firstListing[slot]; number != kNone;) {
    SListing& listing = m_pool.Listings[number];
    listing.Entity = nullptr;
    --m_cells[listing.Cell].Entities.m_size;
    number = listing.NextOfEntity;
  }
  m_firstListing[slot] = kNone;
}

// all cells are empty from then on, and there is room to list every entity once
template <class ENTITY>
void CGrid<ENTITY>::StartUpdate() {
  ++m_timestamp;
  m_pool.Stamp = static_cast<UInt32>(m_timestamp);
  m_pool.Listings.clear();
  if (m_pool.Listings.capacity() < m_entities.GetNumEntities()) {
    m_pool.Listings.reserve(std::max(m_entities.GetNumEntities(), 2 * m_pool.Listings.capacity()));
  }
  m_firstListing.assign(m_entities.GetNumSlots(), kNone);
}

template <class ENTITY>
void CGrid<ENTITY>::Update() {
  m_entities.Compact();
  StartUpdate();
  if (m_updateOperation == nullptr && m_entities.GetNumEntities() > 0) {
    THROW_ARGOSEXCEPTION("a grid with entities needs SetUpdateEntityOperation() before Update()");
  }
  for (UInt32 slot = 0; slot < m_entities.GetNumSlots(); ++slot) {
    if (m_entities[slot] != nullptr) {
      m_updatingSlot = slot;
      (*m_updateOperation)(*m_entities[slot]);
    }
  }
  m_updatingSlot = kNone;
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
  const UInt32 slot = m_updatingSlot != kNone ? m_updatingSlot : m_entities.FindSlot(entity);
  if (slot == kNone) {
    return;
  }
  if (slot >= m_firstListing.size()) {
    m_firstListing.resize(m_entities.GetNumSlots(), kNone);
  }
  const UInt32 listing = static_cast<UInt32>(m_pool.Listings.size());
  const size_t index = CellIndex(i, j, k);
  m_pool.Listings.push_back({&entity, static_cast<UInt32>(index), kNone, m_firstListing[slot]});
  m_firstListing[slot] = listing;

  SCell& cell = m_cells[index];
  CEntities& entities = cell.Entities;
  if (!entities.IsCurrent()) {
    cell.Timestamp = m_timestamp;
    entities.m_pool = &m_pool;
    entities.m_stamp = m_pool.Stamp;
    entities.m_first = listing;
    entities.m_size = 0;
  } else {
    // at the end: entities of a cell stay in order
    m_pool.Listings[entities.m_last].NextInCell = listing;
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
  const SCellNumber cell = m_lattice.CellOf(position);
  i = cell.Axis[0];
  j = cell.Axis[1];
  k = cell.Axis[2];
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
  const SCellNumber min = m_lattice.CellOf(minCorner);
  const SCellNumber max = m_lattice.CellOf(maxCorner);
  for (SInt32 k = min.Axis[2]; k <= max.Axis[2]; ++k) {
    for (SInt32 j = min.Axis[1]; j <= max.Axis[1]; ++j) {
      for (SInt32 i = min.Axis[0]; i <= max.Axis[0]; ++i) {
        if (!visit(i, j, k, GetCellAt(i, j, k))) {
          return;
        }
      }
    }
  }
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
  for (UInt32 slot = 0; slot < m_entities.GetNumSlots(); ++slot) {
    if (m_entities[slot] != nullptr && !operation(*m_entities[slot])) {
      return;
    }
  }
}

template <class ENTITY>
void CGrid<ENTITY>::ForEntitiesInBoxRange(const CVector3& center, const CVector3& halfSize,
                                          COperation& operation) {
  VisitCells(center - halfSize, center + halfSize,
             [&](SInt32, SInt32, SInt32, SCell& cell) { return VisitEntities(cell, operation); });
}

template <class ENTITY>
void CGrid<ENTITY>::ForEntitiesInSphereRange(const CVector3& center, Real radius,
                                             COperation& operation) {
  ForEntitiesInBoxRange(center, CVector3(radius, radius, radius), operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForEntitiesInCircleRange(const CVector3& center, Real radius,
                                             COperation& operation) {
  ForEntitiesInBoxRange(center, CVector3(radius, radius, 0.0), operation);
}

template <class ENTITY>
void CGrid<ENTITY>::ForEntitiesInRectangleRange(const CVector3& center, const CVector2& halfSize,
                                                COperation& operation) {
  ForEntitiesInBoxRange(center, CVector3(halfSize.GetX(), halfSize.GetY(), 0.0), operation);
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
