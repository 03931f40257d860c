#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_GRID_H

#include <argos3/core/simulator/space/positional_indices/entity_listings.h>
#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#include <argos3/core/utility/spatial/lattice.h>

#include <cstddef>
#include <iterator>
#include <vector>

namespace argos {

/**
 * An index of equal cells over a box of space.
 *
 * Entities and queries beyond the box belong to its border cells. Update() calls an operation of
 * the user that puts each entity into its cells with UpdateCell().
 */
template <class ENTITY>
class CGrid : public CPositionalIndex<ENTITY> {
  // the listings of all cells, chained by cell, and which Update() has made them
  struct SPool : CEntityListings<ENTITY, UInt32> {
    UInt32 Stamp = 1;  // low bits of the timestamp
  };
  static constexpr UInt32 kNone = SPool::kNone;

 public:
  typedef typename CPositionalIndex<ENTITY>::COperation COperation;

  /** The entities of a cell, in order of addition: a list to read, with elements ENTITY*. */
  class CEntities {
   public:
    class const_iterator;
    typedef const_iterator iterator;
    typedef ENTITY* value_type;

    const_iterator begin() const { return const_iterator(m_pool, IsCurrent() ? m_first : kNone); }
    const_iterator end() const { return const_iterator(m_pool, kNone); }
    size_t size() const { return IsCurrent() ? m_size : 0; }
    bool empty() const { return size() == 0; }
    bool exists(const ENTITY* entity) const;

   private:
    friend class CGrid;
    // lists of earlier updates are empty now
    bool IsCurrent() const { return m_pool != nullptr && m_stamp == m_pool->Stamp; }

    const SPool* m_pool = nullptr;  // of the grid; null: never filled
    UInt32 m_stamp = 0;  // SPool::Stamp when it was filled
    UInt32 m_first = kNone, m_last = kNone;  // into the pool
    UInt32 m_size = 0;  // without those removed since
  };

  struct SCell {
    UInt64 Timestamp = 0; /**< of the Update() that filled it */
    CEntities Entities; /**< as of the last Update(), without those removed since */
  };

  /** The operation that a query for cells calls for each cell. */
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
  CGrid(const CGrid&) = delete;
  CGrid& operator=(const CGrid&) = delete;

  /** Sets the operation that puts an entity into its cells; not owned. */
  void SetUpdateEntityOperation(COperation* operation) { m_updateOperation = operation; }

  void AddEntity(ENTITY& entity) override { m_pool.AddEntity(entity); }
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
  void ForEntitiesInBoxRange(const CVector3& center, const CVector3& halfSize,
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
  SPool m_pool;
};

/** Iterates over the entities of a cell. */
template <class ENTITY>
class CGrid<ENTITY>::CEntities::const_iterator {
 public:
  typedef std::forward_iterator_tag iterator_category;
  typedef ENTITY* value_type;
  typedef std::ptrdiff_t difference_type;
  typedef ENTITY* const* pointer;
  typedef ENTITY* const& reference;

  const_iterator() = default;
  reference operator*() const { return (*m_pool)[m_listing].Entity; }
  pointer operator->() const { return &(*m_pool)[m_listing].Entity; }
  const_iterator& operator++() {
    m_listing = (*m_pool)[m_listing].NextInCell;
    SkipRemoved();
    return *this;
  }
  const_iterator operator++(int) {
    const const_iterator before = *this;
    ++*this;
    return before;
  }
  friend bool operator==(const const_iterator& a, const const_iterator& b) {
    return a.m_listing == b.m_listing;
  }
  friend bool operator!=(const const_iterator& a, const const_iterator& b) { return !(a == b); }

 private:
  friend class CEntities;
  const_iterator(const SPool* pool, UInt32 listing) : m_pool(pool), m_listing(listing) {
    SkipRemoved();
  }
  void SkipRemoved() {
    while (m_listing != kNone && (*m_pool)[m_listing].Entity == nullptr) {
      m_listing = (*m_pool)[m_listing].NextInCell;
    }
  }

  const SPool* m_pool = nullptr;
  UInt32 m_listing = kNone;
};

}  // namespace argos

#include <argos3/core/simulator/space/positional_indices/grid_impl.h>

#endif
