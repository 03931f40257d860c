#ifndef ARGOS3_CAMPAIGN_STATISTICS_MOMENTS_H
#define ARGOS3_CAMPAIGN_STATISTICS_MOMENTS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>

namespace argos {

/** Mean and standard deviation of a sample. */
struct SMoments {
  Real Mean;
  Real StandardDeviation;  // has the divisor n - 1; NaN for one value, exactly 0 for equal values
};

/**
 * Two passes over values that are scaled by a power of two, so that nothing underflows.
 *
 * @throws CARGoSException for no values, or values that RequireSample() refuses.
 *
 * R: mean(x), sd(x).
 */
SMoments ComputeMoments(std::span<const Real> values);

}  // namespace argos

#endif
