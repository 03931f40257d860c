#ifndef ARGOS3_SUPPORT_BYTE_STREAM_H
#define ARGOS3_SUPPORT_BYTE_STREAM_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <bit>
#include <string>
#include <string_view>

namespace argos {

/** Appends numbers and texts to bytes. Whole numbers take 7 bits a byte, the lowest first. */
class CByteWriter {
 public:
  explicit CByteWriter(std::string& bytes) : m_bytes(bytes) {}

  void WriteByte(UInt8 value) { m_bytes.push_back(static_cast<char>(value)); }
  /** 1 byte below 128, at most 10. */
  void WriteNumber(UInt64 value) {
    while (value >= 0x80) {
      WriteByte(static_cast<UInt8>(value | 0x80));
      value >>= 7;
    }
    WriteByte(static_cast<UInt8>(value));
  }
  /** 1 byte from -64 to 63, at most 10. */
  void WriteSigned(SInt64 value) { WriteNumber(FoldSign(value)); }
  /** Its 8 bytes: the same bits after reading. */
  void WriteReal(Real value) { WriteFixed64(std::bit_cast<UInt64>(value)); }
  void WriteFixed32(UInt32 value);
  void WriteFixed64(UInt64 value);
  /** Length and bytes. */
  void WriteText(std::string_view text) {
    WriteNumber(text.size());
    m_bytes.append(text);
  }

  /** 0, -1, 1, -2, ... to 0, 1, 2, 3, ...: small numbers stay small. */
  static UInt64 FoldSign(SInt64 value) {
    return (static_cast<UInt64>(value) << 1) ^ static_cast<UInt64>(value >> 63);
  }

 private:
  std::string& m_bytes;
};

/** Reads what CByteWriter wrote. Each function throws CARGoSException if the bytes end before. */
class CByteReader {
 public:
  explicit CByteReader(std::string_view bytes) : m_rest(bytes) {}

  bool IsAtEnd() const { return m_rest.empty(); }
  size_t GetNumBytesLeft() const { return m_rest.size(); }

  UInt8 ReadByte() {
    if (m_rest.empty()) {
      ThrowTooShort();
    }
    const auto byte = static_cast<UInt8>(m_rest.front());
    m_rest.remove_prefix(1);
    return byte;
  }
  UInt64 ReadNumber();
  /** @throws CARGoSException also if the number exceeds @p largest. @param what for the error. */
  UInt64 ReadNumberUpTo(UInt64 largest, const char* what);
  /** The number of items that follow, each of at least one byte. */
  size_t ReadCount(const char* what) { return ReadNumberUpTo(m_rest.size(), what); }
  SInt64 ReadSigned() { return UnfoldSign(ReadNumber()); }
  Real ReadReal() { return std::bit_cast<Real>(ReadFixed64()); }
  UInt32 ReadFixed32();
  UInt64 ReadFixed64();
  /** Refers to the bytes given to the constructor. */
  std::string_view ReadBytes(UInt64 count);
  std::string_view ReadText() { return ReadBytes(ReadNumber()); }

  static SInt64 UnfoldSign(UInt64 value) {
    return static_cast<SInt64>((value >> 1) ^ (~(value & 1) + 1));
  }

 private:
  [[noreturn]] static void ThrowTooShort();

  std::string_view m_rest;
};

}  // namespace argos

#endif
