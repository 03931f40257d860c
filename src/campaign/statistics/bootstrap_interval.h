#ifndef ARGOS3_CAMPAIGN_STATISTICS_BOOTSTRAP_INTERVAL_H
#define ARGOS3_CAMPAIGN_STATISTICS_BOOTSTRAP_INTERVAL_H

#include <argos3/campaign/statistics/bootstrap.h>
#include <argos3/campaign/statistics/confidence_interval.h>

#include <span>

namespace argos {

struct SBootstrapOptions {
  EBootstrapStatistic Statistic = EBootstrapStatistic::Mean;
  Real Level = 0.95;  // level of confidence, in (0,1)
  size_t NumResamples = 9999;  // is at least 2 / (1 - Level) - 1, so that no bound is an extreme
  UInt64 Seed = 1;
};

/**
 * Percentile interval: quantiles of the replicates.
 *
 * @param values  at least two.
 * @throws CARGoSException for fewer values, those that RequireSample() refuses, a level out of
 * range, and too few resamples for it.
 *
 * Source: A. C. Davison and D. V. Hinkley, Bootstrap Methods and their Application (1997), section
 * 5.3.1, with the interpolation (5.8). R: boot::boot.ci(type = "perc").
 */
SConfidenceInterval ComputePercentileInterval(std::span<const Real> values,
                                              const SBootstrapOptions& options = {});

/**
 * BCa interval: percentiles corrected for bias and for a variance that changes with the
 * statistic (acceleration, from the jackknife). Equal values give an interval of width 0. Both
 * intervals cover less than the level if the values are few: 0.85 instead of 0.9 for the mean of 20
 * exponential ones.
 *
 * Replicates equal to the estimate, frequent for medians, count half as below it.
 *
 * Arguments and exceptions are those of ComputePercentileInterval().
 *
 * Source: B. Efron and R. J. Tibshirani, An Introduction to the Bootstrap (1993), section 14.3;
 * quantiles as above. R: boot::boot.ci(type = "bca", L = mean(j) - j), j being the jackknife.
 */
SConfidenceInterval ComputeBcaInterval(std::span<const Real> values,
                                       const SBootstrapOptions& options = {});

/** The percentile interval of given replicates, ascending. R: boot:::perc.ci(replicates, level). */
SConfidenceInterval ComputeReplicatesInterval(std::span<const Real> replicates, Real level);

/** The BCa interval of given replicates, ascending. */
SConfidenceInterval ComputeBcaReplicatesInterval(Real estimate, std::span<const Real> replicates,
                                                 std::span<const Real> jackknife, Real level);

}  // namespace argos

#endif
