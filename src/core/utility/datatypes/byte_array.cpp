#include <argos3/core/utility/datatypes/byte_array.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace argos {

// bytes

CByteArray::CByteArray(const CByteArray& other) {
  Assign(other);
}

CByteArray::CByteArray(CByteArray&& other) noexcept {
  Swap(other);
}

CByteArray::CByteArray(const UInt8* buffer, std::size_t size) {
  AddBuffer(buffer, size);
}

CByteArray::CByteArray(std::size_t size, UInt8 value) {
  Resize(size, value);
}

CByteArray& CByteArray::Assign(const CByteArray& other) {
  if (this != &other) {
    Clear();
    AddBuffer(other.ToCArray(), other.Size());
  }
  return *this;
}

CByteArray& CByteArray::operator=(CByteArray&& other) noexcept {
  Swap(other);
  return *this;
}

// makes space for that many bytes from index 0 on
void CByteArray::Reserve(std::size_t bytes) {
  if (bytes <= GetCapacity()) {
    return;
  }
  const std::size_t capacity = std::max(bytes, 2 * m_end);
  auto heap = std::make_unique_for_overwrite<UInt8[]>(capacity);
  std::copy_n(GetStorage(), m_end, heap.get());
  m_heap = std::move(heap);
  m_heapBytes = capacity;
}

// appends bytes without values; @return the first of them
UInt8* CByteArray::Extend(std::size_t bytes) {
  Reserve(m_end + bytes);
  UInt8* const first = GetStorage() + m_end;
  m_end += bytes;
  return first;
}

void CByteArray::Resize(std::size_t size, UInt8 value) {
  const std::size_t end = m_front + size;
  if (end > m_end) {
    const std::size_t more = end - m_end;
    std::fill_n(Extend(more), more, value);
  }
  m_end = end;
}

void CByteArray::Swap(CByteArray& other) noexcept {
  m_heap.swap(other.m_heap);
  std::swap(m_front, other.m_front);
  std::swap(m_end, other.m_end);
  std::swap(m_inline, other.m_inline);  // the number of allocated bytes, too
}

void CByteArray::Clear() {
  m_front = m_end = 0;
}

void CByteArray::Zero() {
  std::fill_n(GetStorage(), m_end, UInt8(0));
}

void CByteArray::CheckIndex(std::size_t index) const {
  if (index >= Size()) {
    THROW_ARGOSEXCEPTION("Byte array: index " << index << " is out of range, expected a number"
                                              << " below the size, which is " << Size());
  }
}

void CByteArray::CheckAvailable(std::size_t bytes) const {
  if (bytes > Size()) {
    THROW_ARGOSEXCEPTION("Byte array: " << bytes << " bytes were requested, but there are only "
                                        << Size());
  }
}

UInt8& CByteArray::operator[](std::size_t index) {
  CheckIndex(index);
  return GetStorage()[m_front + index];
}

UInt8 CByteArray::operator[](std::size_t index) const {
  CheckIndex(index);
  return GetStorage()[m_front + index];
}

bool CByteArray::operator==(const CByteArray& other) const {
  return Size() == other.Size() && std::equal(GetStorage() + m_front, GetStorage() + m_end,
                                              other.GetStorage() + other.m_front);
}

CByteArray& CByteArray::AddBuffer(const UInt8* buffer, std::size_t size) {
  std::copy_n(buffer, size, Extend(size));
  return *this;
}

CByteArray& CByteArray::FetchBuffer(UInt8* buffer, std::size_t size) {
  CheckAvailable(size);
  std::copy_n(GetStorage() + m_front, size, buffer);
  RemoveFront(size);
  return *this;
}

void CByteArray::RemoveFront(std::size_t bytes) {
  m_front += bytes;
  if (m_front == m_end) {
    Clear();
  } else if (2 * m_front > m_end) {
    // amortised: the erased bytes have been read one by one
    UInt8* const storage = GetStorage();
    std::copy(storage + m_front, storage + m_end, storage);
    m_end -= m_front;
    m_front = 0;
  }
}

CByteArray* CByteArray::operator()(std::size_t start, ssize_t end) {
  const std::size_t last = end < 0 ? Size() : static_cast<std::size_t>(end);
  if (start > last || last > Size()) {
    THROW_ARGOSEXCEPTION("Byte array: the part from byte " << start << " to byte " << end
                                                           << " is out of range, the size is "
                                                           << Size());
  }
  return new CByteArray(GetStorage() + m_front + start, last - start);
}

// real numbers and strings

namespace {
// 2^63 - 2 rounded to a double, which is 2^63: scaling by a power of two is exact
constexpr double kMantissaScale = 9223372036854775806.0;
constexpr std::size_t kRealSize = 12;
}  // namespace

CByteArray& CByteArray::operator<<(double value) {
  if (!std::isfinite(value)) {
    THROW_ARGOSEXCEPTION("Byte array: the number " << value
                                                   << " cannot be stored, expected a finite"
                                                   << " one");
  }
  int exponent = 0;
  const double fraction = std::frexp(std::fabs(value), &exponent);
  SInt64 mantissa = 0;
  if (value != 0.0) {
    mantissa = static_cast<SInt64>((fraction - 0.5) * 2.0 * kMantissaScale) + 1;
  }
  PutInteger<SInt64>(value < 0.0 ? -mantissa : mantissa);
  return PutInteger<SInt32>(exponent);
}

CByteArray& CByteArray::operator>>(double& value) {
  CheckAvailable(kRealSize);
  SInt64 mantissa = 0;
  SInt32 exponent = 0;
  TakeInteger(mantissa);
  TakeInteger(exponent);
  if (mantissa == 0) {
    value = 0.0;
    return *this;
  }
  // unsigned, because the most negative mantissa has no positive counterpart
  const UInt64 magnitude =
      mantissa < 0 ? UInt64(0) - static_cast<UInt64>(mantissa) : static_cast<UInt64>(mantissa);
  const double fraction = static_cast<double>(magnitude - 1) / kMantissaScale / 2.0 + 0.5;
  value = std::copysign(std::ldexp(fraction, exponent), mantissa < 0 ? -1.0 : 1.0);
  return *this;
}

CByteArray& CByteArray::operator<<(float value) {
  return *this << static_cast<double>(value);
}

CByteArray& CByteArray::operator>>(float& value) {
  double wide = 0.0;
  *this >> wide;
  value = static_cast<float>(wide);
  return *this;
}

CByteArray& CByteArray::operator<<(const std::string& value) {
  UInt8* const first = Extend(value.size() + 1);
  std::copy(value.begin(), value.end(), first);
  first[value.size()] = 0;
  return *this;
}

CByteArray& CByteArray::operator>>(std::string& value) {
  const UInt8* const begin = GetStorage() + m_front;
  const UInt8* const last = GetStorage() + m_end;
  const UInt8* const end = std::find(begin, last, UInt8(0));
  value.assign(begin, end);
  RemoveFront(value.size() + (end == last ? 0 : 1));
  return *this;
}

std::ostream& operator<<(std::ostream& stream, const CByteArray& array) {
  stream << "CByteArray [ ";
  for (std::size_t i = 0; i < array.Size(); ++i) {
    stream << static_cast<int>(array[i]) << ' ';
  }
  return stream << "]\n";
}

}  // namespace argos
