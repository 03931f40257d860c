#ifndef ARGOS3_CAMPAIGN_STATISTICS_MEAN_INTERVAL_H
#define ARGOS3_CAMPAIGN_STATISTICS_MEAN_INTERVAL_H

#include <argos3/campaign/statistics/confidence_interval.h>

#include <span>

namespace argos {

/**
 * Student's t interval of the mean: mean -+ t(n - 1, level) sd / sqrt(n).
 *
 * Exact for normal values. Equal values give an interval of width 0.
 *
 * @param level  of confidence, in (0,1).
 * @throws CARGoSException for fewer than two values, values that RequireSample() refuses, or a
 * level out of range.
 *
 * R: t.test(x, conf.level = level)$conf.int.
 */
SConfidenceInterval ComputeMeanInterval(std::span<const Real> values, Real level = 0.95);

/** Half the width of that interval for count >= 2 values of a standard deviation. */
Real ComputeMeanHalfWidth(size_t count, Real standardDeviation, Real level);

}  // namespace argos

#endif
