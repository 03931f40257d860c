#include <argos3/core/utility/errors/signal_safe_text.h>

#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace argos {

CSignalSafeText& CSignalSafeText::Append(const char* text, std::size_t length) {
  const std::size_t room = kCapacity - m_length;
  const std::size_t taken = length < room ? length : room;
  std::memcpy(m_text + m_length, text, taken);
  m_length += taken;
  return *this;
}

CSignalSafeText& CSignalSafeText::Append(const char* text) {
  return text != nullptr ? Append(text, std::strlen(text)) : *this;
}

CSignalSafeText& CSignalSafeText::AppendDigits(std::uint64_t number, unsigned int base) {
  constexpr std::size_t kMaxDigits = 20;  // digits of a number of 64 bits
  char digits[kMaxDigits];
  std::size_t start = kMaxDigits;
  do {
    digits[--start] = "0123456789abcdef"[number % base];
    number /= base;
  } while (number != 0);
  return Append(digits + start, kMaxDigits - start);
}

void CSignalSafeText::WriteTo(int file) const {
  std::size_t done = 0;
  while (done < m_length) {
    const ssize_t written = write(file, m_text + done, m_length - done);
    if (written < 0 && errno != EINTR) {
      return;
    }
    done += written > 0 ? static_cast<std::size_t>(written) : 0;
  }
}

}  // namespace argos
