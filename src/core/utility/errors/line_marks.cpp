#include <argos3/core/utility/errors/line_marks.h>

#include <algorithm>
#include <cstddef>

namespace argos {

namespace {

// [FATAL] and the like
bool HasMark(const std::string& text, size_t start) {
  if (text[start] != '[') {
    return false;
  }
  const size_t end = text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ", start + 1);
  return end > start + 1 && end != std::string::npos && text[end] == ']';
}

}  // namespace

std::string MarkLines(const std::string& text) {
  std::string marked;
  for (size_t start = 0; start < text.size();) {
    const size_t end = std::min(text.find('\n', start), text.size());
    if (end > start) {
      marked += marked.empty() ? "" : "\n";
      marked += HasMark(text, start) ? "" : "[FATAL] ";
      marked.append(text, start, end - start);
    }
    start = end + 1;
  }
  return marked;
}

}  // namespace argos
