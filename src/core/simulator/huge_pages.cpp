#include <argos3/core/simulator/huge_pages.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>

namespace argos {

#if defined(__linux__) && defined(MADV_HUGEPAGE)

namespace {

constexpr uintptr_t kHugePage = uintptr_t(2) << 20;
constexpr uintptr_t kWorthwhile = uintptr_t(64) << 20;
// MADV_COLLAPSE of Linux 6.1 and later, which the C library may not know; earlier ones refuse it
constexpr int kCollapse = 25;

struct SAddresses {
  uintptr_t Begin = 0, End = 0;
};

// The memory that malloc() grows by brk(). It is listed in several parts if they differ in what was
// wished for them; proc(5) describes the file.
SAddresses FindHeap() {
  SAddresses heap;
  std::ifstream maps("/proc/self/maps");
  std::string line;
  while (std::getline(maps, line)) {
    SAddresses part;
    if (line.find("[heap]") != std::string::npos &&
        std::sscanf(line.c_str(), "%" SCNxPTR "-%" SCNxPTR, &part.Begin, &part.End) == 2) {
      heap.Begin = heap.End == 0 ? part.Begin : heap.Begin;
      heap.End = part.End;
    }
  }
  return heap;
}

}  // namespace

size_t BackHeapByHugePages() {
  const SAddresses heap = FindHeap();
  const uintptr_t begin = (heap.Begin + kHugePage - 1) / kHugePage * kHugePage;
  const uintptr_t end = heap.End / kHugePage * kHugePage;
  if (end < begin + kWorthwhile) {
    return 0;
  }
  const size_t bytes = end - begin;
  auto* const start = reinterpret_cast<void*>(begin);
  // the first is a wish, for what comes into use later; the second is done at once
  const bool isGranted =
      madvise(start, bytes, MADV_HUGEPAGE) == 0 && madvise(start, bytes, kCollapse) == 0;
  return isGranted ? bytes : 0;
}

#else

size_t BackHeapByHugePages() {
  return 0;
}

#endif

}  // namespace argos
