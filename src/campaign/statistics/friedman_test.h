#ifndef ARGOS3_CAMPAIGN_STATISTICS_FRIEDMAN_TEST_H
#define ARGOS3_CAMPAIGN_STATISTICS_FRIEDMAN_TEST_H

#include <argos3/campaign/statistics/chi_square_result.h>

#include <span>
#include <vector>

namespace argos {

/**
 * Friedman's test of the hypothesis that treatments do not differ, where each block (a seed, an
 * arena) has one value of each treatment; with the correction for ties. If all values within each
 * block are equal, the statistic is 0 and the p value 1 (R: NaN).
 *
 * @param blocks  at least two, with one value for each of the same two or more treatments.
 * @throws CARGoSException for too few blocks or treatments, blocks of different lengths, and
 * values that RequireSample() refuses.
 *
 * Source: M. Hollander and D. A. Wolfe, Nonparametric Statistical Methods, 2nd ed. (1999),
 * section 7.1. R: friedman.test(matrix), one row a block.
 */
SChiSquareResult TestFriedman(std::span<const std::vector<Real>> blocks);

}  // namespace argos

#endif
