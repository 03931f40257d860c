#include <argos3/core/utility/configuration/configuration_parsing.h>

#include <array>
#include <cctype>
#include <charconv>
#include <cstring>
#include <locale>

namespace argos::detail {

CTextReader::CBuffer::CBuffer(const char* text) {
  // a stream writes to its get area only if a character other than the one read is put back
  char* begin = const_cast<char*>(text);
  setg(begin, begin, begin + std::strlen(text));
}

CTextReader::CTextReader(const char* text, bool strict) : m_buffer(text), m_stream(&m_buffer) {
  // a new stream has the global locale, mostly this one
  if (m_stream.getloc() != std::locale::classic()) {
    m_stream.imbue(std::locale::classic());
  }
  if (strict) {
    SetStrictParsing(m_stream, true);
  } else {
    SetLooseParsing(m_stream);
  }
  m_stream >> std::boolalpha;
}

CTextReader::~CTextReader() = default;

bool CTextReader::Finish() {
  if (m_stream.fail()) {
    return false;
  }
  int next = m_buffer.sgetc();
  while (next != EOF && std::isspace(next) != 0) {
    next = m_buffer.snextc();
  }
  return next == EOF;
}

namespace {
template <typename T>
std::string Shortest(T value) {
  // 32: the shortest text that reads back as the same double has at most 24 characters
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return std::string(text.data(), result.ptr);
}
}  // namespace

std::string FormatReal(float value) {
  return Shortest(value);
}
std::string FormatReal(double value) {
  return Shortest(value);
}

}  // namespace argos::detail
