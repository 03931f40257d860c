#ifndef ARGOS3_CAMPAIGN_STATISTICS_RANKS_H
#define ARGOS3_CAMPAIGN_STATISTICS_RANKS_H

#include <argos3/core/utility/datatypes/datatypes.h>

#include <span>
#include <vector>

namespace argos {

/** Ranks of values; tied ones share the mean of their ranks. */
struct SRanking {
  std::vector<Real> Ranks;  // (number of values), from 1, in the order of the values
  Real TieTerm = 0.0;  // sum of t^3 - t over groups of t tied values; 0 without ties
};

/**
 * Values are tied if they are equal to the bit, 0 and -0 included.
 *
 * @param values  without NaN.
 *
 * R: rank(x).
 */
SRanking ComputeRanks(std::span<const Real> values);

}  // namespace argos

#endif
