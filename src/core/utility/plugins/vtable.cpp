#include <argos3/core/utility/plugins/vtable.h>

#include <map>
#include <mutex>
#include <typeindex>

namespace argos::detail {

std::size_t GetTagOf(const std::type_info& derived, const std::type_info& base,
                     std::size_t& counter) {
  static std::mutex mutex;
  static std::map<std::type_index, std::map<std::type_index, std::size_t>> tagsByBase;
  const std::lock_guard<std::mutex> lock(mutex);
  auto& tags = tagsByBase[base];
  // the order in which static objects are initialized is the compiler's choice, but the root is
  // always the first
  tags.emplace(base, 1);
  const std::size_t tag = tags.emplace(derived, tags.size() + 1).first->second;
  counter = tags.size();
  return tag;
}

}  // namespace argos::detail
