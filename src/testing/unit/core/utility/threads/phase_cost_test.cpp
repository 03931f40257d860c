#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/threads/phase_cost.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/testing/support/invariants.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace phase_cost_test {

using namespace argos;
using Catch::Contains;
using Catch::WithinAbs;

namespace {

using TChunks = std::set<std::pair<size_t, size_t>>;

// the chunks of a phase; the calling thread needs that time for each item
TChunks ChunksOf(CThreadPool& pool, CPhaseCost& cost, size_t items,
                 std::chrono::microseconds timeOfItem = std::chrono::microseconds(0)) {
  TChunks chunks;
  std::mutex mutex;
  pool.ParallelFor(items, cost, [&](size_t begin, size_t end, UInt32) {
    std::this_thread::sleep_for(timeOfItem * static_cast<int>(end - begin));
    const std::lock_guard<std::mutex> lock(mutex);
    chunks.emplace(begin, end);
  });
  return chunks;
}

// chunks of a length that together are all items
TChunks ChunksOfLength(size_t length, size_t items) {
  TChunks chunks;
  for (size_t begin = 0; begin < items; begin += length) {
    chunks.emplace(begin, std::min(items, begin + length));
  }
  return chunks;
}

/** One item at a time, in turns. "in_turns" */
class CInTurnsSchedule : public CSchedule {
 public:
  void Start(size_t items, size_t, UInt32 threads) override {
    m_items = items;
    m_threads = threads;
    m_next.resize(threads);
    for (UInt32 thread = 0; thread < threads; ++thread) {
      m_next[thread] = thread;
    }
  }
  bool Next(UInt32 thread, size_t& begin, size_t& end) override {
    begin = m_next[thread];
    end = begin + 1;
    m_next[thread] += m_threads;
    return begin < m_items;
  }

 private:
  size_t m_items = 0;
  UInt32 m_threads = 1;
  std::vector<size_t> m_next;
};

/** Leaves out the last item, or deals one too many. */
template <int OFFSET>
class CWrongSchedule : public CBalanceLengthSchedule {
 public:
  void Start(size_t items, size_t grain, UInt32 threads) override {
    CBalanceLengthSchedule::Start(items + size_t(OFFSET), grain, threads);
  }
};

REGISTER_SCHEDULE(CInTurnsSchedule, "in_turns", "a user", "1.0", "In turns.", "In turns.", "Test")

}  // namespace

TEST_CASE("phase cost: without a measurement, each thread gets four chunks", "[core][threads]") {
  CHECK(DivideIntoChunks(60, 2, 64) == 8);  // 60 items in 8 chunks
  CHECK(DivideIntoChunks(3, 2, 64) == 1);
  CHECK(DivideIntoChunks(10000, 2, 64) == 64);
  CHECK(DivideIntoChunks(0, 2, 64) == 1);
  CHECK(CPhaseCost(64).ChooseGrain(60, 2) == 8);
  CHECK(CPhaseCost(1).ChooseGrain(16, 2) == 1);
}

TEST_CASE("phase cost: a chunk contains 20 us of work, unless there would be too few chunks",
          "[core][threads]") {
  const auto withItemsOf = [](Real seconds) {
    CPhaseCost measured(64);
    measured.Add(10, 10.0 * seconds);
    return measured;
  };
  // 60 items: at most 8 in a chunk for 2 threads
  CHECK(withItemsOf(1e-3).ChooseGrain(60, 2) == 1);
  CHECK(withItemsOf(15e-6).ChooseGrain(60, 2) == 1);
  CHECK(withItemsOf(4.9e-6).ChooseGrain(60, 2) == 4);
  CHECK(withItemsOf(2e-6).ChooseGrain(60, 2) == 8);
  CHECK(withItemsOf(1e-6).ChooseGrain(10000, 2) == 20);
  CHECK(withItemsOf(0.1e-6).ChooseGrain(10000, 2) == 64);
}

TEST_CASE("sharing cost: a phase is shared if threads save more than it costs to share it",
          "[core][threads]") {
  CSharingCost cost;
  CHECK(cost.GetSeconds() == 5e-6);
  CHECK(cost.IsWorthwhile(1, 2));
  // 100 items of 0.5 us: 25 us for each of 2 threads, so 35 us too many, counted as 4 times 5 us
  cost.AddShared(100, 60e-6, 2, 50, 25e-6);
  CHECK_THAT(cost.GetSeconds(), WithinAbs(5e-6 + (20e-6 - 5e-6) / 8.0, 1e-15));
  // half of the work is saved, three quarters with 4 threads: 27.5 and 18.3 items take 6.875 us
  CHECK_FALSE(cost.IsWorthwhile(27, 2));
  CHECK(cost.IsWorthwhile(28, 2));
  CHECK_FALSE(cost.IsWorthwhile(18, 4));
  CHECK(cost.IsWorthwhile(19, 4));
  // no time lost counts as the least cost, with the weight of fast measurements
  cost.AddShared(100, 20e-6, 2, 50, 25e-6);
  CHECK_THAT(cost.GetSeconds(), WithinAbs(5e-6 + 1.875e-6 / 2.0, 1e-15));
  // a caller that did nothing tells nothing of the work
  cost.AddShared(100, 25e-6, 2, 0, 0.0);
  CHECK_THAT(cost.GetSeconds(), WithinAbs(5e-6 + 1.875e-6 / 4.0, 1e-15));
}

