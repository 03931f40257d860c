#ifndef ARGOS3_CAMPAIGN_STATISTICS_P_VALUE_ADJUSTMENT_H
#define ARGOS3_CAMPAIGN_STATISTICS_P_VALUE_ADJUSTMENT_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

/** How p values of several comparisons are adjusted, so that the probability of at least one false
 * finding among all is bounded. */
enum class EPValueAdjustment { None, Holm, Bonferroni };

/**
 * The adjusted p values, in the order of the given ones; empty for none.
 *
 * Holm's are never greater than Bonferroni's, and bound the same probability.
 *
 * @throws CARGoSException if one is NaN or not in [0,1].
 *
 * Source: S. Holm, "A Simple Sequentially Rejective Multiple Test Procedure", Scand. J. Statist. 6
 * (1979). R: p.adjust(p, "holm"), p.adjust(p, "bonferroni").
 */
std::vector<Real> AdjustPValues(std::span<const Real> pValues, EPValueAdjustment adjustment);

}  // namespace argos

#endif
