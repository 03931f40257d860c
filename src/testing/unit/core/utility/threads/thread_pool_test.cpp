#include <argos3/core/utility/configuration/argos_exception.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/testing/support/forked.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#include <pthread.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace thread_pool_test {

using namespace argos;
using Catch::Contains;

namespace {

const std::vector<UInt32> kThreads = {0, 1, 2, 4, 15};
const std::vector<std::string> kMethods = {"balance_quantity", "balance_length"};

// number of times that each item was assigned
std::vector<int> CountVisits(CThreadPool& pool, size_t items, size_t grain) {
  std::vector<std::atomic<int>> visits(items);
  pool.ParallelFor(items, grain, [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      ++visits[i];
    }
  });
  return std::vector<int>(visits.begin(), visits.end());
}

// assigns all items to threads that take turns
std::vector<int> Deal(CSchedule& schedule, size_t items, size_t grain, UInt32 threads) {
  std::vector<int> visits(items, 0);
  schedule.Start(items, grain, threads);
  std::vector<bool> done(threads, false);
  for (bool any = true; any;) {
    any = false;
    for (UInt32 thread = 0; thread < threads; ++thread) {
      size_t begin = 0;
      size_t end = 0;
      if (done[thread] || !schedule.Next(thread, begin, end)) {
        done[thread] = true;
        continue;
      }
      any = true;
      REQUIRE(begin < end);
      REQUIRE(end <= items);
      for (size_t i = begin; i < end; ++i) {
        ++visits[i];
      }
    }
  }
  return visits;
}

// During its lifetime the system refuses to start threads: the default stack
// size exceeds every address space.
class CNoMoreThreads {
 public:
  CNoMoreThreads() {
    pthread_getattr_default_np(&m_previous);
    pthread_attr_t attributes;
    pthread_getattr_default_np(&attributes);
    pthread_attr_setstacksize(&attributes, size_t(1) << 47);
    REQUIRE(pthread_setattr_default_np(&attributes) == 0);
    pthread_attr_destroy(&attributes);
  }
  ~CNoMoreThreads() {
    pthread_setattr_default_np(&m_previous);
    pthread_attr_destroy(&m_previous);
  }
  CNoMoreThreads(const CNoMoreThreads&) = delete;
  CNoMoreThreads& operator=(const CNoMoreThreads&) = delete;

 private:
  pthread_attr_t m_previous{};
};

}  // namespace

TEST_CASE("schedule: every item is assigned exactly once", "[core][threads]") {
  const std::string method = GENERATE(from_range(kMethods));
  const UInt32 threads = GENERATE(1U, 2U, 3U, 4U, 15U);
  const size_t items = GENERATE(1U, 2U, 15U, 16U, 17U, 1000U);
  const size_t grain = GENERATE(1U, 7U, 64U);
  CAPTURE(method, threads, items, grain);
  const auto schedule = CreateSchedule(method);
  CHECK(Deal(*schedule, items, grain, threads) == std::vector<int>(items, 1));
  // a schedule can be used for many phases
  CHECK(Deal(*schedule, items, grain, threads) == std::vector<int>(items, 1));
}

TEST_CASE("schedule: balance_quantity gives each thread one chunk of at most its equal share",
          "[core][threads]") {
  CBalanceQuantitySchedule schedule;
  schedule.Start(1000, 10, 4);
  for (UInt32 thread = 0; thread < 4; ++thread) {
    size_t begin = 0;
    size_t end = 0;
    REQUIRE(schedule.Next(thread, begin, end));
    // 100 grains for 4 threads: 25 grains each
    CHECK(begin == thread * 250);
    CHECK(end == begin + 250);
    CHECK_FALSE(schedule.Next(thread, begin, end));
  }
}

TEST_CASE("schedule: balance_length assigns chunks of the grain, lowest items first",
          "[core][threads]") {
  CBalanceLengthSchedule schedule;
  schedule.Start(25, 10, 2);
  size_t begin = 0;
  size_t end = 0;
  REQUIRE(schedule.Next(1, begin, end));
  CHECK(begin == 0);
  CHECK(end == 10);
  REQUIRE(schedule.Next(1, begin, end));
  CHECK(begin == 10);
  REQUIRE(schedule.Next(0, begin, end));
  CHECK(begin == 20);
  CHECK(end == 25);
  CHECK_FALSE(schedule.Next(0, begin, end));
  CHECK_FALSE(schedule.Next(1, begin, end));
}

TEST_CASE("schedule: an unknown method is an error with the nearest name", "[core][threads]") {
  CHECK_THROWS_WITH(CreateSchedule("balance_lenght"),
                    Contains("balance_lenght") && Contains("balance_length"));
}

