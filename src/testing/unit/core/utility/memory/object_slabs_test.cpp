#include <argos3/core/utility/memory/object_slabs.h>
#include <argos3/core/utility/memory/page_preparer.h>
#include <argos3/testing/support/sanitizers.h>

#include <catch2/catch.hpp>

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#endif

#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <set>
#include <thread>
#include <vector>

namespace object_slabs_test {

using namespace argos;

namespace {

// AddressSanitizer takes the place of the slabs
constexpr bool kAreSlabsUsed = !kHasAddressSanitizer;

struct STracked : CSlabObject {
  explicit STracked(int& alive) : Alive(alive) { ++Alive; }
  virtual ~STracked() { --Alive; }
  int& Alive;
};

struct SLarger : STracked {
  using STracked::STracked;
  double Content[20] = {};
};

struct alignas(64) SAligned : STracked {
  using STracked::STracked;
};

struct SThrows : CSlabObject {
  SThrows() { throw 42; }
  double Content[6] = {};
};

// makes the slabs current while it lives
class CCurrent {
 public:
  explicit CCurrent(CObjectSlabs& slabs) : m_previous(CObjectSlabs::SetCurrent(&slabs)) {}
  ~CCurrent() { CObjectSlabs::SetCurrent(m_previous); }
  CCurrent(const CCurrent&) = delete;
  CCurrent& operator=(const CCurrent&) = delete;

