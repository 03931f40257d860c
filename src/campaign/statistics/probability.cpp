#include <argos3/campaign/statistics/probability.h>

#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>
#include <argos3/core/utility/math/normal_quantile.h>

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <cmath>
#include <numbers>

namespace argos {

namespace {

constexpr Real kRelativeError = 1e-14;  // error of a quantile

}  // namespace

Real ComputeNormalLowerTail(Real z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

Real ComputeNormalUpperTail(Real z) {
  return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

Real ComputeCentralNormalQuantile(Real level) {
  RequireLevel(level);
  return ComputeNormalQuantile(0.5 * level);
}

Real ComputeStudentLowerTail(Real t, Real freedom) {
  return gsl_cdf_tdist_P(t, freedom);
}

Real ComputeCentralStudentQuantile(Real level, Real freedom) {
  RequireLevel(level);
  if (!(freedom >= 1.0)) {
    THROW_ARGOSEXCEPTION("degrees of freedom of Student's t " << freedom
                                                              << "; at least 1 is needed");
  }
  // GSL's inverse does not converge for all arguments. The upper tail is convex and the normal
  // quantile is below this one, so Newton's steps approach it from below.
  const Real tail = 0.5 * (1.0 - level);
  Real t = ComputeCentralNormalQuantile(level);
  while (true) {
    const Real step = (gsl_cdf_tdist_Q(t, freedom) - tail) / gsl_ran_tdist_pdf(t, freedom);
    if (!(step > kRelativeError * t)) {
      return t;
    }
    t += step;
  }
}

Real ComputeChiSquareUpperTail(Real value, Real freedom) {
  return value > 0.0 ? gsl_cdf_chisq_Q(value, freedom) : 1.0;
}

}  // namespace argos
