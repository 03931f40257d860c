#include <argos3/campaign/statistics/proportion_interval.h>

#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <cmath>

namespace argos {

SConfidenceInterval ComputeProportionInterval(size_t successes, size_t trials, Real level) {
  RequireLevel(level);
  if (trials == 0 || successes > trials) {
    THROW_ARGOSEXCEPTION("interval of a proportion: " << successes << " successes in " << trials
                                                      << " trials; at least one trial, and no more "
                                                         "successes than trials are needed");
  }
  const auto n = static_cast<Real>(trials);
  const Real z = ComputeCentralNormalQuantile(level);
  const Real share = static_cast<Real>(successes) / n;
  const Real centre = share + z * z / (2.0 * n);
  const Real halfWidth = z * std::sqrt(share * (1.0 - share) / n + z * z / (4.0 * n * n));
  const Real scale = 1.0 + z * z / n;
  // exactly 0 and 1 at the ends, which roundings would miss
  return {successes == 0 ? 0.0 : (centre - halfWidth) / scale,
          successes == trials ? 1.0 : (centre + halfWidth) / scale, level};
}

}  // namespace argos
