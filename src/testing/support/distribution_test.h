#ifndef ARGOS3_TESTING_SUPPORT_DISTRIBUTION_TEST_H
#define ARGOS3_TESTING_SUPPORT_DISTRIBUTION_TEST_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <functional>
#include <vector>

namespace argos::testing {

/**
 * The Kolmogorov-Smirnov statistic sqrt(n) D: how far the sample strays from a distribution.
 * @param sample  n numbers, in any order.
 * @param cdf     the cumulative distribution, continuous.
 */
Real ComputeKolmogorovSmirnov(std::vector<Real> sample, const std::function<Real(Real)>& cdf);

/**
 * A sample that is from the distribution exceeds this with a probability of one in a million: the
 * limit for large n is P(sqrt(n) D > k) = 2 exp(-2 k^2) (its first term, which suffices here).
 *
 * Source: N. Smirnov, "Table for estimating the goodness of fit of empirical distributions", Annals
 * of Mathematical Statistics 19 (1948).
 */
constexpr Real kOneInAMillion = 2.6932;

/** Cumulative distributions. */
Real UniformCdf(Real x, Real min, Real max);
Real GaussianCdf(Real x, Real mean, Real standardDeviation);
Real RayleighCdf(Real x, Real sigma);

}  // namespace argos::testing

#endif
