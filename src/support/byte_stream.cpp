#include <argos3/support/byte_stream.h>

#include <argos3/core/utility/errors/argos_exception.h>

namespace argos {

void CByteWriter::WriteFixed32(UInt32 value) {
  for (int shift = 0; shift < 32; shift += 8) {
    WriteByte(static_cast<UInt8>(value >> shift));
  }
}

void CByteWriter::WriteFixed64(UInt64 value) {
  WriteFixed32(static_cast<UInt32>(value));
  WriteFixed32(static_cast<UInt32>(value >> 32));
}

void CByteReader::ThrowTooShort() {
  THROW_ARGOSEXCEPTION("its data ends too early");
}

UInt64 CByteReader::ReadNumber() {
  UInt64 value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const UInt8 byte = ReadByte();
    value |= static_cast<UInt64>(byte & 0x7f) << shift;
    if (byte < 0x80) {
      return value;
    }
  }
  THROW_ARGOSEXCEPTION("it has a number of more than 64 bits");
}

UInt64 CByteReader::ReadNumberUpTo(UInt64 largest, const char* what) {
  const UInt64 value = ReadNumber();
  if (value > largest) {
    THROW_ARGOSEXCEPTION("its " << what << " is " << value << ", more than the possible "
                                << largest);
  }
  return value;
}

UInt32 CByteReader::ReadFixed32() {
  UInt32 value = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    value |= static_cast<UInt32>(ReadByte()) << shift;
  }
  return value;
}

UInt64 CByteReader::ReadFixed64() {
  const UInt64 low = ReadFixed32();
  return low | static_cast<UInt64>(ReadFixed32()) << 32;
}

std::string_view CByteReader::ReadBytes(UInt64 count) {
  if (count > m_rest.size()) {
    ThrowTooShort();
  }
  const std::string_view bytes = m_rest.substr(0, count);
  m_rest.remove_prefix(count);
  return bytes;
}

}  // namespace argos
