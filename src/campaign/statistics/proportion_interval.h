#ifndef ARGOS3_CAMPAIGN_STATISTICS_PROPORTION_INTERVAL_H
#define ARGOS3_CAMPAIGN_STATISTICS_PROPORTION_INTERVAL_H

#include <argos3/campaign/statistics/confidence_interval.h>

namespace argos {

/**
 * Wilson's score interval of a probability, for success and failure rates; always inside [0,1].
 *
 * @param successes  at most trials.
 * @param trials     at least 1.
 * @param level      of confidence, in (0,1).
 * @throws CARGoSException for an argument out of its range.
 *
 * Source: E. B. Wilson, "Probable Inference, the Law of Succession, and Statistical Inference",
 * JASA 22 (1927); recommended by L. D. Brown, T. T. Cai and A. DasGupta, "Interval Estimation for
 * a Binomial Proportion", Statistical Science 16 (2001).
 * R: prop.test(successes, trials, conf.level = level, correct = FALSE)$conf.int.
 */
SConfidenceInterval ComputeProportionInterval(size_t successes, size_t trials, Real level = 0.95);

}  // namespace argos

#endif