TEST_CASE("thread pool: every item is processed exactly once", "[core][threads]") {
  const UInt32 threads = GENERATE(from_range(kThreads));
  const std::string method = GENERATE(from_range(kMethods));
  CAPTURE(threads, method);
  CThreadPool pool(threads, CreateSchedule(method));
  for (const size_t items : {1U, 2U, 63U, 64U, 65U, 1000U}) {
    for (const size_t grain : {1U, 64U}) {
      CAPTURE(items, grain);
      CHECK(CountVisits(pool, items, grain) == std::vector<int>(items, 1));
    }
  }
}

TEST_CASE("thread pool: without items there is no call", "[core][threads]") {
  const UInt32 threads = GENERATE(0U, 4U);
  CThreadPool pool(threads, CreateSchedule("balance_quantity"));
  int calls = 0;
  pool.ParallelFor(0, 1, [&](size_t, size_t, UInt32) { ++calls; });
  CHECK(calls == 0);
}

TEST_CASE("thread pool: the caller takes part, so P threads are P - 1 workers", "[core][threads]") {
  const UInt32 threads = GENERATE(from_range(kThreads));
  CAPTURE(threads);
  std::atomic<UInt32> started{0};
  {
    CThreadPool pool(threads, CreateSchedule("balance_quantity"), false, [&] { ++started; });
    CHECK(pool.GetNumThreads() == std::max<UInt32>(1, threads));
    std::vector<std::thread::id> ids(pool.GetNumThreads());
    pool.ParallelFor(ids.size(), 1, [&](size_t begin, size_t end, UInt32 thread) {
      CHECK(begin == thread);
      CHECK(end == begin + 1);
      ids[begin] = std::this_thread::get_id();
    });
    CHECK(ids[0] == std::this_thread::get_id());
    CHECK(std::set<std::thread::id>(ids.begin(), ids.end()).size() == ids.size());
  }
  // when the workers are joined, idle ones have started too
  CHECK(started == std::max<UInt32>(1, threads) - 1);
}

TEST_CASE("thread pool: few items are processed by the calling thread", "[core][threads]") {
  CThreadPool pool(4, CreateSchedule("balance_length"));
  pool.ParallelFor(64, 64, [&](size_t begin, size_t end, UInt32 thread) {
    CHECK(begin == 0);
    CHECK(end == 64);
    CHECK(thread == 0);
  });
}

TEST_CASE("thread pool: of several exceptions that of the lowest item is thrown",
          "[core][threads]") {
  const UInt32 threads = GENERATE(from_range(kThreads));
  const std::string method = GENERATE(from_range(kMethods));
  CAPTURE(threads, method);
  CThreadPool pool(threads, CreateSchedule(method));
  for (int repetition = 0; repetition < 50; ++repetition) {
    CHECK_THROWS_WITH(pool.ParallelFor(1000, 8,
                                       [](size_t begin, size_t end, UInt32) {
                                         for (size_t i = begin; i < end; ++i) {
                                           if (i % 100 == 37) {
                                             throw std::runtime_error("item " + std::to_string(i));
                                           }
                                         }
                                       }),
                      "item 37");
    // after the exception the pool works as before
    REQUIRE(CountVisits(pool, 100, 8) == std::vector<int>(100, 1));
  }
}

TEST_CASE("thread pool: a thrown value that is not a std::exception is passed on",
          "[core][threads]") {
  const UInt32 threads = GENERATE(0U, 4U);
  CThreadPool pool(threads, CreateSchedule("balance_length"));
  CHECK_THROWS_AS(pool.ParallelFor(100, 1, [](size_t, size_t, UInt32) { throw 42; }), int);
}

TEST_CASE("thread pool: values written in one phase are visible in the next", "[core][threads]") {
  const UInt32 threads = GENERATE(from_range(kThreads));
  const std::string method = GENERATE(from_range(kMethods));
  CAPTURE(threads, method);
  CThreadPool pool(threads, CreateSchedule(method));
  constexpr size_t kItems = 500;
  constexpr int kPhases = 200;
  std::vector<UInt64> even(kItems, 1);
  std::vector<UInt64> odd(kItems, 0);
  for (int phase = 0; phase < kPhases; ++phase) {
    auto& from = phase % 2 == 0 ? even : odd;
    auto& to = phase % 2 == 0 ? odd : even;
    // each item reads what other threads wrote in the phase before
    pool.ParallelFor(kItems, 3, [&](size_t begin, size_t end, UInt32) {
      for (size_t i = begin; i < end; ++i) {
        to[i] = (from[i] + from[kItems - 1 - i]) % 1000003;
      }
    });
  }
  // all items are equal at the start, so each phase doubles them
  UInt64 expected = 1;
  for (int phase = 0; phase < kPhases; ++phase) {
    expected = 2 * expected % 1000003;
  }
  CHECK(even == std::vector<UInt64>(kItems, expected));
}

