#include <argos3/campaign/statistics/rank_interval.h>

#include <argos3/campaign/statistics/probability.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace argos {

namespace {

// between the point of index skipped and that with as many behind it
SConfidenceInterval MakeInterval(const CPairwisePoints& points, size_t skipped,
                                 EAlternative alternative, Real level) {
  constexpr Real kUnbounded = std::numeric_limits<Real>::infinity();
  SConfidenceInterval interval{-kUnbounded, kUnbounded, level};
  if (alternative != EAlternative::Less) {
    interval.Lower = points.Select(skipped);
  }
  if (alternative != EAlternative::Greater) {
    interval.Upper = points.Select(points.GetCount() - 1 - skipped);
  }
  return interval;
}

}  // namespace

SConfidenceInterval ComputeExactRankInterval(const CPairwisePoints& points,
                                             const CRankDistribution& distribution,
                                             EAlternative alternative, Real level) {
  const Real tails = alternative == EAlternative::TwoSided ? 2.0 : 1.0;
  const size_t quantile = distribution.ComputeQuantile((1.0 - level) / tails);
  const size_t skipped = std::max<size_t>(quantile, 1) - 1;
  const Real achieved = 1.0 - tails * distribution.ComputeLowerTail(skipped);
  return MakeInterval(points, skipped, alternative, achieved);
}

SConfidenceInterval ComputeNormalRankInterval(const CPairwisePoints& points, Real deviation,
                                              EAlternative alternative, Real level) {
  // the level of two sides whose upper tail is that of the sides asked for
  const Real tails = alternative == EAlternative::TwoSided ? 2.0 : 1.0;
  const Real tail = (1.0 - level) / tails;
  Real z = 0.0;
  if (tail != 0.5) {
    z = std::copysign(ComputeCentralNormalQuantile(std::abs(1.0 - 2.0 * tail)), 0.5 - tail);
  }
  const Real centre = 0.5 * static_cast<Real>(points.GetCount());
  // the statistic exceeds its mean by centre - k behind k points
  const Real skipped = std::floor(centre - 0.5 - z * deviation);
  if (skipped < 0.0) {
    const Real outside = tails * ComputeNormalUpperTail((centre - 0.5) / deviation);
    return MakeInterval(points, 0, alternative, 1.0 - outside);
  }
  const auto last = static_cast<Real>(points.GetCount() - 1);
  return MakeInterval(points, static_cast<size_t>(std::min(skipped, last)), alternative, level);
}

}  // namespace argos
