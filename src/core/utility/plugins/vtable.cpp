#include <argos3/core/utility/plugins/vtable.h>

#include <mutex>

namespace argos::detail {

std::size_t NextTag(std::size_t& counter) {
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  return ++counter;
}

}  // namespace argos::detail
