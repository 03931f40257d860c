#include <argos3/core/utility/configuration/memento.h>
#include <argos3/core/utility/datatypes/byte_array.h>
#include <argos3/core/utility/string_utilities.h>

#include <catch2/catch.hpp>

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace byte_array_test {

using namespace argos;
using Catch::Contains;

namespace {

std::vector<int> Bytes(const CByteArray& array) {
  std::vector<int> bytes;
  for (std::size_t i = 0; i < array.Size(); ++i) {
    bytes.push_back(array[i]);
  }
  return bytes;
}

// an array with the given content whose front has been read; it must behave like a new one
CByteArray WithReadFront(const std::vector<UInt8>& content) {
  CByteArray array(5, 99);
  array.AddBuffer(content.data(), content.size());
  UInt8 front[5];
  array.FetchBuffer(front, 5);
  return array;
}

class CCounter : public CMemento {
 public:
  void SaveState(CByteArray& buffer) override { buffer << Count; }
  void LoadState(CByteArray& buffer) override { buffer >> Count; }
  UInt32 Count = 0;
};

template <typename T>
void CheckRoundTrip(T value, std::size_t size) {
  CByteArray array;
  array << value;
  CHECK(array.Size() == size);
  T back = T();
  array >> back;
  CHECK(back == value);
  CHECK(array.Empty());
}

}  // namespace

TEST_CASE("byte array: constructors set content and size", "[core][byte_array]") {
  CHECK(CByteArray().Empty());
  CHECK(CByteArray().ToCArray() == nullptr);
  const CByteArray implicit = 10;
  CHECK(implicit.Size() == 10);
  CHECK(Bytes(CByteArray(3, 7)) == std::vector<int>{7, 7, 7});
  const UInt8 buffer[] = {1, 2, 3};
  const CByteArray fromBuffer(buffer, 3);
  CHECK(Bytes(fromBuffer) == std::vector<int>{1, 2, 3});
  const CByteArray copy(fromBuffer);
  CHECK(copy == fromBuffer);
  CHECK(copy.ToCArray() != fromBuffer.ToCArray());
  CHECK(copy.ToCArray()[2] == 3);
}

TEST_CASE("byte array: size and content can be changed", "[core][byte_array]") {
  CByteArray array(2, 5);
  array.Resize(4, 6);
  CHECK(Bytes(array) == std::vector<int>{5, 5, 6, 6});
  array.Resize(1);
  CHECK(Bytes(array) == std::vector<int>{5});
  array.Zero();
  CHECK(Bytes(array) == std::vector<int>{0});
  array[0] = 9;
  *array.ToCArray() += 1;
  CHECK(array[0] == 10);
  CByteArray other;
  array.Swap(other);
  CHECK(array.Empty());
  CHECK(Bytes(other) == std::vector<int>{10});
  array = other;
  other.Clear();
  CHECK(other.Empty());
  CHECK(array.Size() == 1);
}

TEST_CASE("byte array: reading the front leaves the rest unchanged", "[core][byte_array]") {
  CByteArray array = WithReadFront({1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(Bytes(array) == std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8});
  UInt8 byte = 0;
  array >> byte;
  CHECK(byte == 1);
  CHECK(array.Size() == 7);
  CHECK(array[0] == 2);
  const CByteArray copy(array);
  CHECK(copy == array);
  array.Resize(3);
  CHECK(Bytes(array) == std::vector<int>{2, 3, 4});
  array << UInt8(9);
  CHECK(Bytes(array) == std::vector<int>{2, 3, 4, 9});
  CHECK(array != copy);
}

TEST_CASE("byte array: integers are in network byte order at their own width",
          "[core][byte_array]") {
  CByteArray array;
  array << UInt8(0x01) << SInt8(-1) << UInt16(0x0203) << SInt16(-2) << UInt32(0x04050607U)
        << SInt32(-3) << UInt64(0x08090A0B0C0D0E0FULL) << SInt64(-4);
  CHECK(Bytes(array) == std::vector<int>{1,   255, 2,   3,   255, 254, 4,   5,   6,   7,
                                         255, 255, 255, 253, 8,   9,   10,  11,  12,  13,
                                         14,  15,  255, 255, 255, 255, 255, 255, 255, 252});
  CHECK(array.PopFront<UInt8>() == 1);
  CHECK(array.PopFront<SInt8>() == -1);
  CHECK(array.PopFront<UInt16>() == 0x0203);
  CHECK(array.PopFront<SInt16>() == -2);
  CHECK(array.PopFront<UInt32>() == 0x04050607U);
  CHECK(array.PopFront<SInt32>() == -3);
  CHECK(array.PopFront<UInt64>() == 0x08090A0B0C0D0E0FULL);
  CHECK(array.PopFront<SInt64>() == -4);
  CHECK(array.Empty());
}

TEST_CASE("byte array: extreme integers are restored exactly", "[core][byte_array]") {
  CheckRoundTrip(std::numeric_limits<SInt64>::min(), 8);
  CheckRoundTrip(std::numeric_limits<UInt64>::max(), 8);
  CheckRoundTrip(std::numeric_limits<SInt32>::min(), 4);
  CheckRoundTrip(std::numeric_limits<signed long>::min(), sizeof(long));
  CheckRoundTrip(std::numeric_limits<unsigned long>::max(), sizeof(long));
}

TEST_CASE("byte array: real numbers take 12 bytes and are restored exactly", "[core][byte_array]") {
  const double value = GENERATE(0.0, 1.0, -1.0, 0.5, 0.1, -3.14159265358979, 1e300, -1e-300, 5e-324,
                                std::numeric_limits<double>::max(), 0.99999999999999989);
  CAPTURE(value);
  CheckRoundTrip(value, 12);
  CheckRoundTrip(static_cast<float>(0.1), 12);
}

TEST_CASE("byte array: real numbers have the documented wire format", "[core][byte_array]") {
  // 1 = 0.5 * 2^1: mantissa int((0.5 - 0.5) * 2 * (2^63 - 2)) + 1 = 1, exponent 1
  CByteArray one;
  one << 1.0;
  CHECK(Bytes(one) == std::vector<int>{0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 1});
  // -1.5 = -0.75 * 2^1: mantissa -(0.25 * 2 * 2^63 + 1) = -(2^62 + 1), exponent 1
  CByteArray minusOneAndHalf;
  minusOneAndHalf << -1.5;
  CHECK(Bytes(minusOneAndHalf) ==
        std::vector<int>{0xBF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0, 0, 0, 1});
  CByteArray zero;
  zero << 0.0f;
  CHECK(Bytes(zero) == std::vector<int>(12, 0));
}

TEST_CASE("byte array: infinity and NaN are refused", "[core][byte_array]") {
  CByteArray array;
  CHECK_THROWS_WITH(array << std::numeric_limits<double>::infinity(),
                    Contains("expected a finite"));
  CHECK_THROWS_WITH(array << std::numeric_limits<double>::quiet_NaN(),
                    Contains("expected a finite"));
  CHECK(array.Empty());
}

TEST_CASE("byte array: strings end with a zero", "[core][byte_array]") {
  CByteArray array;
  array << std::string("ab") << std::string() << std::string("c");
  CHECK(Bytes(array) == std::vector<int>{'a', 'b', 0, 0, 'c', 0});
  std::string first;
  std::string second = "x";
  std::string third;
  array >> first >> second >> third;
  CHECK(first == "ab");
  CHECK(second.empty());
  CHECK(third == "c");
  // all bytes are written, also behind a zero
  array << std::string("a\0b", 3);
  CHECK(Bytes(array) == std::vector<int>{'a', 0, 'b', 0});
  array >> first >> second;
  CHECK(first == "a");
  CHECK(second == "b");
}

TEST_CASE("byte array: a string without its zero ends with the bytes", "[core][byte_array]") {
  CByteArray array(3, 65);
  std::string text;
  array >> text;
  CHECK(text == "AAA");
  CHECK(array.Empty());
  array >> text;
  CHECK(text.empty());
}

TEST_CASE("byte array: too few bytes are an error and nothing is removed", "[core][byte_array]") {
  CByteArray array(3, 65);
  UInt32 word = 0;
  double real = 0.0;
  UInt8 buffer[4];
  CHECK_THROWS_WITH(array >> word, Contains("4 bytes were requested, but there are only 3"));
  CHECK_THROWS_WITH(array >> real, Contains("12 bytes were requested, but there are only 3"));
  CHECK_THROWS_AS(array.FetchBuffer(buffer, 4), CARGoSException);
  CHECK(array.Size() == 3);
}

TEST_CASE("byte array: an index out of range throws in every build", "[core][byte_array]") {
  CByteArray array(2);
  const CByteArray& constant = array;
  CHECK_THROWS_WITH(array[2], Contains("index 2 is out of range"));
  CHECK_THROWS_AS(constant[2], CARGoSException);
}

TEST_CASE("byte array: a part is copied to a new array", "[core][byte_array]") {
  CByteArray array = WithReadFront({1, 2, 3, 4});
  const std::unique_ptr<CByteArray> middle(array(1, 3));
  CHECK(Bytes(*middle) == std::vector<int>{2, 3});
  const std::unique_ptr<CByteArray> tail(array(2));
  CHECK(Bytes(*tail) == std::vector<int>{3, 4});
  CHECK(array.Size() == 4);
  CHECK_THROWS_WITH(array(3, 2), Contains("the part from byte 3 to byte 2"));
  CHECK_THROWS_AS(array(0, 5), CARGoSException);
}

TEST_CASE("byte array: prints its bytes", "[core][byte_array]") {
  const UInt8 buffer[] = {1, 0, 255};
  CHECK(ToString(CByteArray(buffer, 3)) == "CByteArray [ 1 0 255 ]\n");
  CHECK(ToString(CByteArray()) == "CByteArray [ ]\n");
}

TEST_CASE("byte array: short and long arrays are copied, moved and swapped alike",
          "[core][byte_array]") {
  // up to 16 bytes are stored inline
  const size_t size = GENERATE(0U, 1U, 15U, 16U, 17U, 300U);
  const size_t otherSize = GENERATE(0U, 3U, 16U, 40U);
  const size_t numRead = GENERATE(0U, 1U);
  CAPTURE(size, otherSize, numRead);
  if (numRead > size) {
    return;
  }
  const auto make = [](size_t bytes, UInt8 first) {
    CByteArray array;
    for (size_t i = 0; i < bytes; ++i) {
      array << static_cast<UInt8>(first + i);
    }
    return array;
  };
  const auto list = [](const CByteArray& array) {
    return std::vector<UInt8>(array.ToCArray(), array.ToCArray() + array.Size());
  };
  CByteArray array = make(size, 5);
  for (size_t i = 0; i < numRead; ++i) {
    CHECK(array.PopFront<UInt8>() == 5);
  }
  const std::vector<UInt8> bytes = list(make(size - numRead, static_cast<UInt8>(5 + numRead)));
  CHECK(list(array) == bytes);
  const CByteArray& same = array;
  array = same;
  CHECK(list(array) == bytes);
  const CByteArray copy(array);
  CHECK(list(copy) == bytes);
  CHECK(copy == array);
  CByteArray assigned = make(otherSize, 100);
  assigned = array;
  CHECK(list(assigned) == bytes);
  assigned << UInt8(7);
  CHECK(list(array) == bytes);
  CByteArray other = make(otherSize, 100);
  other.Swap(array);
  CHECK(list(other) == bytes);
  CHECK(list(array) == list(make(otherSize, 100)));
  const CByteArray moved(std::move(other));
  CHECK(list(moved) == bytes);
}

TEST_CASE("memento: a saved state can be restored", "[core][memento]") {
  CCounter counter;
  counter.Count = 42;
  CByteArray buffer;
  counter.SaveState(buffer);
  counter.Count = 0;
  counter.LoadState(buffer);
  CHECK(counter.Count == 42);
}

}  // namespace byte_array_test
