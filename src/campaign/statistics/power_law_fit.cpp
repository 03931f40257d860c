#include <argos3/campaign/statistics/power_law_fit.h>

#include <argos3/campaign/statistics/line_fit.h>
#include <argos3/campaign/statistics/moments.h>
#include <argos3/campaign/statistics/probability.h>
#include <argos3/campaign/statistics/sample_checks.h>

#include <argos3/core/utility/errors/argos_exception.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace argos {

namespace {

std::vector<Real> ComputeLogarithms(std::span<const Real> values, std::string_view name) {
  std::vector<Real> logarithms;
  for (size_t i = 0; i < values.size(); ++i) {
    if (values[i] <= 0.0) {
      THROW_ARGOSEXCEPTION("fit of a power law, " << name << ": value " << i + 1 << " is "
                                                  << values[i] << "; positive ones are needed");
    }
    logarithms.push_back(std::log(values[i]));
  }
  return logarithms;
}

}  // namespace

SPowerLawFit FitPowerLaw(std::span<const Real> x, std::span<const Real> y, Real level) {
  RequirePairs(x, y);
  RequireSample(x, 3, "fit of a power law, x");
  RequireSample(y, 3, "fit of a power law, y");
  RequireLevel(level);
  const SLineFit line = FitLine(ComputeLogarithms(x, "x"), ComputeLogarithms(y, "y"));
  const Real halfWidth = line.SlopeError * ComputeCentralStudentQuantile(
                                               level, static_cast<Real>(line.DegreesOfFreedom));
  return {line.Slope,
          line.SlopeError,
          std::exp(line.Intercept),
          line.Determination,
          {line.Slope - halfWidth, line.Slope + halfWidth, level}};
}

SPowerLawFit FitPowerLawOfMeans(std::span<const SPowerLawSample> samples, Real level) {
  RequireLevel(level);
  std::vector<Real> x;
  std::vector<Real> means;
  std::vector<Real> variances;  // variances of the means' logarithms
  for (const SPowerLawSample& sample : samples) {
    RequireSample(sample.Y, 2, "fit of a power law, y");
    const SMoments moments = ComputeMoments(sample.Y);
    const Real relative = moments.StandardDeviation / moments.Mean;
    x.push_back(sample.X);
    means.push_back(moments.Mean);
    variances.push_back(relative * relative / static_cast<Real>(sample.Y.size()));
  }
  RequireSample(x, 2, "fit of a power law, x");
  const std::vector<Real> logX = ComputeLogarithms(x, "x");
  const std::vector<Real> logY = ComputeLogarithms(means, "means");
  const Real centerX = ComputeMoments(logX).Mean;
  const Real centerY = ComputeMoments(logY).Mean;
  Real squares = 0.0;
  Real products = 0.0;
  Real squaresY = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    squares += (logX[i] - centerX) * (logX[i] - centerX);
    products += (logX[i] - centerX) * (logY[i] - centerY);
    squaresY += (logY[i] - centerY) * (logY[i] - centerY);
  }
  if (!(squares > 0.0)) {
    THROW_ARGOSEXCEPTION("fit of a power law: all x are " << x.front());
  }
  Real variance = 0.0;  // variance of the slope
  Real spread = 0.0;
  for (size_t i = 0; i < x.size(); ++i) {
    const Real weight = (logX[i] - centerX) / squares;
    const Real part = weight * weight * variances[i];
    variance += part;
    spread += part * part / static_cast<Real>(samples[i].Y.size() - 1);
  }
  const Real slope = products / squares;
  const Real error = std::sqrt(variance);
  const Real halfWidth =
      spread > 0.0 ? error * ComputeCentralStudentQuantile(level, variance * variance / spread)
                   : 0.0;
  return {slope,
          error,
          std::exp(centerY - slope * centerX),
          squaresY > 0.0 ? slope * products / squaresY : 1.0,
          {slope - halfWidth, slope + halfWidth, level}};
}

}  // namespace argos
