#ifndef ARGOS3_CAMPAIGN_STATISTICS_CORRELATION_H
#define ARGOS3_CAMPAIGN_STATISTICS_CORRELATION_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>

namespace argos {

/** A correlation and the test of the hypothesis that there is none. */
struct SCorrelation {
  Real Coefficient;  // in [-1,1]
  Real PValue;  // of two sides
};

/**
 * Pearson's linear correlation, with Student's t test.
 *
 * @param x,y  at least three pairs; neither all x nor all y equal.
 * @throws CARGoSException for fewer pairs, samples of different lengths, equal x or y, and values
 * that RequireSample() refuses.
 *
 * R: cor.test(x, y).
 */
SCorrelation ComputePearsonCorrelation(std::span<const Real> x, std::span<const Real> y);

/**
 * Spearman's rank correlation: Pearson's of the ranks, where ties share ranks.
 *
 * The p value is exact up to 9 pairs without ties, from an Edgeworth series up to 1290 pairs, and
 * from Student's t for more or with ties, as in R.
 *
 * Arguments and exceptions are those of ComputePearsonCorrelation().
 *
 * Source of the series: D. J. Best and D. E. Roberts, "Algorithm AS 89: the upper tail
 * probabilities of Spearman's rho", Applied Statistics 24 (1975), in the form of R's pRho.
 * R: cor.test(x, y, method = "spearman").
 */
SCorrelation ComputeSpearmanCorrelation(std::span<const Real> x, std::span<const Real> y);

}  // namespace argos

#endif
