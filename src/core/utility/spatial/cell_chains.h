#ifndef ARGOS3_CORE_UTILITY_SPATIAL_CELL_CHAINS_H
#define ARGOS3_CORE_UTILITY_SPATIAL_CELL_CHAINS_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <cstddef>
#include <vector>

namespace argos {

/**
 * Lists items by cell, for items that are added one by one between two sorts.
 *
 * Adding takes constant time, Clear() time in proportion to the items, not to the cells.
 */
class CCellChains {
 public:
  /** Sets the number of cells, and removes all items. */
  void Resize(size_t numCells) {
    m_heads.assign(numCells, kEnd);
    m_usedCells.clear();
    m_links.clear();
    m_freeLink = kEnd;
  }
  size_t GetNumCells() const { return m_heads.size(); }
  /** @return true if no item was added since Clear(), even if all were removed. */
  bool IsEmpty() const { return m_usedCells.empty(); }
  /** How many links are in use or were in use since Clear(). */
  size_t GetNumLinks() const { return m_links.size(); }

  void Add(UInt32 cell, UInt32 item) {
    CheckCell(cell);
    if (m_heads[cell] == kEnd) {
      m_usedCells.push_back(cell);
    }
    UInt32 link = m_freeLink;
    if (link == kEnd) {
      link = static_cast<UInt32>(m_links.size());
      m_links.emplace_back();
    } else {
      m_freeLink = m_links[link].Next;
    }
    m_links[link] = {item, m_heads[cell]};
    m_heads[cell] = link;
  }
  /** @param item  must be in the chain of the cell; removed once. */
  void Remove(UInt32 cell, UInt32 item) {
    CheckCell(cell);
    UInt32* place = &m_heads[cell];
    while (At(*place).Item != item) {
      place = &m_links[*place].Next;
    }
    const UInt32 link = *place;
    *place = m_links[link].Next;
    m_links[link].Next = m_freeLink;
    m_freeLink = link;
  }
  void Clear() {
    for (const UInt32 cell : m_usedCells) {
      m_heads[cell] = kEnd;
    }
    m_usedCells.clear();
    m_links.clear();
    m_freeLink = kEnd;
  }

  /** Calls visit(UInt32 item) for each item of a cell, the one added last first. */
  template <typename VISIT>
  void ForItems(UInt32 cell, VISIT&& visit) const {
    CheckCell(cell);
    for (UInt32 link = m_heads[cell]; link != kEnd; link = m_links[link].Next) {
      visit(At(link).Item);
    }
  }

 private:
  static constexpr UInt32 kEnd = ~UInt32(0);

  struct SLink {
    UInt32 Item = 0;
    UInt32 Next = kEnd;  // next item of the same chain
  };

  void CheckCell([[maybe_unused]] UInt32 cell) const {
    ARGOS_ASSERT(cell < m_heads.size(), "there is no cell " << cell << " of " << m_heads.size());
  }
  const SLink& At(UInt32 link) const {
    ARGOS_ASSERT(link < m_links.size(), "a chain of items has no link " << link << ": a removed "
                                                                        << "item is not in it");
    return m_links[link];
  }

  std::vector<UInt32> m_heads;  // (cells) into m_links, or kEnd
  std::vector<UInt32> m_usedCells;  // cells whose chain is, or was, not empty; perhaps repeatedly
  std::vector<SLink> m_links;
  UInt32 m_freeLink = kEnd;  // chain of links to use again
};

}  // namespace argos

#endif
