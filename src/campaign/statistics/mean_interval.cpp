#include <argos3/campaign/statistics/mean_interval.h>

#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <cmath>

namespace argos {

SConfidenceInterval ComputeMeanInterval(std::span<const Real> values, Real level) {
  RequireSample(values, 2, "interval of the mean");
  const SMoments moments = ComputeMoments(values);
  const Real halfWidth = ComputeMeanHalfWidth(values.size(), moments.StandardDeviation, level);
  return {moments.Mean - halfWidth, moments.Mean + halfWidth, level};
}

Real ComputeMeanHalfWidth(size_t count, Real standardDeviation, Real level) {
  const auto n = static_cast<Real>(count);
  return ComputeCentralStudentQuantile(level, n - 1.0) * standardDeviation / std::sqrt(n);
}

}  // namespace argos
