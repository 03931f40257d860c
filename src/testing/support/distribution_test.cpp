#include <argos3/testing/support/distribution_test.h>

#include <algorithm>
#include <cmath>

namespace argos::testing {

Real ComputeKolmogorovSmirnov(std::vector<Real> sample, const std::function<Real(Real)>& cdf) {
  std::sort(sample.begin(), sample.end());
  const Real size = static_cast<Real>(sample.size());
  Real farthest = 0.0;
  for (size_t i = 0; i < sample.size(); ++i) {
    const Real expected = cdf(sample[i]);
    // the sample's own distribution steps from i / n to (i + 1) / n here
    farthest = std::max({farthest, expected - static_cast<Real>(i) / size,
                         static_cast<Real>(i + 1) / size - expected});
  }
  return std::sqrt(size) * farthest;
}

Real UniformCdf(Real x, Real min, Real max) {
  return std::clamp((x - min) / (max - min), 0.0, 1.0);
}

Real GaussianCdf(Real x, Real mean, Real standardDeviation) {
  return 0.5 * std::erfc((mean - x) / (standardDeviation * std::sqrt(2.0)));
}

Real RayleighCdf(Real x, Real sigma) {
  return x <= 0.0 ? 0.0 : 1.0 - std::exp(-x * x / (2.0 * sigma * sigma));
}

}  // namespace argos::testing
