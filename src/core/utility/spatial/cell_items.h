#ifndef ARGOS3_CORE_UTILITY_SPATIAL_CELL_ITEMS_H
#define ARGOS3_CORE_UTILITY_SPATIAL_CELL_ITEMS_H

#include <argos3/core/utility/spatial/counting_sort.h>

#include <vector>

namespace argos {

/**
 * Lists items by cell, where an item, such as a wall, may be in several cells.
 *
 * The lists of all cells are one array, in the order of the cells, and within a cell in the order
 * of the items.
 */
class CCellItems {
 public:
  /** A contiguous range of items. */
  class CRange {
   public:
    CRange(const UInt32* begin, const UInt32* end) : m_begin(begin), m_end(end) {}
    const UInt32* begin() const { return m_begin; }
    const UInt32* end() const { return m_end; }
    bool IsEmpty() const { return m_begin == m_end; }

   private:
    const UInt32* m_begin;
    const UInt32* m_end;
  };

  /**
   * Replaces the lists.
   * @param numItems, numCells  the items are 0 to numItems - 1.
   * @param forCells  forCells(UInt32 item, list): calls list(UInt32 cell) for each cell of an item.
   */
  template <typename FOR_CELLS>
  void List(size_t numItems, size_t numCells, FOR_CELLS&& forCells) {
    m_listings.clear();
    for (UInt32 item = 0; item < numItems; ++item) {
      forCells(item, [this, item](UInt32 cell) { m_listings.push_back({item, cell}); });
    }
    if (m_items.capacity() < m_listings.size()) {
      // items that move are not always in as many cells
      const size_t capacity = 2 * m_listings.size();
      m_listings.reserve(capacity);
      m_items.reserve(capacity);
      m_sort.Reserve(capacity, numCells);
    }
    m_sort.Start(m_listings.size(), numCells);
    for (size_t i = 0; i < m_listings.size(); ++i) {
      m_sort.SetKey(i, m_listings[i].Cell);
    }
    m_items.resize(m_sort.Finish());
    for (size_t i = 0; i < m_listings.size(); ++i) {
      m_items[m_sort.GetPlace(i)] = m_listings[i].Item;
    }
  }
  /** Allocates for a number of cells; for twice as many where there is not enough capacity. */
  void ReserveCells(size_t numCells) {
    if (m_sort.GetKeyCapacity() < numCells) {
      m_sort.Reserve(0, 2 * numCells);
    }
  }
  /** Removes all lists. */
  void Clear() {
    m_sort.Start(0, 0);
    m_items.clear();
  }

  /** The number of cells of List(); 0 after Clear(). */
  size_t GetNumCells() const { return m_sort.GetNumKeys(); }
  /** How many times items are listed. */
  size_t GetNumListings() const { return m_items.size(); }
  /** The items of a cell. */
  CRange Get(UInt32 cell) const { return Get(cell, cell); }
  /** The items of a range of cells, ends included; those in several of them are there repeatedly.
   */
  CRange Get(UInt32 first, UInt32 last) const {
    ARGOS_ASSERT(first <= last && m_sort.End(last) <= m_items.size(),
                 "the cells from " << first << " to " << last << " have no list of items");
    return {m_items.data() + m_sort.Begin(first), m_items.data() + m_sort.End(last)};
  }

 private:
  struct SListing {
    UInt32 Item, Cell;
  };

  std::vector<SListing> m_listings;  // have the order of the items; scratch of List()
  CCountingSort m_sort;
  std::vector<UInt32> m_items;  // (listings) in the order of the cells
};

}  // namespace argos

#endif
