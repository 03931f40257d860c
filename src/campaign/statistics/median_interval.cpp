#include <argos3/campaign/statistics/median_interval.h>

#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/quantile.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <vector>

namespace argos {

SConfidenceInterval ComputeMedianInterval(std::span<const Real> values, Real level) {
  RequireSample(values, 1, "interval of the median");
  RequireLevel(level);
  const size_t n = values.size();
  // P(x(k + 1) > median) = P(at most k values are below it); a bisection over k >= 1
  const auto outside = [n](size_t k) { return 2.0 * ComputeFairBinomialLowerTail(k - 1, n); };
  size_t lower = 1;
  size_t beyond = n / 2 + 1;
  while (lower + 1 < beyond) {
    const size_t middle = lower + (beyond - lower) / 2;
    (outside(middle) <= 1.0 - level ? lower : beyond) = middle;
  }
  const std::vector<Real> sorted = Sorted(values);
  return {sorted[lower - 1], sorted[n - lower], 1.0 - outside(lower)};
}

}  // namespace argos
