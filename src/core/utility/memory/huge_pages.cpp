#include <argos3/core/utility/memory/huge_pages.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace argos {

namespace {

// bytes
constexpr std::uintptr_t kHugePage = std::uintptr_t(2) << 20;
// bytes; smaller arrays fit into the processor's table of small pages
constexpr std::size_t kLargeArray = std::size_t(4) << 20;

}  // namespace

void AdviseHugePages([[maybe_unused]] const void* start, [[maybe_unused]] size_t bytes) noexcept {
#if defined(__linux__) && defined(MADV_HUGEPAGE)
  if (bytes < kLargeArray) {
    return;
  }
  // the huge pages that belong to the array alone
  const auto address = reinterpret_cast<std::uintptr_t>(start);
  const std::uintptr_t first = (address + kHugePage - 1) / kHugePage * kHugePage;
  const std::uintptr_t end = (address + bytes) / kHugePage * kHugePage;
  if (first < end) {
    // a refusal costs speed only, so it is not an error
    madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
  }
#endif
}

}  // namespace argos