TEST_CASE("thread pool: pinned workers give the same results", "[core][threads]") {
  CThreadPool pool(3, CreateSchedule("balance_quantity"), true);
  CHECK(CountVisits(pool, 1000, 1) == std::vector<int>(1000, 1));
}

TEST_CASE("thread pool: the constructor returns when all workers have started", "[core][threads]") {
  for (int repetition = 0; repetition < 20; ++repetition) {
    std::atomic<UInt32> started{0};
    const CThreadPool pool(4, CreateSchedule("balance_length"), false, [&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++started;
    });
    REQUIRE(started == 3);
  }
}

TEST_CASE("thread pool: an exception at the start of a worker reaches the caller",
          "[core][threads]") {
  std::atomic<UInt32> started{0};
  const auto startThirdWorkerBadly = [&] {
    if (++started == 3) {
      throw std::runtime_error("no licence for a third worker");
    }
  };
  CHECK_THROWS_WITH(CThreadPool(8, CreateSchedule("balance_length"), false, startThirdWorkerBadly),
                    "no licence for a third worker");
  CHECK(started == 7);
}

TEST_CASE("thread pool: a thread that the system does not start is an error", "[core][threads]") {
  const CNoMoreThreads noMoreThreads;
  CHECK_THROWS_WITH(CThreadPool(4, CreateSchedule("balance_length")),
                    Contains("the system started only 1 of 4 threads: "));
  // a pool of one thread starts none
  CThreadPool pool(1, CreateSchedule("balance_length"));
  CHECK(CountVisits(pool, 100, 1) == std::vector<int>(100, 1));
}

TEST_CASE("thread pool: pools can be created and destroyed repeatedly", "[core][threads]") {
  for (int repetition = 0; repetition < 50; ++repetition) {
    CThreadPool pool(4, CreateSchedule("balance_length"));
    if (repetition % 2 == 0) {
      REQUIRE(CountVisits(pool, 100, 1) == std::vector<int>(100, 1));
    }
  }
}

TEST_CASE("thread pool: a child of fork() has workers of its own", "[core][threads]") {
  // ThreadSanitizer ends a child of several threads that starts one
  if (kHasThreadSanitizer) {
    return;
  }
  const UInt32 threads = GENERATE(from_range(kThreads));
  CAPTURE(threads);
  std::atomic<UInt32> started{0};
  CThreadPool pool(threads, CreateSchedule("balance_length"), true, [&] { ++started; });
  // after a phase that failed
  CHECK_THROWS(pool.ParallelFor(100, 1, [](size_t, size_t, UInt32) { throw 42; }));
  const UInt32 numWorkers = started;
  const bool usesPool = GENERATE(true, false);
  const auto run = [&] {
    const bool isComplete = !usesPool || CountVisits(pool, 1000, 1) == std::vector<int>(1000, 1);
    pool.~CThreadPool();
    return isComplete && started == (usesPool ? 2 : 1) * numWorkers ? 0 : 1;
  };
  CHECK(CallInFork(run) == 0);
  // a child of a child
  CHECK(CallInFork([&] {
          return CountVisits(pool, 100, 1) == std::vector<int>(100, 1) ? CallInFork([&] {
            return CountVisits(pool, 100, 1) == std::vector<int>(100, 1) ? 0 : 1;
          })
                                                                       : 1;
        }) == 0);
  // nothing changes for the parent
  CHECK(CountVisits(pool, 1000, 1) == std::vector<int>(1000, 1));
  CHECK(started == numWorkers);
}

TEST_CASE("thread pool: a child of fork() in a phase ends with an error", "[core][threads]") {
  if (kHasThreadSanitizer) {
    return;
  }
  const UInt32 forker = GENERATE(0U, 1U);
  CAPTURE(forker);
  CThreadPool pool(2, CreateSchedule("balance_quantity"));
  // the child of a worker ends by itself
  int result = -1;
  pid_t child = 0;
  const auto phase = [&](size_t, size_t, UInt32 thread) {
    if (thread == forker) {
      child = fork();
      if (child == 0) {
        alarm(20);
      }
    }
  };
  if (forker == 0) {
    try {
      pool.ParallelFor(2, 1, phase);
    } catch (const std::exception& error) {
      _exit(std::string(error.what()).find("fork() between ticks") != std::string::npos ? 1 : 2);
    }
  } else {
    pool.ParallelFor(2, 1, phase);
  }
  REQUIRE(child > 0);
  int status = 0;
  REQUIRE(waitpid(child, &status, 0) == child);
  result = WIFEXITED(status) ? WEXITSTATUS(status) : -2;
  CHECK(result == 1);
  CHECK(CountVisits(pool, 100, 1) == std::vector<int>(100, 1));
}

}  // namespace thread_pool_test
