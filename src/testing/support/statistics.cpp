#include <argos3/testing/support/statistics.h>

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace argos {

namespace {

constexpr Real kProbability = 1e-6;  // of a statistic beyond its bound

}  // namespace

Real NormalDistribution(Real value, Real standardDeviation) {
  return gsl_cdf_gaussian_P(value, standardDeviation);
}

Real KolmogorovSmirnovExcess(std::vector<Real> sample,
                             const std::function<Real(Real)>& distribution) {
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

Real ChiSquareExcess(const std::vector<size_t>& counts, const std::vector<Real>& probabilities) {
  const auto total = static_cast<Real>(std::accumulate(counts.begin(), counts.end(), size_t(0)));
  Real statistic = 0.0;
  for (size_t i = 0; i < counts.size(); ++i) {
    const Real expected = total * probabilities[i];
    const Real difference = static_cast<Real>(counts[i]) - expected;
    statistic += difference * difference / expected;
  }
  const auto freedom = static_cast<Real>(counts.size() - 1);
  return statistic / gsl_cdf_chisq_Qinv(kProbability, freedom);
}

}  // namespace argos
