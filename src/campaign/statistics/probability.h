#ifndef ARGOS3_CAMPAIGN_STATISTICS_PROBABILITY_H
#define ARGOS3_CAMPAIGN_STATISTICS_PROBABILITY_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/** P(Z <= z) of a standard normal Z, with full relative precision in the lower tail; R: pnorm(z).
 */
Real ComputeNormalLowerTail(Real z);
/** P(Z >= z); R: pnorm(z, lower.tail = FALSE). */
Real ComputeNormalUpperTail(Real z);
/** The z with P(-z <= Z <= z) = level; level in (0,1). R: qnorm((1 + level) / 2). */
Real ComputeCentralNormalQuantile(Real level);

/** P(T <= t) of Student's t with some degrees of freedom > 0; R: pt(t, freedom). */
Real ComputeStudentLowerTail(Real t, Real freedom);
/**
 * The t with P(-t <= T <= t) = level.
 *
 * @param level    in (0,1).
 * @param freedom  degrees of freedom, >= 1.
 * @return R: qt((1 + level) / 2, freedom), relative error about 1e-12.
 * @throws CARGoSException if an argument is out of its range.
 */
Real ComputeCentralStudentQuantile(Real level, Real freedom);

/** P(X >= value) of chi-square; 1 for a value <= 0. R: pchisq(value, freedom, lower.tail = FALSE).
 */
Real ComputeChiSquareUpperTail(Real value, Real freedom);

}  // namespace argos

#endif
