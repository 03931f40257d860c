#ifndef ARGOS3_TESTING_SUPPORT_ALLOCATION_COUNT_H
#define ARGOS3_TESTING_SUPPORT_ALLOCATION_COUNT_H

#include <cstddef>
#include <string>

namespace argos {

/**
 * Counts the heap allocations of the whole process, of every thread
 * and library, during its lifetime.
 *
 * allocation_count.cpp, linked into the test program, replaces the C library's allocator by a
 * counting one, or uses the hooks of a sanitizer's allocator. Only one object may exist at a time.
 * Deallocations are not counted.
 */
class CAllocationCount {
 public:
  CAllocationCount();
  ~CAllocationCount();
  CAllocationCount(const CAllocationCount&) = delete;
  CAllocationCount& operator=(const CAllocationCount&) = delete;

  /**
   * @return false if allocations cannot be counted, which is so with allocators other than those of
   * glibc and of sanitizers. The count is then 0.
   */
  static bool IsAvailable();

  /** Allocations since construction. */
  std::size_t GetCount() const;
  /**
   * The call stack of the first allocation, innermost call first, one per
   * line; empty if there was none.
   */
  std::string DescribeFirst() const;
};

}  // namespace argos

#endif
