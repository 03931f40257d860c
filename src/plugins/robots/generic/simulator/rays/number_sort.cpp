#include <argos3/plugins/robots/generic/simulator/number_sort.h>

#include <argos3/core/utility/math/vectorized.h>

#include <algorithm>
#include <cstddef>

namespace argos {

namespace {

constexpr size_t kLanes = 8;
constexpr size_t kMaxNumbers = 128;  // beyond, std::sort() takes less time

// Counts for each number how many are less; size is a multiple of kLanes.
ARGOS_VECTORIZED
void ComputeRanks(const UInt64* numbers, size_t size, UInt64* ranks) {
  for (size_t first = 0; first < size; first += kLanes) {
    UInt64 numLess[kLanes] = {};
    for (size_t other = 0; other < size; ++other) {
      ARGOS_VECTOR_LOOP
      for (size_t i = 0; i < kLanes; ++i) {
        numLess[i] += numbers[other] < numbers[first + i] ? 1 : 0;
      }
    }
    std::copy_n(numLess, kLanes, ranks + first);
  }
}

}  // namespace

void SortNumbers(std::vector<UInt64>& numbers) {
  if (numbers.size() > kMaxNumbers) {
    std::sort(numbers.begin(), numbers.end());
    return;
  }
  UInt64 unsorted[kMaxNumbers];
  UInt64 ranks[kMaxNumbers];
  const size_t size = (numbers.size() + kLanes - 1) / kLanes * kLanes;
  std::copy(numbers.begin(), numbers.end(), unsorted);
  // what fills the last vector is less than no number
  std::fill(unsorted + numbers.size(), unsorted + size, ~UInt64(0));
  ComputeRanks(unsorted, size, ranks);
  for (size_t i = 0, end = numbers.size(); i < end; ++i) {
    numbers[ranks[i]] = unsorted[i];
  }
}

}  // namespace argos
