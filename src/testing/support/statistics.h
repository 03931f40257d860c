#ifndef ARGOS3_TESTING_SUPPORT_STATISTICS_H
#define ARGOS3_TESTING_SUPPORT_STATISTICS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <functional>
#include <vector>

namespace argos {

/** The distribution function of N(0, standardDeviation). */
Real NormalDistribution(Real value, Real standardDeviation);

/**
 * The greatest distance between the distribution of a sample and a distribution function, as a
 * multiple of the distance that independent draws exceed with a probability of 1e-6: at most 1 if
 * the sample has that distribution.
 *
 * Source: F. J. Massey, "The Kolmogorov-Smirnov Test for Goodness of Fit", JASA 46 (1951), with the
 *         bound of Dvoretzky, Kiefer and Wolfowitz, P(D > d) <= 2 exp(-2 n d^2).
 */
Real KolmogorovSmirnovExcess(std::vector<Real> sample,
                             const std::function<Real(Real)>& distribution);
/**
 * Pearson's statistic of counts, as a multiple of the value that it exceeds with a probability of
 * 1e-6 if the probabilities are true: at most 1 if they are.
 *
 * @param probabilities  of each count, all > 0, with sum 1; each expected count must be at least 5.
 *
 * The quantile is that of E. B. Wilson and M. M. Hilferty, "The Distribution
 * of Chi-square", PNAS 17 (1931).
 */
Real ChiSquareExcess(const std::vector<size_t>& counts, const std::vector<Real>& probabilities);

}  // namespace argos

#endif
