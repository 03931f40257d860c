#ifndef ARGOS3_CAMPAIGN_STATISTICS_LINE_FIT_H
#define ARGOS3_CAMPAIGN_STATISTICS_LINE_FIT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>

namespace argos {

/** A least-squares line y = Intercept + Slope x. */
struct SLineFit {
  Real Slope;
  Real Intercept;
  Real SlopeError;  // standard errors
  Real InterceptError;
  Real ResidualDeviation;  // has n - 2 degrees of freedom
  Real Determination;  // R^2; 1 if all y are equal and so is the line
  size_t DegreesOfFreedom;  // n - 2
};

/**
 * Fits a line by least squares; the errors suppose independent deviations of one variance.
 *
 * @param x,y  at least three pairs; not all x equal.
 * @throws CARGoSException for fewer pairs, samples of different lengths, equal x, and values that
 * RequireSample() refuses.
 *
 * Source: N. R. Draper and H. Smith, Applied Regression Analysis, 3rd ed. (1998), chapter 1.
 * R: summary(lm(y ~ x)).
 */
SLineFit FitLine(std::span<const Real> x, std::span<const Real> y);

}  // namespace argos

#endif
