#include <argos3/support/json_quoting.h>

#include <argos3/core/utility/text/utf8.h>

#include <fmt/format.h>

#include <string_view>

namespace argos {

std::string QuoteForJson(const std::string& text) {
  std::string quoted = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = CountUtf8Bytes(std::string_view(text).substr(at));
    const char c = text[at];
    if (size == 0) {
      quoted += "\\ufffd";
    } else if (size > 1) {
      quoted += text.substr(at, size);
    } else if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else if (c == '\n') {
      quoted += "\\n";
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted += c;
    }
    at += size == 0 ? 1 : size;
  }
  return quoted + '"';
}

}  // namespace argos
