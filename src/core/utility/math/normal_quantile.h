#ifndef ARGOS3_CORE_UTILITY_MATH_NORMAL_QUANTILE_H
#define ARGOS3_CORE_UTILITY_MATH_NORMAL_QUANTILE_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * Inverts the cumulative distribution of the standard normal distribution.
 *
 * @param excess  what the probability exceeds 1/2 by, in (-1/2,1/2). This form keeps both tails
 * equally accurate: the result is odd in it.
 * @return the value below which a share of 1/2 + excess lies; relative error about 1e-16.
 *
 * Source: M. J. Wichura, "Algorithm AS 241: the percentage points of the normal distribution",
 * Applied Statistics 37 (1988), 477-484, routine PPND16.
 */
Real ComputeNormalQuantile(Real excess);

}  // namespace argos

#endif
