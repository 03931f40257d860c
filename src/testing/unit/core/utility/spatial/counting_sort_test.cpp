#include <argos3/core/utility/spatial/cell_chains.h>
#include <argos3/core/utility/spatial/cell_items.h>
#include <argos3/core/utility/spatial/counting_sort.h>
#include <argos3/core/utility/threads/thread_pool.h>
#include <argos3/testing/support/invariants.h>
#include <argos3/testing/support/no_allocation.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace counting_sort_test {

using namespace argos;

namespace {

struct SKeys {
  size_t NumKeys;
  std::vector<UInt32> Keys;  // by item
  std::vector<UInt32> Lengths;  // by item; 0: left out
};

SKeys MakeKeys(size_t numItems, size_t numKeys, unsigned seed) {
  std::mt19937 random(seed);
  SKeys keys = {numKeys, {}, {}};
  for (size_t i = 0; i < numItems; ++i) {
    // half of the items share one key, so that runs are long, too
    const bool isShared = random() % 2 == 0;
    keys.Keys.push_back(isShared ? static_cast<UInt32>(numKeys / 2)
                                 : static_cast<UInt32>(random() % numKeys));
    keys.Lengths.push_back(random() % 4);
  }
  return keys;
}

// by key, then by item, then by place within the item
std::vector<std::pair<UInt32, UInt32>> SortByComparing(const SKeys& keys) {
  std::vector<UInt32> order;
  for (UInt32 item = 0; item < keys.Keys.size(); ++item) {
    order.push_back(item);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](UInt32 a, UInt32 b) { return keys.Keys[a] < keys.Keys[b]; });
  std::vector<std::pair<UInt32, UInt32>> places;
  for (const UInt32 item : order) {
    for (UInt32 part = 0; part < keys.Lengths[item]; ++part) {
      places.emplace_back(item, part);
    }
  }
  return places;
}

// as owners do it; a pool of several threads sets the keys on all of them
void Sort(CCountingSort& sort, const SKeys& keys, CThreadPool* pool,
          std::vector<std::pair<UInt32, UInt32>>& sorted) {
  const bool isAlone = pool == nullptr || pool->GetNumThreads() == 1;
  const auto setKeys = [&](size_t begin, size_t end, UInt32) {
    for (size_t i = begin; i < end; ++i) {
      if (keys.Lengths[i] == 0) {
        sort.LeaveOut(i);
      } else if (isAlone) {
        sort.SetKey(i, keys.Keys[i], keys.Lengths[i]);
      } else {
        sort.SetKeyOnThread(i, keys.Keys[i], keys.Lengths[i]);
      }
    }
  };
  sort.Start(keys.Keys.size(), keys.NumKeys);
  if (isAlone) {
    setKeys(0, keys.Keys.size(), 0);
  } else {
    pool->ParallelFor(keys.Keys.size(), 16, setKeys);
  }
  sorted.resize(sort.Finish());
  for (UInt32 item = 0; item < keys.Keys.size(); ++item) {
    if (!sort.IsLeftOut(item)) {
      for (UInt32 part = 0; part < keys.Lengths[item]; ++part) {
        sorted[sort.GetPlace(item) + part] = {item, part};
      }
    }
  }
  if (!isAlone) {
    sort.SortRanges(*pool, sorted, [](const std::pair<UInt32, UInt32>& place) { return place; });
  }
}

}  // namespace

TEST_CASE("counting sort: stable, whatever the number of threads", "[spatial]") {
  const UInt32 threads = GENERATE(0u, 1u, 2u, 4u);
  const size_t numItems = GENERATE(0u, 1u, 7u, 20000u);
  const size_t numKeys = GENERATE(1u, 3u, 10000u);
  CAPTURE(threads, numItems, numKeys);
  CThreadPool pool(threads, std::make_unique<CBalanceLengthSchedule>());
  CCountingSort sort;
  std::vector<std::pair<UInt32, UInt32>> sorted;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const SKeys keys = MakeKeys(numItems, numKeys, seed);
    Sort(sort, keys, threads == 0 ? nullptr : &pool, sorted);
    REQUIRE(sorted == SortByComparing(keys));
    REQUIRE(sort.GetNumKeys() == numKeys);
    for (UInt32 key = 0; key < numKeys; ++key) {
      REQUIRE(sort.Begin(key) <= sort.End(key));
      REQUIRE(std::all_of(sorted.begin() + sort.Begin(key), sorted.begin() + sort.End(key),
                          [&](const auto& place) { return keys.Keys[place.first] == key; }));
    }
    REQUIRE(sort.End(static_cast<UInt32>(numKeys) - 1) == sorted.size());
  }
}

TEST_CASE("counting sort: sorting as many items again allocates nothing", "[spatial][allocation]") {
  if (!CAllocationCount::IsAvailable()) {
    return;
  }
  CThreadPool pool(2, std::make_unique<CBalanceLengthSchedule>());
  CCountingSort sort;
  sort.Reserve(5000, 1000);
  std::vector<std::pair<UInt32, UInt32>> sorted;
  sorted.reserve(4 * 5000);
  const SKeys keys = MakeKeys(5000, 1000, 5);
  const SKeys fewer = MakeKeys(4000, 900, 6);
  CheckAllocatesNothing([&] {
    Sort(sort, keys, nullptr, sorted);
    Sort(sort, fewer, &pool, sorted);
  });
}

