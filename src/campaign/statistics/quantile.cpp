#include <argos3/campaign/statistics/quantile.h>

#include <argos3/campaign/statistics/sample_checks.h>

#include <algorithm>
#include <cmath>

namespace argos {

std::vector<Real> Sorted(std::span<const Real> values) {
  std::vector<Real> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

Real ComputeQuantile(std::span<const Real> sorted, Real probability) {
  RequireSample(sorted, 1, "quantile");
  RequireProbability(probability, "probability of a quantile");
  const Real position = probability * static_cast<Real>(sorted.size() - 1);
  const auto below = static_cast<size_t>(position);
  const Real share = position - std::floor(position);
  if (share == 0.0) {
    return sorted[below];
  }
  return (1.0 - share) * sorted[below] + share * sorted[below + 1];
}

Real ComputeMedian(std::span<const Real> sorted) {
  RequireSample(sorted, 1, "median");
  const size_t half = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[half] : 0.5 * (sorted[half - 1] + sorted[half]);
}

}  // namespace argos
