#include <argos3/testing/support/statistics.h>

#include <algorithm>
#include <cmath>

namespace argos {

Real NormalDistribution(Real value, Real standardDeviation) {
  return 0.5 * std::erfc(-value / (standardDeviation * std::sqrt(2.0)));
}

Real KolmogorovSmirnovExcess(std::vector<Real> sample,
                             const std::function<Real(Real)>& distribution) {
  constexpr Real kProbability = 1e-6;
  std::sort(sample.begin(), sample.end());
  const auto n = static_cast<Real>(sample.size());
  Real distance = 0.0;
  for (size_t i = 0; i < sample.size(); ++i) {
    const Real expected = distribution(sample[i]);
    const auto below = static_cast<Real>(i);
    distance = std::max({distance, expected - below / n, (below + 1.0) / n - expected});
  }
  return distance / std::sqrt(std::log(2.0 / kProbability) / (2.0 * n));
}

}  // namespace argos
