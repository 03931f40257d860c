#include <argos3/plugins/robots/generic/simulator/number_sort.h>

#include <argos3/core/utility/math/random_stream.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <vector>

using namespace argos;

TEST_CASE("number sort: equals std::sort for few and for many numbers", "[robots]") {
  CRandomStream random(1, "test", "number sort", "");
  for (size_t size = 0; size < 300; ++size) {
    std::set<UInt64> different;
    while (different.size() < size) {
      // near both ends of the range, and across the sign bit of signed numbers
      const auto number = static_cast<UInt64>(random.Uniform(0.0, 1e6));
      different.insert(size % 2 == 0 ? number : number << 44);
    }
    std::vector<UInt64> numbers(different.begin(), different.end());
    for (size_t i = numbers.size(); i > 1; --i) {
      std::swap(numbers[i - 1], numbers[static_cast<size_t>(random.Uniform(0.0, 1.0) * i)]);
    }
    SortNumbers(numbers);
    CHECK(std::equal(numbers.begin(), numbers.end(), different.begin(), different.end()));
  }
}
