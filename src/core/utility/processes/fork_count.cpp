#include <argos3/core/utility/processes/fork_count.h>

#include <pthread.h>

#include <atomic>
#include <cstdint>

namespace argos {

namespace {

std::atomic<std::uint32_t> g_numForks{0};

}  // namespace

std::uint32_t CountForks() {
  static const int registered =
      pthread_atfork(nullptr, nullptr, [] { g_numForks.fetch_add(1, std::memory_order_relaxed); });
  static_cast<void>(registered);
  return g_numForks.load(std::memory_order_relaxed);
}

}  // namespace argos
