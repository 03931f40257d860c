#ifndef ARGOS3_CAMPAIGN_STATISTICS_POWER_LAW_FIT_H
#define ARGOS3_CAMPAIGN_STATISTICS_POWER_LAW_FIT_H

#include <argos3/campaign/statistics/confidence_interval.h>

#include <span>
#include <vector>

namespace argos {

/** A power law y = Factor x^Exponent, by least squares in log-log coordinates. */
struct SPowerLawFit {
  Real Exponent;
  Real ExponentError;  // standard error
  Real Factor;
  Real Determination;  // R^2 of the logarithms
  SConfidenceInterval ExponentInterval;  // is computed by Student's t
};

/**
 * Fits a scaling law, such as time against number of robots.
 *
 * @param x,y    at least three pairs of positive values; not all x equal.
 * @param level  of confidence, in (0,1).
 * @throws CARGoSException for fewer pairs, samples of different lengths, values that are not
 * positive, equal x, a level out of range, and values that RequireSample() refuses.
 *
 * R: confint(lm(log(y) ~ log(x)), level = level).
 */
SPowerLawFit FitPowerLaw(std::span<const Real> x, std::span<const Real> y, Real level = 0.95);

/** Repeated measurements at one x. */
struct SPowerLawSample {
  Real X;
  std::vector<Real> Y;  // have any sign, and a positive mean
};

/**
 * Fits a scaling law to means, for measurements that may be 0, which have no logarithm. Least
 * squares of the logarithms of the means, all with the same weight.
 *
 * The interval comes from the deviations within the samples: to first order the variance of the
 * logarithm of a mean m of n values is s^2 / (n m^2), and the slope is a weighted sum of these
 * logarithms. Degrees of freedom are those of Welch and Satterthwaite. Unlike that of FitPowerLaw()
 * the interval does not become wider if the means do not follow a power law.
 * Source: G. W. Oehlert, "A Note on the Delta Method", The American Statistician 46 (1992); F. E.
 * Satterthwaite, "An Approximate Distribution of Estimates of Variance Components", Biometrics
 * Bulletin 2 (1946).
 *
 * @param samples  at least two, with different x > 0, each with at least two values.
 * @throws CARGoSException for fewer samples or values, x or means that are not positive, equal x,
 * a level out of range, and values that RequireSample() refuses.
 */
SPowerLawFit FitPowerLawOfMeans(std::span<const SPowerLawSample> samples, Real level = 0.95);

}  // namespace argos

#endif
