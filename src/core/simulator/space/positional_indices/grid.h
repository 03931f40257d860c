#ifndef ARGOS3_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_H
#define ARGOS3_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_H

#include <argos3/core/simulator/space/positional_indices/entity_list.h>
#include <argos3/core/simulator/space/positional_indices/lattice_walk.h>
#include <argos3/core/simulator/space/positional_indices/positional_index.h>

#include <vector>

namespace argos {

/**
 * An index of equal cells over a box of space.
 *
 * Nothing is out of bounds: entities and queries beyond the box belong to its border cells.
 * Update() asks an operation of the user's to put each entity into its cells with UpdateCell().
 */
template <class ENTITY>
class CGrid : public CPositionalIndex<ENTITY> {
 public:
  typedef typename CPositionalIndex<ENTITY>::COperation COperation;

  struct SCell {
    UInt64 Timestamp = 0; /**< of the Update() that filled it */
    std::vector<ENTITY*> Entities; /**< out of date unless Timestamp is the last Update()'s */
  };

  /** What a query for cells does with one. */
  class CCellOperation {
   public:
    virtual ~CCellOperation() = default;
    /** @return false to end the query. */
    virtual bool operator()(SInt32 i, SInt32 j, SInt32 k, SCell& cell) = 0;
  };

  /**
   * @param minCorner, maxCorner  of the box, m.
   * @param sizeI, sizeJ, sizeK   numbers of cells along x, y, z.
   * @throws CARGoSException if a number is < 1, or the box has no volume.
   */
  CGrid(const CVector3& minCorner, const CVector3& maxCorner, SInt32 sizeI, SInt32 sizeJ,
        SInt32 sizeK);

  /** What puts an entity into its cells; not owned. */
  void SetUpdateEntityOperation(COperation* operation) { m_updateOperation = operation; }

  void AddEntity(ENTITY& entity) override { m_entities.Add(entity); }
  void RemoveEntity(ENTITY& entity) override;
  /** @throws CARGoSException if there are entities but no operation to place them. */
  void Update() override;
  void Reset() override;

  /** Lists @p entity in a cell; numbers out of range are clamped. */
  void UpdateCell(SInt32 i, SInt32 j, SInt32 k, ENTITY& entity);

  /** @throws CARGoSException if the position (m) is outside the box. */
  void PositionToCell(SInt32& i, SInt32& j, SInt32& k, const CVector3& position) const;
  /** The same without a check: outside the box, that of the nearest border cell. */
  void PositionToCellUnsafe(SInt32& i, SInt32& j, SInt32& k, const CVector3& position) const;
  void ClampCoordinates(SInt32& i, SInt32& j, SInt32& k) const;
  /** Numbers must be in range. */
  SCell& GetCellAt(SInt32 i, SInt32 j, SInt32 k) { return m_cells[CellIndex(i, j, k)]; }
  const SCell& GetCellAt(SInt32 i, SInt32 j, SInt32 k) const { return m_cells[CellIndex(i, j, k)]; }
  SInt32 GetSizeI() const { return m_lattice.MaxCell.Axis[0] + 1; }
  SInt32 GetSizeJ() const { return m_lattice.MaxCell.Axis[1] + 1; }
  SInt32 GetSizeK() const { return m_lattice.MaxCell.Axis[2] + 1; }

  void GetEntitiesAt(CSet<ENTITY*, SEntityComparator>& entities,
                     const CVector3& position) const override;
  void ForAllEntities(COperation& operation) override;
  void ForEntitiesInSphereRange(const CVector3& center, Real radius,
                                COperation& operation) override;
  void ForEntitiesInBoxRange(const CVector3& center, const CVector3& halfSize,
                             COperation& operation) override;
  void ForEntitiesInCircleRange(const CVector3& center, Real radius,
                                COperation& operation) override;
  void ForEntitiesInRectangleRange(const CVector3& center, const CVector2& halfSize,
                                   COperation& operation) override;
  void ForEntitiesAlongRay(const CRay3& ray, COperation& operation,
                           bool stopAtClosestMatch = false) override;

  void ForAllCells(CCellOperation& operation);
  /** As the queries for entities of like names. */
  void ForCellsInSphereRange(const CVector3& center, Real radius, CCellOperation& operation);
  void ForCellsInBoxRange(const CVector3& center, const CVector3& halfSize,
                          CCellOperation& operation);
  void ForCellsInCircleRange(const CVector3& center, Real radius, CCellOperation& operation);
  void ForCellsInRectangleRange(const CVector3& center, const CVector2& halfSize,
                                CCellOperation& operation);
  void ForCellsAlongRay(const CRay3& ray, CCellOperation& operation);

 private:
  // a cell that lists an entity
  struct SListing {
    size_t Cell;
    UInt32 Next;  // of the same entity, or kNone
  };
  static constexpr UInt32 kNone = CEntityList<ENTITY>::kNone;

  size_t CellIndex(SInt32 i, SInt32 j, SInt32 k) const {
    return (static_cast<size_t>(k) * GetSizeJ() + j) * GetSizeI() + i;
  }
  bool VisitEntities(const SCell& cell, COperation& operation) const;
  template <typename VISIT>
  void VisitCells(const CVector3& minCorner, const CVector3& maxCorner, VISIT&& visit);

  SLattice m_lattice;
  std::vector<SCell> m_cells;  // i runs fastest, then j, then k
  UInt64 m_timestamp = 1;
  COperation* m_updateOperation = nullptr;
  CEntityList<ENTITY> m_entities;
  UInt32 m_updatingSlot = kNone;

  // where each entity is listed, so that it can be removed between updates
  std::vector<SListing> m_listings;
  std::vector<UInt32> m_firstListing;  // by slot; kNone: not listed
};

}  // namespace argos

#include <argos3/core/simulator/space/positional_indices/grid_impl.h>

#endif
