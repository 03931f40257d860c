#include <argos3/core/utility/text/utf8.h>

#include <algorithm>

namespace argos {

namespace {

std::size_t CountBytesFor(unsigned char lead) {
  if (lead < 0x80) {
    return 1;
  }
  if (lead < 0xC2 || lead >= 0xF5) {
    return 0;
  }
  if (lead < 0xE0) {
    return 2;
  }
  return lead < 0xF0 ? 3 : 4;
}

// overlong forms, surrogates, and what is beyond Unicode
bool IsRefused(unsigned char lead, unsigned char second) {
  return (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
         (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
}

}  // namespace

std::size_t CountUtf8Bytes(std::string_view text) {
  if (text.empty()) {
    return 0;
  }
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t size = CountBytesFor(lead);
  if (size <= 1) {
    return size;
  }
  const bool isWhole =
      size <= text.size() && std::all_of(text.begin() + 1, text.begin() + size, [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0) == 0x80;
      });
  return isWhole && !IsRefused(lead, static_cast<unsigned char>(text[1])) ? size : 0;
}

std::string_view CutUtf8(std::string_view text, std::size_t bytes) {
  std::size_t end = std::min(text.size(), bytes);
  while (end > 0 && end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) {
    --end;
  }
  return text.substr(0, end);
}

}  // namespace argos
