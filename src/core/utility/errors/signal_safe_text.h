#ifndef ARGOS3_CORE_UTILITY_ERRORS_SIGNAL_SAFE_TEXT_H
#define ARGOS3_CORE_UTILITY_ERRORS_SIGNAL_SAFE_TEXT_H

#include <argos3/core/config.h>  // checks the language level

#include <cstddef>
#include <cstdint>
#include <string>

namespace argos {

/**
 * A text in a buffer of fixed size, whose functions may be called in a signal handler: none of them
 * allocates or locks. What does not fit is cut off.
 */
class CSignalSafeText {
 public:
  CSignalSafeText& Append(const char* text, std::size_t length);
  /** @param text  ends with a null character; null: nothing is appended. */
  CSignalSafeText& Append(const char* text);
  CSignalSafeText& Append(const std::string& text) { return Append(text.data(), text.size()); }
  CSignalSafeText& AppendNumber(std::uint64_t number) { return AppendDigits(number, 10); }
  /** With the prefix 0x. */
  CSignalSafeText& AppendHex(std::uint64_t number) { return Append("0x").AppendDigits(number, 16); }

  const char* GetText() const { return m_text; }
  std::size_t GetLength() const { return m_length; }
  void Clear() { m_length = 0; }
  /** Writes the text to a file descriptor; failures are ignored. */
  void WriteTo(int file) const;

 private:
  CSignalSafeText& AppendDigits(std::uint64_t number, unsigned int base);

  static constexpr std::size_t kCapacity = 2048;

  char m_text[kCapacity];
  std::size_t m_length = 0;
};

}  // namespace argos

#endif
