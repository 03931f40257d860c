#include <argos3/core/utility/datatypes/datatypes.h>
#include <argos3/core/utility/memory/huge_pages.h>

#include <catch2/catch.hpp>

#include <numeric>
#include <vector>

namespace huge_pages_test {

using namespace argos;

TEST_CASE("huge pages: a vector keeps its elements when it grows", "[core][memory]") {
  // below and above the size from which memory is in huge pages, 4 MiB
  const size_t size = GENERATE(10U, 100000U, 3000000U);
  CAPTURE(size);
  std::vector<UInt64> numbers(size);
  std::iota(numbers.begin(), numbers.end(), UInt64(5));
  const size_t before = numbers.capacity();
  ReserveInHugePages(numbers, before + 1);
  CHECK(numbers.capacity() >= before + before / 2);
  REQUIRE(numbers.size() == size);
  bool areEqual = true;
  for (size_t i = 0; i < size; ++i) {
    areEqual = areEqual && numbers[i] == i + 5;
  }
  CHECK(areEqual);
  // enough capacity: nothing moves
  const UInt64* const data = numbers.data();
  ReserveInHugePages(numbers, before + 1);
  CHECK(numbers.data() == data);
  // writable up to the end
  numbers.resize(numbers.capacity(), 1);
  CHECK(numbers.back() == (numbers.size() > size ? 1 : size + 4));
}

}  // namespace huge_pages_test
