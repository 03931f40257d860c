#ifndef ARGOS3_TESTING_SUPPORT_NO_ALLOCATION_H
#define ARGOS3_TESTING_SUPPORT_NO_ALLOCATION_H

#include <argos3/testing/support/allocation_count.h>
#include <argos3/testing/support/sanitizers.h>

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

/**
 * Checks that ticks allocate nothing after others in which lists reach their largest sizes. With
 * sanitizers a fifth of them runs, which is not enough for that, and nothing is checked: whether a
 * tick allocates does not depend on them.
 */
template <typename WORLD>
void CheckSettledTicks(WORLD& world, unsigned settlingTicks, unsigned ticks) {
  world.Step(FewerIfSanitized(settlingTicks));
  if (kHasAddressSanitizer || kHasThreadSanitizer) {
    world.Step(FewerIfSanitized(ticks));
  } else {
    CheckAllocatesNothing([&] { world.Step(ticks); });
  }
}

}  // namespace argos

#endif
