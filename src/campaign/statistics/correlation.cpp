#include <argos3/campaign/statistics/correlation.h>

#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/ranks.h>
#include <argos3/campaign/statistics/sample_checks.h>
#include <argos3/campaign/statistics/spearman_distribution.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace argos {

namespace {

constexpr size_t kSeriesUpTo = 1290;  // pairs, as R's cor.test()

SMoments ComputeSpread(std::span<const Real> values, std::string_view name) {
  RequireSample(values, 3, name);
  const SMoments moments = ComputeMoments(values);
  if (moments.StandardDeviation == 0.0) {
    THROW_ARGOSEXCEPTION(name << ": all values are " << values[0]
                              << "; two different ones are needed");
  }
  return moments;
}

Real ComputeCoefficient(std::span<const Real> x, std::span<const Real> y) {
  RequirePairs(x, y);
  const SMoments momentsOfX = ComputeSpread(x, "correlation, x");
  const SMoments momentsOfY = ComputeSpread(y, "correlation, y");
  Real sum = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    sum += (x[i] - momentsOfX.Mean) / momentsOfX.StandardDeviation *
           ((y[i] - momentsOfY.Mean) / momentsOfY.StandardDeviation);
  }
  return std::clamp(sum / static_cast<Real>(x.size() - 1), -1.0, 1.0);
}

Real ComputeStudentPValue(Real coefficient, size_t n) {
  const Real rest = (1.0 - coefficient) * (1.0 + coefficient);
  if (rest <= 0.0) {
    return 0.0;
  }
  const auto freedom = static_cast<Real>(n - 2);
  return 2.0 * ComputeStudentLowerTail(-std::abs(coefficient) * std::sqrt(freedom / rest), freedom);
}

}  // namespace

SCorrelation ComputePearsonCorrelation(std::span<const Real> x, std::span<const Real> y) {
  const Real coefficient = ComputeCoefficient(x, y);
  return {coefficient, ComputeStudentPValue(coefficient, x.size())};
}

SCorrelation ComputeSpearmanCorrelation(std::span<const Real> x, std::span<const Real> y) {
  RequirePairs(x, y);
  RequireSample(x, 3, "rank correlation, x");
  RequireSample(y, 3, "rank correlation, y");
  const SRanking ranksOfX = ComputeRanks(x);
  const SRanking ranksOfY = ComputeRanks(y);
  const Real coefficient = ComputeCoefficient(ranksOfX.Ranks, ranksOfY.Ranks);
  if (ranksOfX.TieTerm > 0.0 || ranksOfY.TieTerm > 0.0 || x.size() > kSeriesUpTo) {
    return {coefficient, ComputeStudentPValue(coefficient, x.size())};
  }
  Real distance = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    const Real difference = ranksOfX.Ranks[i] - ranksOfY.Ranks[i];
    distance += difference * difference;
  }
  // the distribution is symmetric
  const auto n = static_cast<Real>(x.size());
  const Real greatest = n * (n * n - 1.0) / 3.0;
  const Real tail = ComputeSpearmanUpperTail(std::max(distance, greatest - distance), x.size());
  return {coefficient, std::min(1.0, 2.0 * tail)};
}

}  // namespace argos
