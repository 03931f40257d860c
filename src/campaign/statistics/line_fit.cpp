#include <argos3/campaign/statistics/line_fit.h>

#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <algorithm>
#include <cmath>

namespace argos {

SLineFit FitLine(std::span<const Real> x, std::span<const Real> y) {
  RequirePairs(x, y);
  RequireSample(x, 3, "fit of a line, x");
  RequireSample(y, 3, "fit of a line, y");
  const SMoments momentsOfX = ComputeMoments(x);
  if (momentsOfX.StandardDeviation == 0.0) {
    THROW_ARGOSEXCEPTION("fit of a line: all x are " << x[0] << "; two different ones are needed");
  }
  const auto n = static_cast<Real>(x.size());
  const Real scaleOfX = momentsOfX.StandardDeviation;
  const Real meanOfY = ComputeMoments(y).Mean;
  // x is measured in units of its deviation
  Real products = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    products += (x[i] - momentsOfX.Mean) / scaleOfX * (y[i] - meanOfY);
  }
  const Real scaledSlope = products / (n - 1.0);
  Real residuals = 0.0;
  Real total = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    const Real deviation = y[i] - meanOfY;
    const Real residual = deviation - scaledSlope * ((x[i] - momentsOfX.Mean) / scaleOfX);
    residuals += residual * residual;
    total += deviation * deviation;
  }
  SLineFit fit;
  fit.Slope = scaledSlope / scaleOfX;
  fit.Intercept = meanOfY - fit.Slope * momentsOfX.Mean;
  fit.DegreesOfFreedom = x.size() - 2;
  fit.ResidualDeviation = std::sqrt(residuals / (n - 2.0));
  const Real scaledError = fit.ResidualDeviation / std::sqrt(n - 1.0);
  fit.SlopeError = scaledError / scaleOfX;
  fit.InterceptError =
      std::hypot(fit.ResidualDeviation / std::sqrt(n), scaledError * (momentsOfX.Mean / scaleOfX));
  fit.Determination = total > 0.0 ? std::max(0.0, 1.0 - residuals / total) : 1.0;
  return fit;
}

}  // namespace argos
