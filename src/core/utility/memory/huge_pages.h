#ifndef ARGOS3_CORE_UTILITY_MEMORY_HUGE_PAGES_H
#define ARGOS3_CORE_UTILITY_MEMORY_HUGE_PAGES_H

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace argos {

/**
 * Asks the system to back memory that was not written yet with huge pages: for large arrays that
 * are read in no order, where nearly each access would miss the processor's table of small pages.
 * Does nothing for small arrays, and where the system has no huge pages.
 */
void AdviseHugePages(const void* start, size_t bytes) noexcept;

/**
 * Makes room for @p size elements, in huge pages if that is much memory; the capacity grows by at
 * least half.
 * @throws std::bad_alloc; the vector is then unchanged.
 */
template <typename VECTOR>
void ReserveInHugePages(VECTOR& vector, size_t size) {
  if (size <= vector.capacity()) {
    return;
  }
  VECTOR grown;
  grown.reserve(std::max(size, vector.capacity() + vector.capacity() / 2));
  AdviseHugePages(grown.data(), grown.capacity() * sizeof(typename VECTOR::value_type));
  grown.assign(std::make_move_iterator(vector.begin()), std::make_move_iterator(vector.end()));
  vector.swap(grown);
}

}  // namespace argos

#endif
