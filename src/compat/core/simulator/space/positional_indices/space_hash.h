#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_SPACE_HASH_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_SPACE_HASH_H

#include <argos3/core/simulator/space/positional_indices/entity_listings.h>
#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/spatial/lattice.h>

#include <ostream>
#include <vector>

namespace argos {

/**
 * A grid without bounds, in which empty cells take no memory: a hash table from the numbers of a
 * cell to the entities in it, in order of their addition.
 */
template <class ENTITY>
class CAbstractSpaceHash {
 public:
  typedef std::vector<ENTITY*> TElementList;

  CAbstractSpaceHash() { SetCellSize(CVector3(1.0, 1.0, 1.0)); }
  virtual ~CAbstractSpaceHash() = default;

  /** Sets the number of buckets; Update() raises it if there are more entities. */
  void SetSize(size_t numBuckets);
  size_t GetSize() const { return m_first.size(); }
  /** @param cellSize m. @throws CARGoSException if a component is not > 0. */
  void SetCellSize(const CVector3& cellSize);
  const CVector3& GetCellSize() const { return m_cellSize; }

  void AddElement(ENTITY& element) { m_listings.AddEntity(element); }
  void RemoveElement(ENTITY& element);
  /** Replaces the content of all cells by what is in them now. */
  virtual void Update() = 0;

  /** Numbers of the cell that holds a position (m). */
  void SpaceToHashTable(SInt32& i, SInt32& j, SInt32& k, const CVector3& position) const;
  /** @param axis 0 to 2. */
  SInt32 SpaceToHashTable(Real coordinate, UInt32 axis) const {
    return m_lattice.NumberOf(coordinate, axis);
  }
  /** Lowest corner of a cell, m. */
  void HashTableToSpace(CVector3& position, SInt32 i, SInt32 j, SInt32 k) const;
  /** The same along one axis. @param axis 0 to 2. */
  Real HashTableToSpace(SInt32 number, UInt32 axis) const {
    return number * m_lattice.CellSize[axis];
  }

  /** Lists an entity in a cell. */
  void UpdateCell(SInt32 i, SInt32 j, SInt32 k, ENTITY& element);
  /** Appends the entities of a cell. @return true if there are any. */
  bool CheckCell(SInt32 i, SInt32 j, SInt32 k, TElementList& elements) const;
  /** Calls visit(ENTITY&) for each entity of a cell until that returns false. @return that. */
  template <typename VISIT>
  bool VisitCell(SInt32 i, SInt32 j, SInt32 k, VISIT&& visit) const;

  /** Writes the cells that hold something, one a line, in order of their first entity. */
  void Dump(std::ostream& stream) const;

  const CEntityList<ENTITY>& GetElements() const { return m_listings.GetEntities(); }
  const SLattice& GetLattice() const { return m_lattice; }
  /** How many times entities are listed in cells. */
  size_t GetNumListings() const { return m_listings.GetNumListings(); }

 protected:
  /** Calls put(ENTITY&) for every entity, with an empty table. */
  template <typename PUT>
  void PutAll(PUT&& put);

 private:
  typedef CEntityListings<ENTITY, SCellNumber> TListings;
  static constexpr UInt32 kNone = TListings::kNone;
  // half of what an integer holds: sums of cell numbers do not overflow
  static constexpr SInt32 kMaxCell = 1 << 30;

  size_t Bucket(const SCellNumber& cell) const;

  CVector3 m_cellSize;  // m
  SLattice m_lattice;
  TListings m_listings;  // chained by bucket
  std::vector<UInt32> m_first, m_last;  // by bucket: into m_listings; kNone: empty
};

/** Puts an entity into its cells, with CAbstractSpaceHash::UpdateCell(). */
template <class ENTITY>
class CSpaceHashUpdater {
 public:
  virtual ~CSpaceHashUpdater() = default;
  virtual void operator()(CAbstractSpaceHash<ENTITY>& hash, ENTITY& element) = 0;
};

/** @tparam UPDATER  a CSpaceHashUpdater<ENTITY> that needs no arguments. */
template <class ENTITY, class UPDATER>
class CSpaceHash : public CAbstractSpaceHash<ENTITY> {
 public:
  void Update() override {
    this->PutAll([this](ENTITY& element) { m_updater(*this, element); });
  }

 private:
  UPDATER m_updater;
};

}  // namespace argos

#include <argos3/core/simulator/space/positional_indices/space_hash_native.h>

#ifndef ARGOS_WITHOUT_COMPANIONS
#include <argos3/core/simulator/space/positional_indices/positional_index.h>
#endif

#endif
