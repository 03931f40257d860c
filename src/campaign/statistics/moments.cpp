#include <argos3/campaign/statistics/moments.h>

#include <argos3/campaign/statistics/sample_checks.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

SMoments ComputeMoments(std::span<const Real> values) {
  RequireSample(values, 1, "moments");
  const auto n = static_cast<Real>(values.size());
  const auto [min, max] = std::minmax_element(values.begin(), values.end());
  if (*min == *max) {
    return {*min, values.size() > 1 ? 0.0 : std::numeric_limits<Real>::quiet_NaN()};
  }
  const int exponent = std::ilogb(std::max(std::abs(*min), std::abs(*max)));
  Real sum = 0.0;
  for (const Real value : values) {
    sum += std::scalbn(value, -exponent);
  }
  const Real mean = sum / n;
  Real squares = 0.0;
  Real residue = 0.0;  // rounding of the mean
  for (const Real value : values) {
    const Real deviation = std::scalbn(value, -exponent) - mean;
    squares += deviation * deviation;
    residue += deviation;
  }
  const Real variance = std::max(0.0, squares - residue * residue / n) / (n - 1.0);
  return {std::scalbn(mean + residue / n, exponent), std::scalbn(std::sqrt(variance), exponent)};
}

}  // namespace argos