 private:
  CObjectSlabs* m_previous;
};

std::intptr_t Distance(const void* from, const void* to) {
  return reinterpret_cast<std::intptr_t>(to) - reinterpret_cast<std::intptr_t>(from);
}

}  // namespace

TEST_CASE("object slabs: objects of one size lie side by side in order of creation",
          "[core][memory]") {
  if (!kAreSlabsUsed) {
    WARN("not tested: AddressSanitizer replaces the slabs");
    return;
  }
  const CObjectSlabs::TOwner slabs = CObjectSlabs::Make();
  std::vector<void*> small;
  std::vector<void*> large;
  for (int i = 0; i < 100; ++i) {
    small.push_back(slabs->Allocate(36));
    large.push_back(slabs->Allocate(200));
  }
  for (int i = 1; i < 100; ++i) {
    // rounded up to a multiple of 8
    CHECK(Distance(small[i - 1], small[i]) == 40);
    CHECK(Distance(large[i - 1], large[i]) == 200);
  }
  CHECK(slabs->GetNumObjects() == 200);
  for (int i = 0; i < 100; ++i) {
    CObjectSlabs::Free(small[i], 40);
    CObjectSlabs::Free(large[i], 200);
  }
  CHECK(slabs->GetNumObjects() == 0);
}

TEST_CASE("object slabs: places are aligned, apart from each other, and used again",
          "[core][memory]") {
  const CObjectSlabs::TOwner slabs = CObjectSlabs::Make();
  const std::size_t bytes =
      GENERATE(1U, 8U, 16U, 17U, 24U, 48U, 500U, 4096U, 8192U, 8193U, 100000U);
  CAPTURE(bytes);
  constexpr int kObjects = 300;
  std::vector<unsigned char*> places;
  for (int round = 0; round < 3; ++round) {
    for (int i = 0; i < kObjects; ++i) {
      auto* const place = static_cast<unsigned char*>(slabs->Allocate(bytes));
      // as an object of that size may need
      REQUIRE(reinterpret_cast<std::uintptr_t>(place) % (bytes % 16 == 0 ? 16 : 8) == 0);
      std::memset(place, i % 251, bytes);
      places.push_back(place);
    }
    for (int i = 0; i < kObjects; ++i) {
      // whatever was written to the others
      REQUIRE(places[i][0] == i % 251);
      REQUIRE(places[i][bytes - 1] == i % 251);
    }
    REQUIRE(std::set<void*>(places.begin(), places.end()).size() == kObjects);
    if (round == 1) {
      // every second place is free, and is taken first
      std::set<void*> freed;
      for (int i = 1; i < kObjects; i += 2) {
        freed.insert(places[i]);
        CObjectSlabs::Free(places[i], bytes);
      }
      const bool isInSlab = kAreSlabsUsed && bytes <= CObjectSlabs::kMaxObjectBytes;
      for (int i = 1; i < kObjects; i += 2) {
        places[i] = static_cast<unsigned char*>(slabs->Allocate(bytes));
        if (isInSlab) {
          REQUIRE(freed.erase(places[i]) == 1);
        }
      }
    }
    for (unsigned char* place : places) {
      CObjectSlabs::Free(place, bytes);
    }
    places.clear();
  }
}

TEST_CASE("object slabs: a block that is reserved ahead holds the next objects, prepared or not",
          "[core][memory]") {
  if (!kAreSlabsUsed) {
    return;
  }
  constexpr std::size_t kBytes = 40;
  constexpr std::size_t kObjects = 200000;
  const CObjectSlabs::TOwner slabs = CObjectSlabs::Make();
  // without an object nothing would release it
  CHECK(slabs->ReserveAhead(1000).Bytes == 0);
  std::vector<void*> places = {slabs->Allocate(kBytes)};
  CHECK(slabs->GetNumBytes() == kBytes);
  // nothing is reserved ahead that the address space cannot hold
  CHECK(slabs->ReserveAhead(std::size_t(1) << 60).Bytes == 0);
  CHECK(slabs->ReserveAhead(0).Bytes == 0);
  const CObjectSlabs::SBlock block = slabs->ReserveAhead(kObjects * kBytes);
  REQUIRE(block.Bytes >= kObjects * kBytes);
  std::size_t numInBlock = 0;
  {
    const CPagePreparer preparer(block.Start, block.Bytes);
    // while the other thread works on the same pages; more than fit into the block
    for (std::size_t i = 0; i < 2 * kObjects; ++i) {
      void* const place = slabs->Allocate(kBytes);
      std::memset(place, static_cast<int>(i % 251), kBytes);
      places.push_back(place);
      const std::intptr_t offset = Distance(block.Start, place);
      numInBlock += offset >= 0 && offset < static_cast<std::intptr_t>(block.Bytes) ? 1 : 0;
    }
  }
  // headers of slabs, and the rest of the first slab, take the place of some
  CHECK(numInBlock > kObjects * 99 / 100);
  CHECK(numInBlock < kObjects * 2);
  CHECK(std::set<void*>(places.begin(), places.end()).size() == places.size());
  bool areKept = true;
  for (std::size_t i = 0; i < 2 * kObjects; ++i) {
    areKept = areKept && *static_cast<unsigned char*>(places[i + 1]) == i % 251;
  }
  CHECK(areKept);
  CHECK(slabs->GetNumBytes() == places.size() * kBytes);
  for (void* place : places) {
    CObjectSlabs::Free(place, kBytes);
  }
  CHECK(slabs->GetNumBytes() == 0);
  // after its release the slabs work as before
  CObjectSlabs::Free(slabs->Allocate(kBytes), kBytes);
}

#ifdef __linux__
TEST_CASE("page preparer: its pages are in memory before they are written", "[core][memory]") {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t bytes = 600 * page;
  void* const start =
      mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  REQUIRE(start != MAP_FAILED);
  const auto countPages = [&] {
    std::vector<unsigned char> isPresent(bytes / page);
    REQUIRE(mincore(start, bytes, isPresent.data()) == 0);
    std::size_t present = 0;
    for (const unsigned char each : isPresent) {
      present += each & 1U;
    }
    return present;
  };
  CHECK(countPages() == 0);
#ifdef MADV_POPULATE_WRITE
  // kernels before 5.14 do not know it
  const bool isKnown = madvise(start, page, MADV_POPULATE_WRITE) == 0;
  {
    const CPagePreparer preparer(start, bytes);
    for (int wait = 0; isKnown && countPages() < bytes / page && wait < 10000; ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  CHECK(countPages() == (isKnown ? bytes / page : 0));
#endif
  {
    // ends before its work is done
    const CPagePreparer stopped(start, bytes);
  }
  munmap(start, bytes);
}
#endif

TEST_CASE("object slabs: new and delete of derived classes", "[core][memory]") {
  const CObjectSlabs::TOwner slabs = CObjectSlabs::Make();
  const CCurrent current(*slabs);
  int alive = 0;
  {
    const auto base = std::make_unique<STracked>(alive);
    // deleted through its base, whose size is another
    const std::unique_ptr<STracked> derived = std::make_unique<SLarger>(alive);
    const auto aligned = std::make_unique<SAligned>(alive);
    CHECK(reinterpret_cast<std::uintptr_t>(aligned.get()) % 64 == 0);
    CHECK(alive == 3);
    CHECK(slabs->GetNumObjects() == (kAreSlabsUsed ? 2 : 0));
    CHECK_THROWS_AS(std::make_unique<SThrows>(), int);
    CHECK(slabs->GetNumObjects() == (kAreSlabsUsed ? 2 : 0));
  }
  CHECK(alive == 0);
  CHECK(slabs->GetNumObjects() == 0);
  alignas(STracked) std::byte place[sizeof(STracked)];
  auto* const placed = new (place) STracked(alive);
  CHECK(static_cast<void*>(placed) == place);
  placed->~STracked();
}

TEST_CASE("object slabs: objects may outlive the owner of the slabs", "[core][memory]") {
  int alive = 0;
  CObjectSlabs::TOwner slabs = CObjectSlabs::Make();
  std::unique_ptr<SLarger> first;
  std::unique_ptr<SLarger> second;
  {
    const CCurrent current(*slabs);
    first = std::make_unique<SLarger>(alive);
    second = std::make_unique<SLarger>(alive);
  }
  slabs.reset();
  first->Content[19] = 1.0;
  second->Content[0] = 2.0;
  first.reset();
  CHECK(second->Content[0] == 2.0);
  second.reset();
  CHECK(alive == 0);
}

TEST_CASE("object slabs: each thread has its current ones", "[core][memory]") {
  const CObjectSlabs::TOwner mine = CObjectSlabs::Make();
  const CCurrent current(*mine);
  CHECK(&CObjectSlabs::GetCurrent() == mine.get());
  const CObjectSlabs* elsewhere = mine.get();
  std::thread([&] { elsewhere = &CObjectSlabs::GetCurrent(); }).join();
  CHECK(elsewhere != mine.get());
}

TEST_CASE("object slabs: threads may allocate and free at once", "[core][memory][threads]") {
  const CObjectSlabs::TOwner slabs = CObjectSlabs::Make();
  std::vector<std::vector<int*>> made(4);
  const auto makeAndFreeSome = [&](int thread) {
    for (int i = 0; i < 2000; ++i) {
      int* const place = static_cast<int*>(slabs->Allocate(64));
      *place = thread * 10000 + i;
      if (i % 3 == 0) {
        CObjectSlabs::Free(place, 64);
      } else {
        made[thread].push_back(place);
      }
    }
  };
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread) {
    threads.emplace_back(makeAndFreeSome, thread);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (int thread = 0; thread < 4; ++thread) {
    int i = 0;
    for (int* place : made[thread]) {
      i += i % 3 == 0 ? 1 : 0;
      REQUIRE(*place == thread * 10000 + i++);
      CObjectSlabs::Free(place, 64);
    }
  }
  CHECK(slabs->GetNumObjects() == 0);
}

}  // namespace object_slabs_test
