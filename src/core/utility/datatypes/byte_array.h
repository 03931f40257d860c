#ifndef ARGOS3_CORE_UTILITY_DATATYPES_BYTE_ARRAY_H
#define ARGOS3_CORE_UTILITY_DATATYPES_BYTE_ARRAY_H

#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/errors/argos_exception.h>

#include <sys/types.h>

#include <cstddef>
#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace argos {

/**
 * A queue of bytes: << appends at the back, >> removes from the front.
 *
 * Values are stored independently of the machine:
 *   integers          network byte order, at the width of their type;
 *   double and float  12 bytes: a 64-bit signed mantissa, then a 32-bit signed exponent. With
 *                     |x| = f * 2^e and f in [0.5,1), the mantissa is
 *                     sign(x) * (int((f - 0.5) * 2 * (2^63 - 2)) + 1), and 0 for x = 0. Values are
 *                     read back exactly;
 *   strings           their bytes, then a zero.
 *
 * Every function that reads throws CARGoSException, and removes nothing, if there are too few
 * bytes.
 *
 * Up to 16 bytes, the common size of a message, are stored in the array itself; more are on the
 * heap, in memory that assignments and Clear() keep.
 */
class CByteArray {
 public:
  CByteArray() = default;
  CByteArray(const CByteArray& other);
  CByteArray(CByteArray&& other) noexcept;
  CByteArray(const UInt8* buffer, std::size_t size);
  CByteArray(std::size_t size, UInt8 value = 0);
  CByteArray& operator=(const CByteArray& other) {
    if (m_heap == nullptr && other.m_heap == nullptr && other.m_front == 0) {
      // a fixed size is a few instructions, and correct for an assignment to itself
      std::memmove(m_inline, other.m_inline, kInlineBytes);
      m_end = other.m_end;
      m_front = 0;
      return *this;
    }
    return Assign(other);
  }
  CByteArray& operator=(CByteArray&& other) noexcept;
  ~CByteArray() = default;

  std::size_t Size() const { return m_end - m_front; }

  /** @param value  value of new bytes. */
  void Resize(std::size_t size, UInt8 value = 0);

  void Swap(CByteArray& other) noexcept;
  bool Empty() const { return Size() == 0; }

  /** Returns the bytes; null if the array is empty. Valid until the array is changed. */
  const UInt8* ToCArray() const { return Empty() ? nullptr : GetStorage() + m_front; }
  UInt8* ToCArray() { return Empty() ? nullptr : GetStorage() + m_front; }

  /** Removes all bytes. */
  void Clear();

  /** Sets all bytes to 0. */
  void Zero();

  /** @throws CARGoSException if the index is out of range. */
  UInt8& operator[](std::size_t index);
  UInt8 operator[](std::size_t index) const;

  bool operator==(const CByteArray& other) const;
  bool operator!=(const CByteArray& other) const { return !(*this == other); }

  CByteArray& AddBuffer(const UInt8* buffer, std::size_t size);
  CByteArray& FetchBuffer(UInt8* buffer, std::size_t size);

  template <typename T>
  T PopFront() {
    T value;
    *this >> value;
    return value;
  }

  /**
   * Returns a copy of the bytes in [start,end), on the heap; the caller deletes it.
   * @param end  negative: up to the last byte.
   * @throws CARGoSException if the range is invalid.
   */
  CByteArray* operator()(std::size_t start, ssize_t end = -1);

  CByteArray& operator<<(UInt8 value) { return PutInteger(value); }
  CByteArray& operator>>(UInt8& value) { return TakeInteger(value); }
  CByteArray& operator<<(SInt8 value) { return PutInteger(value); }
  CByteArray& operator>>(SInt8& value) { return TakeInteger(value); }
  CByteArray& operator<<(UInt16 value) { return PutInteger(value); }
  CByteArray& operator>>(UInt16& value) { return TakeInteger(value); }
  CByteArray& operator<<(SInt16 value) { return PutInteger(value); }
  CByteArray& operator>>(SInt16& value) { return TakeInteger(value); }
  CByteArray& operator<<(UInt32 value) { return PutInteger(value); }
  CByteArray& operator>>(UInt32& value) { return TakeInteger(value); }
  CByteArray& operator<<(SInt32 value) { return PutInteger(value); }
  CByteArray& operator>>(SInt32& value) { return TakeInteger(value); }
  CByteArray& operator<<(UInt64 value) { return PutInteger(value); }
  CByteArray& operator>>(UInt64& value) { return TakeInteger(value); }
  CByteArray& operator<<(SInt64 value) { return PutInteger(value); }
  CByteArray& operator>>(SInt64& value) { return TakeInteger(value); }
  /** The width of the platform's type: 32 or 64 bits. */
  CByteArray& operator<<(unsigned long int value) { return PutInteger(value); }
  CByteArray& operator>>(unsigned long int& value) { return TakeInteger(value); }
  CByteArray& operator<<(signed long int value) { return PutInteger(value); }
  CByteArray& operator>>(signed long int& value) { return TakeInteger(value); }
  /** @throws CARGoSException on infinity and NaN, which the format cannot hold. */
  CByteArray& operator<<(double value);
  CByteArray& operator>>(double& value);
  CByteArray& operator<<(float value);
  CByteArray& operator>>(float& value);
  /** Writes all bytes and a zero. Reading ends behind the first zero, or at the end. */
  CByteArray& operator<<(const std::string& value);
  CByteArray& operator>>(std::string& value);

 private:
  static constexpr std::size_t kInlineBytes = 16;

  // the highest byte first
  template <typename T>
  CByteArray& PutInteger(T value) {
    const auto bits = static_cast<std::make_unsigned_t<T>>(value);
    UInt8* const first = Extend(sizeof(T));
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      first[i] = static_cast<UInt8>((bits >> (8 * (sizeof(T) - 1 - i))) & 0xFFU);
    }
    return *this;
  }
  template <typename T>
  CByteArray& TakeInteger(T& value) {
    CheckAvailable(sizeof(T));
    UInt64 bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      bits = (bits << 8) | GetStorage()[m_front + i];
    }
    value = static_cast<T>(static_cast<std::make_unsigned_t<T>>(bits));
    RemoveFront(sizeof(T));
    return *this;
  }
  void CheckAvailable(std::size_t bytes) const;
  void CheckIndex(std::size_t index) const;
  void RemoveFront(std::size_t bytes);
  CByteArray& Assign(const CByteArray& other);
  UInt8* Extend(std::size_t bytes);
  void Reserve(std::size_t bytes);

  const UInt8* GetStorage() const { return m_heap != nullptr ? m_heap.get() : m_inline; }
  UInt8* GetStorage() { return m_heap != nullptr ? m_heap.get() : m_inline; }
  std::size_t GetCapacity() const { return m_heap != nullptr ? m_heapBytes : kInlineBytes; }

  std::unique_ptr<UInt8[]> m_heap;  // null: the bytes are in m_inline
  // bytes before this index have been read; erasing them one by one would be slow
  std::size_t m_front = 0;
  std::size_t m_end = 0;  // index after the last byte
  union {
    UInt8 m_inline[kInlineBytes] = {};
    std::size_t m_heapBytes;  // allocated
  };
};

/** Prints "CByteArray [ b0 b1 ... ]" with decimal numbers, then a line break. */
std::ostream& operator<<(std::ostream& stream, const CByteArray& array);

}  // namespace argos

#endif
