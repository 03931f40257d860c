#ifndef ARGOS3_TESTING_SCENARIO_FAULTS_FAILING_ALLOCATION_H
#define ARGOS3_TESTING_SCENARIO_FAULTS_FAILING_ALLOCATION_H

#include <cstddef>

namespace argos {

/**
 * During its lifetime some calls of operator new throw std::bad_alloc in the thread that made it. A
 * program that links failing_allocation.cpp has its own operator new, unless a sanitizer has one:
 * then no call fails.
 */
class CFailingAllocation {
 public:
  /**
   * @param first   number of the first call that fails, counted from 0.
   * @param number  of calls that fail.
   */
  CFailingAllocation(std::size_t first, std::size_t number);
  ~CFailingAllocation();
  CFailingAllocation(const CFailingAllocation&) = delete;
  CFailingAllocation& operator=(const CFailingAllocation&) = delete;

  /** Calls of operator new since the construction. */
  std::size_t GetCount() const;
};

}  // namespace argos

#endif
