#include <argos3/campaign/design/latin_hypercube.h>

#include <argos3/core/utility/math/random_stream.h>

#include <numeric>
#include <utility>

namespace argos {

std::vector<UInt32> DrawPermutation(UInt32 count, CRandomStream& random) {
  std::vector<UInt32> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  // Fisher and Yates
  for (UInt32 i = count; i > 1; --i) {
    std::swap(numbers[i - 1], numbers[random.UniformInteger(UInt64{i})]);
  }
  return numbers;
}

std::vector<UInt32> DrawBalancedLevels(UInt32 samples, UInt32 levels, CRandomStream& random) {
  // the levels that occur once more are random, too
  const std::vector<UInt32> order = DrawPermutation(levels, random);
  std::vector<UInt32> drawn = DrawPermutation(samples, random);
  for (UInt32& index : drawn) {
    index = order[index % levels];
  }
  return drawn;
}

std::vector<Real> DrawPlacesInStrata(UInt32 samples, CRandomStream& random) {
  std::vector<Real> places(samples);
  for (UInt32 i = 0; i < samples; ++i) {
    places[i] = (i + random.Uniform01()) / samples;
  }
  return places;
}

}  // namespace argos
