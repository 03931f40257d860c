#ifndef ARGOS3_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_SPACE_HASH_NATIVE_H
#define ARGOS3_CORE_SIMULATOR_SPACE_POSITIONAL_INDICES_SPACE_HASH_NATIVE_H

#include <argos3/core/simulator/space/positional_indices/space_hash.h>

#include <algorithm>

namespace argos {

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::SetSize(size_t numBuckets) {
  m_first.assign(std::max<size_t>(numBuckets, 1), kNone);
  m_last.assign(m_first.size(), kNone);
  m_listings.clear();
  m_firstOfElement.clear();
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
  const UInt32 slot = m_elements.Remove(element);
  if (slot == kNone || slot >= m_firstOfElement.size()) {
    return;
  }
  for (UInt32 listing = m_firstOfElement[slot]; listing != kNone;
       listing = m_listings[listing].NextOfElement) {
    m_listings[listing].Element = nullptr;
  }
  m_firstOfElement[slot] = kNone;
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::SpaceToHashTable(SInt32& i, SInt32& j, SInt32& k,
                                                  const CVector3& position) const {
  const SCellNumber cell = m_lattice.CellOf(position);
  i = cell.Axis[0];
  j = cell.Axis[1];
  k = cell.Axis[2];
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::HashTableToSpace(CVector3& position, SInt32 i, SInt32 j,
                                                  SInt32 k) const {
  position.Set(i * m_cellSize.GetX(), j * m_cellSize.GetY(), k * m_cellSize.GetZ());
}

template <class ENTITY>
void CAbstractSpaceHash<ENTITY>::UpdateCell(SInt32 i, SInt32 j, SInt32 k, ENTITY& element) {
  const UInt32 slot = m_updatingSlot != kNone ? m_updatingSlot : m_elements.FindSlot(element);
  if (slot == kNone) {
    return;
  }
  if (m_first.empty()) {
    SetSize(m_elements.GetNumEntities());
  }
  if (slot >= m_firstOfElement.size()) {
    m_firstOfElement.resize(m_elements.GetNumSlots(), kNone);
  }
  const UInt32 listing = static_cast<UInt32>(m_listings.size());
  m_listings.push_back({i, j, k, slot, &element, kNone, m_firstOfElement[slot]});
  m_firstOfElement[slot] = listing;
  // at the end of its bucket: entities of a cell stay in order
  const size_t bucket = Bucket(i, j, k);
  if (m_first[bucket] == kNone) {
    m_first[bucket] = listing;
  } else {
    m_listings[m_last[bucket]].NextInBucket = listing;
  }
  m_last[bucket] = listing;
}

template <class ENTITY>
template <typename PUT>
void CAbstractSpaceHash<ENTITY>::PutAll(PUT&& put) {
  m_elements.Compact();
  SetSize(std::max(GetSize(), m_elements.GetNumEntities()));
  if (m_listings.capacity() < m_elements.GetNumEntities()) {
    // room to list every element once, also those that are not listed now
    m_listings.reserve(std::max(m_elements.GetNumEntities(), 2 * m_listings.capacity()));
  }
  m_firstOfElement.assign(m_elements.GetNumSlots(), kNone);
  for (UInt32 slot = 0; slot < m_elements.GetNumSlots(); ++slot) {
    if (m_elements[slot] != nullptr) {
      m_updatingSlot = slot;
      put(*m_elements[slot]);
    }
  }
  m_updatingSlot = kNone;
}

template <class ENTITY>
template <typename VISIT>
bool CAbstractSpaceHash<ENTITY>::VisitCell(SInt32 i, SInt32 j, SInt32 k, VISIT&& visit) const {
  if (m_first.empty()) {
    return true;
  }
  for (UInt32 index = m_first[Bucket(i, j, k)]; index != kNone;) {
    const SListing& listing = m_listings[index];
    const bool here =
        listing.Element != nullptr && listing.I == i && listing.J == j && listing.K == k;
    if (here && !visit(*listing.Element)) {
      return false;
    }
    index = listing.NextInBucket;
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
  for (const SListing& listing : m_listings) {
    TElementList elements;
    CheckCell(listing.I, listing.J, listing.K, elements);
    if (elements.empty() || elements.front() != listing.Element) {
      continue;
    }
    stream << "(" << listing.I << "," << listing.J << "," << listing.K << "):";
    for (const ENTITY* element : elements) {
      stream << " " << element->GetId();
    }
    stream << "\n";
  }
}

template <class ENTITY>
size_t CAbstractSpaceHash<ENTITY>::Bucket(SInt32 i, SInt32 j, SInt32 k) const {
  // source: M. Teschner et al., "Optimized spatial hashing for collision detection of deformable
  // objects", VMV 2003, with its three primes
  const UInt64 hash = (static_cast<UInt64>(i) * 73856093u) ^ (static_cast<UInt64>(j) * 19349663u) ^
                      (static_cast<UInt64>(k) * 83492791u);
  return static_cast<size_t>(hash % m_first.size());
}

}  // namespace argos

#endif
