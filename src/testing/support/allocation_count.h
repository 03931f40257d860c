#ifndef ARGOS3_TESTING_SUPPORT_ALLOCATION_COUNT_H
#define ARGOS3_TESTING_SUPPORT_ALLOCATION_COUNT_H

#include <cstddef>
#include <string>

namespace argos {

/**
 * Counts the heap allocations of the whole process, of every thread and library, while it lives.
 *
 * allocation_count.cpp, linked into the test program, puts itself before the C library's allocator,
 * or asks the allocator of a sanitizer.
 * One object at a time. Releasing memory is not counted.
 */
class CAllocationCount {
 public:
  CAllocationCount();
  ~CAllocationCount();
  CAllocationCount(const CAllocationCount&) = delete;
  CAllocationCount& operator=(const CAllocationCount&) = delete;

  /**
   * False where it cannot count, which is with neither glibc's allocator nor a sanitizer's. Then
   * the count is 0.
   */
  static bool IsAvailable();

  /** Allocations since construction. */
  std::size_t GetCount() const;
  /** The calls that led to the first one, innermost first, one a line; empty if there was none. */
  std::string DescribeFirst() const;
};

}  // namespace argos

#endif
