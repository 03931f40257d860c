#include <argos3/core/utility/memory/page_preparer.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <algorithm>
#include <system_error>

namespace argos {

namespace {

// bytes; the destructor waits for one such part at most
constexpr std::size_t kPart = std::size_t(2) << 20;

// @return false if the system cannot, or has no memory left
bool PreparePages([[maybe_unused]] void* start, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__) && defined(MADV_POPULATE_WRITE)
  return madvise(start, bytes, MADV_POPULATE_WRITE) == 0;
#else
  return false;
#endif
}

}  // namespace

CPagePreparer::CPagePreparer(void* start, std::size_t bytes) {
  if (bytes == 0) {
    return;
  }
  try {
    m_thread = std::thread([this, start, bytes] {
      for (std::size_t done = 0; done < bytes && !m_isStopped; done += kPart) {
        if (!PreparePages(static_cast<std::byte*>(start) + done, std::min(kPart, bytes - done))) {
          return;
        }
      }
    });
  } catch (const std::system_error&) {
    // no more threads: pages are provided when they are written
  }
}

CPagePreparer::~CPagePreparer() {
  m_isStopped = true;
  if (m_thread.joinable()) {
    m_thread.join();
  }
}

}  // namespace argos
