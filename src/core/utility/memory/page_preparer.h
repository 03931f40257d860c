#ifndef ARGOS3_CORE_UTILITY_MEMORY_PAGE_PREPARER_H
#define ARGOS3_CORE_UTILITY_MEMORY_PAGE_PREPARER_H

#include <argos3/core/utility/non_copyable.h>

#include <atomic>
#include <cstddef>
#include <thread>

namespace argos {

/**
 * Makes the system provide the pages of a block of memory, in a thread of its own, from the
 * beginning to the end, so that the program does not wait for each page when it first writes it.
 *
 * The program may use the block meanwhile. Does nothing where the system cannot do that.
 */
class CPagePreparer : private CNonCopyable {
 public:
  /** @param start  aligned to a page; the block must be mapped as long as this exists. */
  CPagePreparer(void* start, std::size_t bytes);
  /** Ends soon, perhaps before the end of the block. */
  ~CPagePreparer();

 private:
  std::atomic<bool> m_isStopped{false};
  std::thread m_thread;
};

}  // namespace argos

#endif