TEST_CASE("cell items: each item in all of its cells, in the order of items", "[spatial]") {
  const size_t numItems = GENERATE(0u, 1u, 200u);
  const size_t numCells = GENERATE(1u, 50u);
  CAPTURE(numItems, numCells);
  std::mt19937 random(7);
  CCellItems lists;
  CHECK(lists.GetNumCells() == 0);
  for (int round = 0; round < 3; ++round) {
    std::vector<std::vector<UInt32>> cellsOf(numItems);
    std::vector<std::vector<UInt32>> expected(numCells);
    size_t numListings = 0;
    for (UInt32 item = 0; item < numItems; ++item) {
      for (UInt32 cell = 0; cell < numCells; ++cell) {
        if (random() % 3 == 0) {
          cellsOf[item].push_back(cell);
          expected[cell].push_back(item);
          ++numListings;
        }
      }
    }
    lists.List(numItems, numCells, [&](UInt32 item, auto&& list) {
      for (const UInt32 cell : cellsOf[item]) {
        list(cell);
      }
    });
    REQUIRE(lists.GetNumCells() == numCells);
    REQUIRE(lists.GetNumListings() == numListings);
    std::vector<UInt32> all;
    for (UInt32 cell = 0; cell < numCells; ++cell) {
      const CCellItems::CRange range = lists.Get(cell);
      REQUIRE(std::vector<UInt32>(range.begin(), range.end()) == expected[cell]);
      all.insert(all.end(), expected[cell].begin(), expected[cell].end());
    }
    const CCellItems::CRange range = lists.Get(0, static_cast<UInt32>(numCells) - 1);
    REQUIRE(std::vector<UInt32>(range.begin(), range.end()) == all);
  }
  lists.Clear();
  CHECK(lists.GetNumCells() == 0);
  CHECK(lists.GetNumListings() == 0);
}

TEST_CASE("cell items: items that are in somewhat more cells allocate nothing",
          "[spatial][allocation]") {
  if (!CAllocationCount::IsAvailable()) {
    return;
  }
  CCellItems lists;
  const auto listIn = [&lists](UInt32 cellsPerItem) {
    lists.List(100, 40, [cellsPerItem](UInt32 item, auto&& list) {
      for (UInt32 cell = 0; cell < cellsPerItem; ++cell) {
        list((item + cell) % 40);
      }
    });
  };
  listIn(4);
  CheckAllocatesNothing([&] {
    listIn(7);
    listIn(2);
  });
}

TEST_CASE("cell chains: hold what was added and not removed, newest first", "[spatial]") {
  constexpr UInt32 kCells = 6;
  std::mt19937 random(8);
  CCellChains chains;
  chains.Resize(kCells);
  REQUIRE(chains.GetNumCells() == kCells);
  for (int round = 0; round < 3; ++round) {
    CHECK(chains.IsEmpty());
    std::vector<std::vector<UInt32>> expected(kCells);
    size_t mostLinks = 0;
    size_t numItems = 0;
    for (UInt32 step = 0; step < 400; ++step) {
      const UInt32 cell = random() % kCells;
      if (random() % 3 != 0 || expected[cell].empty()) {
        chains.Add(cell, step);
        expected[cell].insert(expected[cell].begin(), step);
        mostLinks = std::max(mostLinks, ++numItems);
      } else {
        const size_t which = random() % expected[cell].size();
        chains.Remove(cell, expected[cell][which]);
        expected[cell].erase(expected[cell].begin() + static_cast<std::ptrdiff_t>(which));
        --numItems;
      }
      std::vector<UInt32> found;
      chains.ForItems(cell, [&found](UInt32 item) { found.push_back(item); });
      REQUIRE(found == expected[cell]);
    }
    // links of removed items are used again
    CHECK(chains.GetNumLinks() == mostLinks);
    CHECK(!chains.IsEmpty());
    chains.Clear();
    for (UInt32 cell = 0; cell < kCells; ++cell) {
      chains.ForItems(cell, [](UInt32 item) { FAIL("still holds " << item); });
    }
  }
}

TEST_CASE("counting sort: items and keys of a former sort are noticed", "[spatial][invariants]") {
  CCountingSort sort;
  sort.Start(3, 3);
  for (UInt32 i = 0; i < 3; ++i) {
    sort.SetKey(i, i);
  }
  sort.Finish();
  CHECK(sort.GetPlace(2) == 2);
  sort.Start(2, 2);
  CheckCaught([&] { sort.SetKey(2, 0); }, "a sort of 2 items has no item 2");
  CheckCaught([&] { sort.SetKeyOnThread(0, 2); }, "a sort by 2 keys has no key 2");
  CheckCaught([&] { sort.LeaveOut(2); }, "has no item 2");
  CheckCaught([&] { static_cast<void>(sort.GetPlace(2)); }, "has no item 2");
  CheckCaught([&] { static_cast<void>(sort.Begin(2)); }, "has no key 2");
  CheckCaught([&] { static_cast<void>(sort.End(2)); }, "has no key 2");
  sort.LeaveOut(0);
  CheckCaught([&] { static_cast<void>(sort.GetPlace(0)); }, "has no key");
}

TEST_CASE("cell chains: removed items and former cells are noticed", "[spatial][invariants]") {
  CCellChains chains;
  chains.Resize(2);
  chains.Add(1, 7);
  chains.Remove(1, 7);
  CheckCaught([&] { chains.Remove(1, 7); }, "a removed item is not in it");
  CheckCaught([&] { chains.Add(2, 7); }, "there is no cell 2 of 2");
  CheckCaught([&] { chains.Remove(2, 7); }, "there is no cell 2 of 2");
  CheckCaught([&] { chains.ForItems(2, [](UInt32) {}); }, "there is no cell 2 of 2");
}

}  // namespace counting_sort_test
