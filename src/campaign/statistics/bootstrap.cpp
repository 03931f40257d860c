#include <argos3/campaign/statistics/bootstrap.h>

#include <argos3/campaign/statistics/quantile.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/math/random_stream.h>

#include <algorithm>
#include <numeric>

namespace argos {

namespace {

Real ComputeMean(std::span<const Real> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<Real>(values.size());
}

// changes the order of the values
Real TakeMedian(std::vector<Real>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.size() % 2 == 1 ? *middle
                                : 0.5 * (*std::max_element(values.begin(), middle) + *middle);
}

}  // namespace

std::vector<Real> ComputeReplicates(std::span<const Real> values, EBootstrapStatistic statistic,
                                    size_t numResamples, UInt64 seed) {
  RequireSample(values, 1, "bootstrap");
  const std::vector<Real> sorted = Sorted(values);
  CRandomStream stream(seed, "campaign", "statistics", "bootstrap");
  std::vector<Real> resample(sorted.size());
  std::vector<Real> replicates;
  replicates.reserve(numResamples);
  for (size_t i = 0; i < numResamples; ++i) {
    for (Real& value : resample) {
      value = sorted[stream.UniformInteger(static_cast<UInt64>(sorted.size()))];
    }
    replicates.push_back(statistic == EBootstrapStatistic::Mean ? ComputeMean(resample)
                                                                : TakeMedian(resample));
  }
  std::sort(replicates.begin(), replicates.end());
  return replicates;
}

std::vector<Real> ComputeJackknife(std::span<const Real> values, EBootstrapStatistic statistic) {
  RequireSample(values, 2, "jackknife");
  const std::vector<Real> sorted = Sorted(values);
  const size_t rest = sorted.size() - 1;
  const Real mean = ComputeMean(sorted);
  std::vector<Real> estimates;
  for (size_t omitted = 0; omitted < sorted.size(); ++omitted) {
    if (statistic == EBootstrapStatistic::Mean) {
      estimates.push_back(mean + (mean - sorted[omitted]) / static_cast<Real>(rest));
      continue;
    }
    const auto at = [&](size_t i) { return sorted[i < omitted ? i : i + 1]; };
    estimates.push_back(rest % 2 == 1 ? at(rest / 2) : 0.5 * (at(rest / 2 - 1) + at(rest / 2)));
  }
  return estimates;
}

}  // namespace argos
