#ifndef ARGOS3_TESTING_SUPPORT_NO_ALLOCATION_H
#define ARGOS3_TESTING_SUPPORT_NO_ALLOCATION_H

#include <argos3/testing/support/allocation_count.h>

#include <catch2/catch.hpp>

#include <cstddef>
#include <string>

namespace argos {

/** Warns if the checks of this file are without effect, see CAllocationCount::IsAvailable(). */
inline void WarnUnlessAllocationsAreCounted() {
  if (!CAllocationCount::IsAvailable()) {
    WARN("not checked: allocations cannot be counted with this C library");
  }
}

/** Checks that run() allocates nothing; the report lists the calls of the first allocation. */
template <typename RUN>
void CheckAllocatesNothing(RUN&& run) {
  std::size_t counted = 0;
  std::string first;
  {
    const CAllocationCount count;
    run();
    counted = count.GetCount();
    first = count.DescribeFirst();
  }
  WarnUnlessAllocationsAreCounted();
  INFO("the first allocation was made by\n" << first);
  CHECK(counted == 0);
}

}  // namespace argos

#endif
