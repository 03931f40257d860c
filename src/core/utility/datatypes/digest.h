#ifndef ARGOS3_CORE_UTILITY_DATATYPES_DIGEST_H
#define ARGOS3_CORE_UTILITY_DATATYPES_DIGEST_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <cstring>
#include <string>
#include <type_traits>

namespace argos {

/**
 * A 64-bit digest of values fed to it in order; two states with one differing bit differ.
 *
 * Not for security. Mixing step: MurmurHash3's 64-bit finaliser (A. Appleby, public domain) over
 * the running value xor the next word.
 */
class CDigest {
 public:
  /** Adds an integer, an enumeration or a floating-point number by its bits. */
  template <typename T>
  void Add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>, "feed numbers one by one");
    static_assert(sizeof(T) <= sizeof(UInt64), "at most 64 bits");
    UInt64 bits = 0;
    std::memcpy(&bits, &value, sizeof(T));
    Mix(bits);
  }

  void Add(const std::string& text) {
    Mix(text.size());
    for (const char c : text) {
      Mix(static_cast<unsigned char>(c));
    }
  }

  UInt64 GetValue() const { return m_value; }

 private:
  void Mix(UInt64 word) {
    m_value ^= word + 0x9e3779b97f4a7c15ULL;
    m_value ^= m_value >> 33;
    m_value *= 0xff51afd7ed558ccdULL;
    m_value ^= m_value >> 33;
    m_value *= 0xc4ceb9fe1a85ec53ULL;
    m_value ^= m_value >> 33;
  }

  UInt64 m_value = 0;
};

}  // namespace argos

#endif
