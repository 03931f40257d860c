#ifndef ARGOS3_TESTING_SUPPORT_STATISTICS_H
#define ARGOS3_TESTING_SUPPORT_STATISTICS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <functional>
#include <vector>

namespace argos {

/** The cumulative distribution function of N(0, standardDeviation). */
Real NormalDistribution(Real value, Real standardDeviation);

/**
 * The greatest distance between the distribution of a sample and a distribution function, as a
 * multiple of the distance that independent draws exceed with a probability of 1e-6: at most 1 if
 * the sample comes from that distribution.
 *
 * Source: F. J. Massey, "The Kolmogorov-Smirnov Test for Goodness of Fit", JASA 46 (1951), with the
 *         bound of Dvoretzky, Kiefer and Wolfowitz, P(D > d) <= 2 exp(-2 n d^2).
 */
Real KolmogorovSmirnovExcess(std::vector<Real> sample,
                             const std::function<Real(Real)>& distribution);

/**
 * Pearson's statistic of some counts, as a multiple of the value that it exceeds with a probability
 * of 1e-6 if the probabilities are right: then it is at most 1.
 *
 * @param probabilities  of each count, all > 0; they add up to 1, and the expected value of each
 * count is at least 5.
 */
Real ChiSquareExcess(const std::vector<size_t>& counts, const std::vector<Real>& probabilities);

}  // namespace argos

#endif