TEST_CASE("sharing cost: a phase that one thread does alone is shared again after a while",
          "[core][threads]") {
  CSharingCost cost;
  for (int i = 0; i < 40; ++i) {
    cost.AddShared(100, 100e-6, 2, 50, 10e-6);
  }
  // 20 us of work, and 90 us to share them
  CHECK_THAT(cost.GetSeconds(), WithinAbs(90e-6, 1e-6));
  int alone = 0;
  while (!cost.IsWorthwhile(100, 2)) {
    cost.AddAlone(100, 20e-6);
    ++alone;
  }
  // 512 ln(90 / 10)
  CHECK_THAT(alone, WithinAbs(1125.0, 10.0));
  // 1 us of work never is
  for (int i = 0; i < 10000; ++i) {
    cost.AddAlone(10, 1e-6);
  }
  CHECK(cost.GetSeconds() == CSharingCost::kMinSeconds);
  CHECK_FALSE(cost.IsWorthwhile(10, 16));
}

TEST_CASE("phase cost: measurements are averaged, and slow ones count less", "[core][threads]") {
  CPhaseCost cost(64);
  CHECK(cost.GetSecondsPerItem() == 0.0);
  cost.Add(0, 1.0);
  cost.Add(10, 0.0);
  CHECK(cost.GetSecondsPerItem() == 0.0);
  cost.Add(4, 4.0);
  CHECK(cost.GetSecondsPerItem() == 1.0);
  cost.Add(1, 0.5);
  CHECK(cost.GetSecondsPerItem() == 0.75);
  // a suspended thread: an eighth of three times the cost
  cost.Add(1, 1e6);
  CHECK(cost.GetSecondsPerItem() == 0.75 * (1.0 + 3.0 / 8.0));
}

TEST_CASE("phase cost: a fixed grain is used whatever the cost", "[core][threads]") {
  CPhaseCost cost(64);
  cost.SetGrain(100);
  CHECK_FALSE(cost.IsMeasured());
  cost.Add(10, 1e-9);
  CHECK(cost.ChooseGrain(60, 2) == 100);
  CHECK(cost.ChooseGrain(1000, 2) == 100);
}

TEST_CASE("thread pool: phases with a cost are dealt in the chunks that it chooses",
          "[core][threads]") {
  CThreadPool pool(3, CreateSchedule("balance_length"));
  CPhaseCost fixed(64);
  fixed.SetGrain(7);
  CHECK(ChunksOf(pool, fixed, 100) == ChunksOfLength(7, 100));
  // all items in one chunk: on the calling thread
  CHECK(ChunksOf(pool, fixed, 7) == TChunks{{0, 7}});
  CHECK(fixed.GetSecondsPerItem() == 0.0);

  CPhaseCost measured(64);
  CHECK(ChunksOf(pool, measured, 48, std::chrono::microseconds(100)) == ChunksOfLength(4, 48));
  // sleeping takes at least its time
  CHECK(measured.GetSecondsPerItem() >= 100e-6);
  CHECK(ChunksOf(pool, measured, 48, std::chrono::microseconds(100)) == ChunksOfLength(1, 48));
}

TEST_CASE("thread pool: the calling thread does alone what threads would make slower",
          "[core][threads]") {
  const auto countRuns = [](CThreadPool& pool) {
    std::atomic<int> chunks{0};
    pool.ParallelFor(100, 10, [&](size_t, size_t, UInt32) { ++chunks; });
    return chunks.load();
  };
  CThreadPool pool(2, CreateSchedule("balance_length"));
  CHECK(countRuns(pool) == 10);
  // some nanoseconds of work; more than one phase if the first one was interrupted
  int phases = 1;
  while (phases < 1000 && countRuns(pool) == 10) {
    ++phases;
  }
  const bool isAlwaysShared = kChecksInvariants || kHasThreadSanitizer;
  CHECK((phases < 1000) == !isAlwaysShared);
  CHECK(countRuns(pool) == (isAlwaysShared ? 10 : 1));

  CThreadPool sharing(2, CreateSchedule("balance_length"));
  sharing.SetSharesAlways(true);
  for (int i = 0; i < 100; ++i) {
    CHECK(countRuns(sharing) == 10);
  }
}

TEST_CASE("schedule: one that a library registers is found by its label", "[core][threads]") {
  const UInt32 threads = GENERATE(2U, 4U);
  CThreadPool pool(threads, CreateSchedule("in_turns"));
  std::vector<UInt32> threadOf(21, 99);
  pool.ParallelFor(threadOf.size(), 1, [&](size_t begin, size_t end, UInt32 thread) {
    REQUIRE(end == begin + 1);
    threadOf[begin] = thread;
  });
  for (UInt32 i = 0; i < threadOf.size(); ++i) {
    CHECK(threadOf[i] == i % threads);
  }
  CHECK_THROWS_WITH(CreateSchedule("in_turn"), Contains("in_turns"));
}

TEST_CASE("thread pool: a schedule that does not deal every item once is an error",
          "[core][threads][errors]") {
  const auto none = [](size_t, size_t, UInt32) {};
  CThreadPool forgetful(2, std::make_unique<CWrongSchedule<-1>>());
  CHECK_THROWS_WITH(forgetful.ParallelFor(10, 1, none), Contains("dealt 9 of 10 items"));
  CThreadPool excessive(2, std::make_unique<CWrongSchedule<1>>());
  CHECK_THROWS_WITH(excessive.ParallelFor(10, 1, none),
                    Contains("items 10 to 11") && Contains("there are 10"));
}

}  // namespace phase_cost_test
