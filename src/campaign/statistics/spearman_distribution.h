#ifndef ARGOS3_CAMPAIGN_STATISTICS_SPEARMAN_DISTRIBUTION_H
#define ARGOS3_CAMPAIGN_STATISTICS_SPEARMAN_DISTRIBUTION_H

#include <argos3/core/utility/datatypes/datatypes.h>

namespace argos {

/**
 * P(D >= d) of the sum D of squared differences between two independent orders of n values.
 *
 * @param distance  even; others count as the next even one.
 * @param n         at least 2. Exact up to 9 by enumeration; an Edgeworth series beyond, with an
 * error below 0.0004 (AS 89).
 */
Real ComputeSpearmanUpperTail(Real distance, size_t n);

}  // namespace argos

#endif
