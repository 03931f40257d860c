#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/testing/support/allocation_count.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <memory>
#include <vector>

namespace thread_pool_allocation_test {

using namespace argos;

TEST_CASE("allocation count: includes operator new and the C functions", "[testing]") {
  if (!CAllocationCount::IsAvailable()) {
    WARN("skipped: allocations cannot be counted with this C library");
    return;
  }
  // the checks allocate too, so they come last
  const CAllocationCount count;
  const size_t before = count.GetCount();
  // volatile: otherwise an unused allocation may be optimised away
  void* volatile fromC = std::malloc(10);
  auto fromNew = std::make_unique<std::vector<int>>(1000);
  void* volatile raw = fromNew.get();
  const size_t counted = count.GetCount();
  const std::string first = count.DescribeFirst();
  std::free(fromC);
  CHECK(before == 0);
  // one of malloc(), one of the vector object, one of its elements
  CHECK(counted == 3);
  CHECK(raw != nullptr);
  CHECK_FALSE(first.empty());
}

#if defined(__GLIBC__)
TEST_CASE("allocation count: it is available with the GNU C library", "[testing]") {
  // else every test that allocations are absent would pass
  CHECK(CAllocationCount::IsAvailable());
}
#endif

TEST_CASE("allocation count: includes other threads", "[testing][threads]") {
  if (!CAllocationCount::IsAvailable()) {
    WARN("skipped: allocations cannot be counted with this C library");
    return;
  }
  CThreadPool pool(2, CreateSchedule("balance_quantity"));
  std::vector<void*> memory(2, nullptr);
  const auto allocate = [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      memory[i] = std::malloc(100);
    }
  };
  // a worker creates its log buffers when it starts
  pool.ParallelFor(2, 1, [](size_t, size_t, UInt32) {});
  size_t counted = 0;
  {
    const CAllocationCount count;
    pool.ParallelFor(2, 1, allocate);
    counted = count.GetCount();
  }
  CHECK(counted == 2);
  for (void* block : memory) {
    std::free(block);
  }
}

TEST_CASE("thread pool: a parallel phase allocates nothing", "[core][threads]") {
  const UInt32 threads = GENERATE(0U, 1U, 2U, 4U, 15U);
  const std::string method = GENERATE("balance_quantity", "balance_length");
  CAPTURE(threads, method);
  CThreadPool pool(threads, CreateSchedule(method));
  std::vector<int> items(1000, 0);
  const auto phase = [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      ++items[i];
    }
  };
  pool.ParallelFor(items.size(), 1, phase);
  CheckAllocatesNothing([&] {
    for (int repetition = 0; repetition < 100; ++repetition) {
      pool.ParallelFor(items.size(), 1, phase);
    }
  });
  CHECK(items == std::vector<int>(1000, 101));
}

}  // namespace thread_pool_allocation_test
