#include <argos3/campaign/statistics/bootstrap_interval.h>

#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/quantile.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/normal_quantile.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace argos {

namespace {

Real ComputeZ(Real probability) {
  return ComputeNormalQuantile(probability - 0.5);
}

// interpolates between order statistics on the scale of normal quantiles
Real Interpolate(std::span<const Real> replicates, Real probability) {
  const auto intervals = static_cast<Real>(replicates.size() + 1);
  const Real position = intervals * probability;
  if (position <= 1.0) {
    return replicates.front();
  }
  if (position >= intervals - 1.0) {
    return replicates.back();
  }
  const Real below = std::floor(position);
  const auto index = static_cast<size_t>(below) - 1;
  if (position == below) {
    return replicates[index];
  }
  const Real z = ComputeZ(below / intervals);
  const Real share = (ComputeZ(probability) - z) / (ComputeZ((below + 1.0) / intervals) - z);
  return replicates[index] + share * (replicates[index + 1] - replicates[index]);
}

// a sixth of the skewness of the jackknife
Real ComputeAcceleration(std::span<const Real> jackknife) {
  const Real mean = ComputeMoments(jackknife).Mean;
  Real greatest = 0.0;
  for (const Real estimate : jackknife) {
    greatest = std::max(greatest, std::abs(mean - estimate));
  }
  if (greatest == 0.0) {
    return 0.0;
  }
  Real squares = 0.0;
  Real cubes = 0.0;
  for (const Real estimate : jackknife) {
    const Real influence = (mean - estimate) / greatest;
    squares += influence * influence;
    cubes += influence * influence * influence;
  }
  return cubes / (6.0 * std::pow(squares, 1.5));
}

// the normal quantile of the share of replicates below the estimate
Real ComputeBias(Real estimate, std::span<const Real> replicates) {
  const auto [first, last] = std::equal_range(replicates.begin(), replicates.end(), estimate);
  const auto n = static_cast<Real>(replicates.size());
  const auto below = static_cast<Real>(first - replicates.begin());
  const Real share = (below + 0.5 * static_cast<Real>(last - first)) / n;
  // finite also if all replicates are on one side
  return ComputeZ(std::clamp(share, 0.5 / n, 1.0 - 0.5 / n));
}

void RequireOptions(std::span<const Real> values, const SBootstrapOptions& options) {
  RequireSample(values, 2, "bootstrap");
  RequireLevel(options.Level);
  // a little less than 1 for roundings: 39 resamples are enough for 0.95
  const Real outside = static_cast<Real>(options.NumResamples + 1) * 0.5 * (1.0 - options.Level);
  if (outside < 1.0 - 1e-9) {
    THROW_ARGOSEXCEPTION("bootstrap: number of resamples "
                         << options.NumResamples << "; at least "
                         << std::ceil(2.0 / (1.0 - options.Level) - 1e-6) - 1.0
                         << " are needed for level " << options.Level);
  }
}

Real ComputeEstimate(std::span<const Real> values, EBootstrapStatistic statistic) {
  const std::vector<Real> sorted = Sorted(values);
  if (statistic == EBootstrapStatistic::Median) {
    return ComputeMedian(sorted);
  }
  // the sum of the replicates, so that equal samples have equal means
  return std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<Real>(sorted.size());
}

}  // namespace

SConfidenceInterval ComputeReplicatesInterval(std::span<const Real> replicates, Real level) {
  RequireSample(replicates, 2, "replicates");
  RequireLevel(level);
  const Real tail = 0.5 * (1.0 - level);
  return {Interpolate(replicates, tail), Interpolate(replicates, 1.0 - tail), level};
}

SConfidenceInterval ComputeBcaReplicatesInterval(Real estimate, std::span<const Real> replicates,
                                                 std::span<const Real> jackknife, Real level) {
  RequireSample(replicates, 2, "replicates");
  RequireSample(jackknife, 2, "jackknife");
  const Real z = ComputeCentralNormalQuantile(level);
  const Real bias = ComputeBias(estimate, replicates);
  const Real acceleration = ComputeAcceleration(jackknife);
  const auto bound = [&](Real quantile) {
    const Real shifted = bias + quantile;
    const Real scale = 1.0 - acceleration * shifted;
    // the correction has a pole; beyond it lies the extreme
    if (scale <= 0.0) {
      return shifted > 0.0 ? replicates.back() : replicates.front();
    }
    return Interpolate(replicates, ComputeNormalLowerTail(bias + shifted / scale));
  };
  return {bound(-z), bound(z), level};
}

SConfidenceInterval ComputePercentileInterval(std::span<const Real> values,
                                              const SBootstrapOptions& options) {
  RequireOptions(values, options);
  return ComputeReplicatesInterval(
      ComputeReplicates(values, options.Statistic, options.NumResamples, options.Seed),
      options.Level);
}

SConfidenceInterval ComputeBcaInterval(std::span<const Real> values,
                                       const SBootstrapOptions& options) {
  RequireOptions(values, options);
  return ComputeBcaReplicatesInterval(
      ComputeEstimate(values, options.Statistic),
      ComputeReplicates(values, options.Statistic, options.NumResamples, options.Seed),
      ComputeJackknife(values, options.Statistic), options.Level);
}

}  // namespace argos
