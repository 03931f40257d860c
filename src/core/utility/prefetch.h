#ifndef ARGOS3_CORE_UTILITY_PREFETCH_H
#define ARGOS3_CORE_UTILITY_PREFETCH_H

#include <cstddef>

namespace argos {

/**
 * How many robots ahead a loop prefetches. Loops over robots follow pointers to objects some
 * kilobytes apart, which the hardware prefetcher does not predict.
 */
constexpr size_t kBodiesAhead = 8;

/** Prefetches @p bytes from @p start. */
inline void Prefetch(const void* start, size_t bytes) {
  constexpr size_t kLine = 64;
  const char* const first = static_cast<const char*>(start);
  for (size_t offset = 0; offset < bytes; offset += kLine) {
    __builtin_prefetch(first + offset);
  }
  // the last byte may be in a further cache line
  if (bytes > 0) {
    __builtin_prefetch(first + bytes - 1);
  }
}

/** Prefetches the members of an object from @p from up to, and excluding, @p end. */
inline void PrefetchBetween(const void* from, const void* end) {
  Prefetch(from, static_cast<const char*>(end) - static_cast<const char*>(from));
}

/** Prefetches the elements of a contiguous container. */
template <typename CONTAINER>
void PrefetchElements(const CONTAINER& container) {
  Prefetch(container.data(), container.size() * sizeof(*container.data()));
}

}  // namespace argos

#endif
