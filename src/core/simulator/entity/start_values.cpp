#include <argos3/core/simulator/entity/start_values.h>

#include <algorithm>
#include <utility>

namespace argos {

bool CStartValues::Has(const void* key) const {
  return std::ranges::find(m_values, key, &SValue::Key) != m_values.end();
}

void CStartValues::Remove(const void* key) {
  std::erase_if(m_values, [key](const SValue& value) { return value.Key == key; });
}

void CStartValues::Add(const void* key, std::function<void()> restore) {
  m_values.push_back({key, std::move(restore)});
}

// The values stay listed meanwhile, so that setters that are called do not add them again. A setter
// may add another one.
void CStartValues::Restore() {
  for (size_t i = m_values.size(); i > 0; --i) {
    const std::function<void()> restore = m_values[i - 1].Restore;
    restore();
  }
}

}  // namespace argos
