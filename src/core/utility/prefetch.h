#ifndef ARGOS3_CORE_UTILITY_PREFETCH_H
#define ARGOS3_CORE_UTILITY_PREFETCH_H

#include <cstddef>

namespace argos {

/**
 * Loops over robots follow pointers to objects that lie some kilobytes apart, which the processor
 * does not foresee. So they ask for the memory of the robot that comes this much later.
 */
constexpr size_t kBodiesAhead = 8;

/** Asks for @p bytes from @p start to be brought into the cache; changes nothing else. */
inline void Prefetch(const void* start, size_t bytes) {
  constexpr size_t kLine = 64;
  const char* const first = static_cast<const char*>(start);
  for (size_t offset = 0; offset < bytes; offset += kLine) {
    __builtin_prefetch(first + offset);
  }
  // what begins within a line may end in one more
  if (bytes > 0) {
    __builtin_prefetch(first + bytes - 1);
  }
}

/** The same for the members of an object from @p from up to, but without, @p end. */
inline void PrefetchBetween(const void* from, const void* end) {
  Prefetch(from, static_cast<const char*>(end) - static_cast<const char*>(from));
}

/** The same for what a std::vector or the like holds. */
template <typename CONTAINER>
void PrefetchElements(const CONTAINER& container) {
  Prefetch(container.data(), container.size() * sizeof(*container.data()));
}

}  // namespace argos

#endif
