#ifndef ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_SPACE_HASH_NATIVE_H
#define ARGOS3_COMPAT_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_SPACE_HASH_NATIVE_H

#include <argos3/core/simulator/space/positional_indices/space_hash.h>

#include <algorithm>

namespace argos {

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::SetSize(size_t numBuckets) {
  m_first.assign(std::max<size_t>(numBuckets, 1), kNone);
  m_last.assign(m_first.size(), kNone);
  m_listings.Clear();
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::SetCellSize(const CVector3& cellSize) {
  for (UInt32 axis = 0; axis < 3; ++axis) {
    if (!(cellSize[axis] > 0.0) || !std::isfinite(cellSize[axis])) {
      THROW_ARGOSEXCEPTION("the cells of a space hash need sizes > 0; got " << cellSize);
    }
    m_lattice.Origin[axis] = 0.0;
    m_lattice.CellSize[axis] = cellSize[axis];
    m_lattice.MinCell.Axis[axis] = -kMaxCell;
    m_lattice.MaxCell.Axis[axis] = kMaxCell;
  }
  m_cellSize = cellSize;
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::RemoveElement(ENTITY& element) {
  m_listings.RemoveEntity(element, [](const SCellNumber&) {});
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::SpaceToHashTable(SInt32& i, SInt32& j, SInt32& k,
                                                  const CVector3& position) const {
  m_lattice.CellOf(position).Get(i, j, k);
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::HashTableToSpace(CVector3& position, SInt32 i, SInt32 j,
                                                  SInt32 k) const {
  position.Set(HashTableToSpace(i, 0), HashTableToSpace(j, 1), HashTableToSpace(k, 2));
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::UpdateCell(SInt32 i, SInt32 j, SInt32 k, ENTITY& element) {
  if (m_first.empty()) {
    SetSize(GetElements().GetNumEntities());
  }
  const SCellNumber cell = {{i, j, k}};
  const UInt32 listing = m_listings.List(element, cell);
  if (listing == kNone) {
    return;
  }
  // added at the end of its bucket, so that the entities of a cell stay in order
  const size_t bucket = Bucket(cell);
  if (m_first[bucket] == kNone) {
    m_first[bucket] = listing;
  } else {
    m_listings[m_last[bucket]].NextInCell = listing;
  }
  m_last[bucket] = listing;
}

template <class ENTITY>
template <typename PUT>
void CAbstractSpaceHash<ENTITY>::PutAll(PUT&& put) {
  m_listings.Compact();
  SetSize(std::max(GetSize(), GetElements().GetNumEntities()));
  m_listings.ListAll(put);
}

template <class ENTITY>
template <typename VISIT>
bool CAbstractSpaceHash<ENTITY>::VisitCell(SInt32 i, SInt32 j, SInt32 k, VISIT&& visit) const {
  if (m_first.empty()) {
    return true;
  }
  const SCellNumber cell = {{i, j, k}};
  for (UInt32 index = m_first[Bucket(cell)]; index != kNone;) {
    const auto& listing = m_listings[index];
    const bool isHere = listing.Entity != nullptr && listing.Cell == cell;
    if (isHere && !visit(*listing.Entity)) {
      return false;
    }
    index = listing.NextInCell;
  }
  return true;
}

template <class ENTITY>
bool CAbstractSpaceHash<ENTITY>::CheckCell(SInt32 i, SInt32 j, SInt32 k,
                                           TElementList& elements) const {
  const size_t before = elements.size();
  VisitCell(i, j, k, [&elements](ENTITY& element) {
    elements.push_back(&element);
    return true;
  });
  return elements.size() > before;
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::Dump(std::ostream& stream) const {
  for (UInt32 index = 0; index < m_listings.GetNumListings(); ++index) {
    const auto& listing = m_listings[index];
    SInt32 i, j, k;
    listing.Cell.Get(i, j, k);
    TElementList elements;
    CheckCell(i, j, k, elements);
    if (elements.empty() || elements.front() != listing.Entity) {
      continue;
    }
    stream << "(" << i << "," << j << "," << k << "):";
    for (const ENTITY* element : elements) {
      stream << " " << element->GetId();
    }
    stream << "\n";
  }
}

template <class ENTITY>
size_t CAbstractSpaceHash<ENTITY>::Bucket(const SCellNumber& cell) const {
  // source: M. Teschner et al., "Optimized spatial hashing for collision detection of deformable
  // objects", VMV 2003, with its three primes
  constexpr UInt32 kPrimes[3] = {73856093u, 19349663u, 83492791u};
  UInt64 hash = 0;
  for (UInt32 axis = 0; axis < 3; ++axis) {
    hash ^= static_cast<UInt64>(cell.Axis[axis]) * kPrimes[axis];
  }
  return static_cast<size_t>(hash % m_first.size());
}

}  // namespace argos

#endif
