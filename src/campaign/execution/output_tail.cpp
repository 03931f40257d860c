#include <argos3/campaign/execution/output_tail.h>

#include <algorithm>
#include <limits>

namespace argos {

namespace {

void AppendTail(std::string& tail, std::string_view text, size_t size) {
  if (text.size() > size) {
    text.remove_prefix(text.size() - size);
  }
  tail.append(text);
  // does not erase at every call: erasing moves the rest
  if (tail.size() > 2 * size) {
    tail.erase(0, tail.size() - size);
  }
}

std::string_view End(const std::string& text, size_t size) {
  return std::string_view(text).substr(text.size() > size ? text.size() - size : 0);
}

}  // namespace

void COutputTail::Add(std::string_view text) {
  const UInt64 limit = m_limit == 0 ? std::numeric_limits<UInt64>::max() : m_limit;
  const UInt64 left = limit - std::min(m_numBytes, limit);
  const size_t within = static_cast<size_t>(std::min<UInt64>(left, text.size()));
  m_numBytes += text.size();
  AppendTail(m_within, text.substr(0, within), kSize);
  if (within < text.size()) {
    AppendTail(m_beyond, text.substr(within), kSizeBeyond);
  }
}

std::string COutputTail::GetText() const {
  if (m_beyond.empty()) {
    return std::string(End(m_within, kSize));
  }
  const std::string_view end = End(m_beyond, kSizeBeyond);
  const UInt64 dropped = m_numBytes - m_limit - end.size();
  std::string text(End(m_within, kSize - kSizeBeyond));
  if (dropped > 0) {
    text += "\n[... " + std::to_string(dropped) + " bytes beyond the limit of " +
            std::to_string(m_limit) + " were dropped ...]\n";
  }
  return text.append(end);
}

void COutputTail::Clear() {
  m_numBytes = 0;
  m_within.clear();
  m_beyond.clear();
}

}  // namespace argos
