#ifndef ARGOS3_CORE_UTILITY_MEMORY_LOAD_AHEAD_H
#define ARGOS3_CORE_UTILITY_MEMORY_LOAD_AHEAD_H

#include <cstddef>

namespace argos {

/** A range of memory that is to be prefetched. */
struct SMemory {
  const void* Start;
  size_t Bytes;
};

/**
 * Prefetches cache lines that will be read soon; has no effect on results. For loops
 * over objects that are scattered in memory.
 */
inline void LoadAhead(const void* start, size_t bytes) {
  constexpr size_t kLine = 64;
  const char* const first = static_cast<const char*>(start);
  for (size_t offset = 0; offset < bytes; offset += kLine) {
    __builtin_prefetch(first + offset);
  }
  // the last byte of an unaligned range may be on one more line
  if (bytes > 1) {
    __builtin_prefetch(first + bytes - 1);
  }
}

template <typename T>
void LoadAhead(const T& object) {
  LoadAhead(&object, sizeof(T));
}

}  // namespace argos

#endif
