#ifndef ARGOS3_CAMPAIGN_STATISTICS_BOOTSTRAP_H
#define ARGOS3_CAMPAIGN_STATISTICS_BOOTSTRAP_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

enum class EBootstrapStatistic { Mean, Median };

/**
 * The statistic of samples that are drawn with replacement, each as large as the given one.
 *
 * The same set of values, in any order, and the same seed give the same replicates, on any machine.
 *
 * @param values  at least one.
 * @return ascending; (numResamples).
 * @throws CARGoSException for no values, and those that RequireSample() refuses.
 *
 * Source: B. Efron and R. J. Tibshirani, An Introduction to the Bootstrap (1993), chapter 6.
 */
std::vector<Real> ComputeReplicates(std::span<const Real> values, EBootstrapStatistic statistic,
                                    size_t numResamples, UInt64 seed);

/**
 * The statistic with each value left out in turn.
 *
 * @param values  at least two.
 * @throws CARGoSException for fewer values, and those that RequireSample() refuses.
 *
 * Source: the same book, chapter 11.
 */
std::vector<Real> ComputeJackknife(std::span<const Real> values, EBootstrapStatistic statistic);

}  // namespace argos

#endif
